import { checksumBytes } from "../checksums.js";
import { wholeBounds } from "../number_bits.js";

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
  const [low, high] = part.width ? [0, 2 ** part.width - 1] : typeBounds(part.value);
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
