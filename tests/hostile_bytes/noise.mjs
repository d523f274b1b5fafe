// Feeds the generated JavaScript with random and damaged bytes: node noise.mjs GENERATED DEVICE INPUTS [SEED].
// Bytes give a value or a CodecError, and a framer keeps no more than a frame; anything else ends with the exit code 1.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [generated, device, inputs, seed = "1"] = process.argv.slice(2);
const LONGEST = 1100;

/** Random numbers that are the same in every run: xorshift32. */
let state = Number(seed) * 2654435761 >>> 0 || 1;
function below(limit) {
  state ^= state << 13;
  state ^= state >>> 17;
  state ^= state << 5;
  return (state >>> 0) % limit;
}

const exports = await import(pathToFileURL(`${generated}/js/${device}/index.js`));
const vectors = JSON.parse(readFileSync(`${generated}/vectors/${device}.json`, "utf8")).vectors;
const frames = vectors.map((vector) => new Uint8Array(Buffer.from(vector.right, "hex")));

const targets = [];

/** A value is printed and encoded again, which may be refused like the bytes. */
function whole(entry, bytes) {
  const value = entry.decode(bytes);
  String(JSON.stringify(value, (_, inner) => (typeof inner === "bigint" ? String(inner) : inner)));
  entry.encode(value);
}

function add(name, entry) {
  if (typeof entry?.decode === "function") targets.push([name, (bytes) => whole(entry, bytes)]);
  if (typeof entry?.decodeRequest === "function") {
    for (const message of [undefined, ...entry.messages]) {
      targets.push([`${name} request`, (bytes) => entry.decodeRequest(bytes, message)]);
      targets.push([`${name} response`, (bytes) => entry.decodeResponse(bytes, message)]);
    }
  } else if (typeof entry === "object" && entry !== null && typeof entry[Symbol.iterator] === "function") {
    for (const inner of entry) if (typeof inner?.decode === "function") add(`${name} ${inner.name}`, inner);
  } else if (entry?.parameters !== undefined) {
    for (const inner of Object.values(entry.parameters).flat()) add(`${name} ${inner.name}`, inner);
  }
  if (name.endsWith("Framer")) {
    const framer = entry();
    let sent = 0;
    let taken = 0;
    const count = (received) => received.forEach((frame) => (taken += frame.length));
    targets.push([
      name,
      (bytes) => {
        count(framer.feed(bytes));
        if (framer.bytes.length > framer.shape.longest) throw new Error("more bytes are waiting than a frame has");
        if (below(16) === 0) count(framer.idle());
        sent += bytes.length;
        if (taken + framer.dropped + framer.bytes.length !== sent) throw new Error("bytes are lost");
      },
    ]);
  }
}
for (const [name, entry] of Object.entries(exports)) add(name, entry);

function noise() {
  if (below(4) === 0 || frames.length === 0) {
    const bytes = new Uint8Array(below(8) ? below(40) : below(LONGEST));
    for (let at = 0; at < bytes.length; at++) bytes[at] = below(256);
    return bytes;
  }
  let bytes = frames[below(frames.length)].slice();
  for (let times = below(4); times > 0; times--) {
    if (bytes.length === 0) break;
    const at = below(bytes.length);
    const kind = below(4);
    if (kind === 0) bytes[at] ^= 1 << below(8);
    if (kind === 1) bytes[at] = [0, 1, 127, 128, 255][below(5)];
    if (kind === 2) bytes = bytes.slice(0, at);
    if (kind === 3) bytes = new Uint8Array([...bytes.slice(0, at), ...frames[below(frames.length)]]);
  }
  return bytes;
}

let refused = 0;
let before = 0;
for (let number = 0; number < Number(inputs); number++) {
  const [name, target] = targets[below(targets.length)];
  const bytes = noise();
  try {
    target(bytes);
  } catch (error) {
    if (error.name !== "CodecError") {
      console.log(`${device}: ${name}: ${Buffer.from(bytes).toString("hex")}: ${error.stack}`);
      process.exit(1);
    }
    refused++;
  }
  if (number === Math.floor(Number(inputs) / 2)) {
    globalThis.gc?.();
    before = process.memoryUsage().heapUsed;
  }
}
globalThis.gc?.();
const grown = globalThis.gc ? process.memoryUsage().heapUsed - before : 0;
console.log(JSON.stringify({ device, targets: targets.length, inputs: Number(inputs), refused, grown }));
if (grown > 8 * 1024 * 1024) process.exit(1);
