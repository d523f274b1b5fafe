// Cuts streams with the framers of a generated module: node framer_judge.mjs MODULE STREAMS
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const exports = await import(pathToFileURL(process.argv[2]));
const streams = JSON.parse(readFileSync(process.argv[3], "utf8"));
const hex = (bytes) => Buffer.from(bytes).toString("hex");

/** The frames that each piece completes; null is a silence. */
function cut({ framer, pieces }) {
  const make = exports[framer];
  if (make === undefined) return null;
  const own = make();
  const frames = pieces.map((piece) => (piece === null ? own.idle() : own.feed(new Uint8Array(Buffer.from(piece, "hex")))).map(hex));
  return { frames, dropped: own.dropped };
}

console.log(JSON.stringify(streams.map(cut)));
