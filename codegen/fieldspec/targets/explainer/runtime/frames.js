import { checksumBytes } from "../checksums.js";
import { wholeBounds } from "../number_bits.js";
import { bytesOfHex, latinOf } from "./texts.js";

const HEX_CHARACTERS = new Set(Array.from("0123456789ABCDEFabcdef", (char) => char.charCodeAt(0)));

/** How many bytes of its preamble a frame has, or should have at least. */
function leadOf(preamble, frame) {
  if (preamble === undefined) return 0;
  const other = frame.findIndex((byte) => byte !== preamble.byte);
  return Math.max(preamble.least, Math.min(other < 0 ? frame.length : other, preamble.most));
}

/**
 * A frame of a link without its delimiters, which are `marks`, and its encoding. `start` and `end` are the bytes in the
 * places of the delimiters, `start` with the `lead` bytes of a preamble before it, `data` the bytes of the parts, and `surplus` what is left between them and the end. The rest of the frame
 * cannot be read if the reason is `not_hex`; `whole` is then false.
 */
export function unwrapped(link, direction, frame) {
  const marks = link.delimiters[direction];
  const lead = leadOf(link.preamble, frame);
  const start = lead ? frame.subarray(0, lead + marks[0].length) : markOf(frame, marks[0], link.transmission);
  const after = frame.subarray(start.length);
  const end = markOf(after.toReversed(), marks[1].toReversed(), link.transmission).toReversed();
  const inner = frame.subarray(start.length, frame.length - end.length);
  if (link.transmission === "binary") {
    return { link, marks, lead, frame, start, data: inner, surplus: inner.subarray(inner.length), reason: "", end, whole: true };
  }
  const bad = inner.findIndex((byte) => !HEX_CHARACTERS.has(byte));
  const good = bad < 0 ? inner.length : bad;
  const pairs = good - (good % 2);
  const reason = good < inner.length ? "not_hex" : pairs < good ? "wrong_length" : "";
  const data = bytesOfHex(latinOf(inner.subarray(0, pairs)));
  return { link, marks, lead, frame, start, data, surplus: inner.subarray(pairs), reason, end, whole: reason !== "not_hex" };
}

/** The bytes in the place of a delimiter: the delimiter itself, or bytes that can be nothing else. */
function markOf(frame, mark, encoding) {
  const place = frame.subarray(0, mark.length);
  if (encoding === "binary" || (place.length === mark.length && mark.every((byte, at) => byte === place[at]))) return place;
  const at = place.findIndex((byte) => HEX_CHARACTERS.has(byte));
  return frame.subarray(0, at < 0 ? mark.length : at);
}

/** Where a part is if all parts together have `length` bytes. */
export function partOffset(part, length) {
  return part.offset >= 0 ? part.offset : length + part.offset;
}

/** The bytes of the parts that `part` covers or is. Bounds are those of a slice: negative ones count from the end. */
export function sliceOf(data, start, stop) {
  const bound = (at) => Math.max(0, at < 0 ? data.length + at : Math.min(at, data.length));
  const [first, last] = [bound(start), stop === undefined ? data.length : bound(stop)];
  return data.subarray(first, Math.max(first, last));
}

/** The bytes of a checksum over its part of all parts. */
export function checksumOf(part, data) {
  const covered = sliceOf(data, part.start ?? 0, part.stop);
  return Uint8Array.from(checksumBytes(part, covered, 0, covered.length));
}

/** The value of a length part if all parts together have `length` bytes; undefined if it cannot express that. */
export function lengthNumber(part, length) {
  const units = (length - (part.base ?? 0)) / (part.unitSize ?? 1);
  const [low, high] = typeBounds(part.value);
  return Number.isInteger(units) && low <= units && units <= high ? units : undefined;
}

/** The least and the greatest whole number of a value's type; bigints for more than six bytes. */
export function typeBounds({ kind, size, signed, digits, low: least, high: most }) {
  if (digits) return [least, most];
  switch (kind) {
    case "boolean": return [0, 1];
    case "integer": return wholeBounds(8 * size, signed).map((bound) => (size > 6 ? bound : Number(bound)));
    default: throw new RangeError(`no whole number has the kind ${kind}`);
  }
}

/** The original bytes, each with the place of the byte that is sent for it. Throws CodecError with the place of a wrong one. */
export function originalPlaces(escape, data) {
  const places = [];
  escape.bytes.walk(data, (byte, at) => places.push([byte, at]));
  return places;
}

/** The bytes of the parts that a CAN frame has in its identifier. */
export function identifierSize({ fields }) {
  return fields.reduce((sum, [own]) => sum + own, 0);
}
