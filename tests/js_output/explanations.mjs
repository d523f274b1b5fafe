// Explains the frames and logs of a file by generated modules, one JSON a line: a list of explanations for each job.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

function portable(key, value) {
  return typeof value === "bigint" ? { $n: String(value) } : value;
}

for (const line of readFileSync(process.argv[2], "utf8").split("\n")) {
  if (!line) continue;
  const { module, frame, text, log, options, request } = JSON.parse(line);
  const { explain, explainLog } = await import(pathToFileURL(module));
  if (request) options.request = new Uint8Array(Buffer.from(request, "hex"));
  let results;
  try {
    results = log === undefined
      ? [explain(text ?? new Uint8Array(Buffer.from(frame, "hex")), options)]
      : [...explainLog(log, options)];
  } catch (error) {
    if (!["Unreadable", "RangeError"].includes(error.name)) throw new Error(`${frame ?? text}: ${error.stack}`);
    results = [{ error: error.message }];
  }
  console.log(JSON.stringify(results, portable));
}
