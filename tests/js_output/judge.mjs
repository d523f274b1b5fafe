// Runs the frames of a file through generated modules and prints what they make of them, one JSON a line.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { judge } from "./judging.mjs";

const modules = new Map();

async function load(path) {
  if (!modules.has(path)) modules.set(path, await import(pathToFileURL(path)));
  return modules.get(path);
}

for (const line of readFileSync(process.argv[2], "utf8").split("\n")) {
  if (!line) continue;
  const job = JSON.parse(line);
  const result = judge(await load(job.module), job);
  console.log(JSON.stringify({ id: job.id, ...result }));
}
