import { decodedText, textBytes, textFault } from "./encodings.js";
import { CodecError, printed, refusedList, wrongType } from "./error.js";
import { exceedsReal, realBits, realOfBits, wholeOfBits } from "./number_bits.js";

/** The floating-point number of 32 bits, given as a whole number. */
export function floatOf(bits) {
  return realOfBits(bits, 4);
}

/** The floating-point number of 64 bits, given as a bigint. */
export function doubleOf(bits) {
  return realOfBits(bits, 8);
}

/**
 * The 16 bits of a number. Throws CodecError for what is not a number, for a finite number that would become infinite, and
 * for one that is neither in `ranges` nor among `others`; without ranges any number is allowed.
 */
export function halfBitsOf(name, value, ranges, others) {
  return checkedBits(name, value, ranges, others, 2);
}

/** The 32 bits of a number. Throws CodecError like `halfBitsOf`. */
export function bitsOf(name, value, ranges, others) {
  return checkedBits(name, value, ranges, others, 4);
}

/** The 64 bits of a number, as a bigint. Throws CodecError like `halfBitsOf`. */
export function doubleBitsOf(name, value, ranges, others) {
  return checkedBits(name, value, ranges, others, 8);
}

function checkedBits(name, value, ranges, others, size) {
  if (typeof value !== "number") throw wrongType(name, value, "a number");
  if (ranges !== null && !within(ranges, value) && !others.some((other) => Object.is(other, value) || other === value)) {
    throw new CodecError("out_of_range", `${name} is ${value}, not in ${rangesText(ranges)}`);
  }
  if (exceedsReal(value, size)) throw new CodecError("out_of_range", `${name} is ${value}, which ${8 * size} bits do not hold`);
  return realBits(value, size);
}

/** Whether a number is in one of some intervals. */
export function within(ranges, value) {
  for (const [low, high] of ranges) if (value >= low && value <= high) return true;
  return false;
}

/** Intervals as a spec writes them: `0..127, 200`. */
export function rangesText(ranges) {
  return ranges.map(([low, high]) => (low === high ? `${low}` : `${low}..${high}`)).join(", ");
}

/** A boolean that was received as a number. Throws CodecError for anything but 0 and 1. */
export function booleanOf(name, number, offset) {
  if (number > 1) throw new CodecError("unknown_value", `${name} is ${number}, neither 0 nor 1`, offset);
  return number === 1;
}

/** The number of a boolean. Throws CodecError for anything else. */
export function numberOf(name, value) {
  if (value === true) return 1;
  if (value === false) return 0;
  throw wrongType(name, value, "a boolean");
}

/** The text of bytes that zeros fill up. Throws CodecError for bytes that are not ASCII. */
export function textOf(name, bytes, offset, size) {
  let end = offset + size;
  for (let at = offset; at < end; at++) {
    if (bytes[at] > 127) throw new CodecError("unknown_value", `${name} has bytes that are not ASCII`, offset);
  }
  while (end > offset && bytes[end - 1] === 0) end--;
  let text = "";
  for (let at = offset; at < end; at++) text += String.fromCharCode(bytes[at]);
  return text;
}

/** Writes a text and fills it up with zeros. Throws CodecError for one that is too long, not ASCII, or has a zero. */
export function putText(name, value, bytes, offset, size) {
  if (typeof value !== "string") throw wrongType(name, value, "a text");
  if (value.length > size) throw new CodecError("wrong_length", `${name} has ${size} bytes, not ${value.length}`);
  for (let at = 0; at < size; at++) {
    const code = at < value.length ? value.charCodeAt(at) : 0;
    if (code > 127) throw new CodecError("unknown_value", `${name} has characters that are not ASCII`);
    if (code === 0 && at < value.length) throw new CodecError("unknown_value", `${name} has a zero, which ends a text`);
    bytes[offset + at] = code;
  }
}

/** The text of bytes in a form of its own. Throws CodecError for bytes that are none. */
export function encodedTextOf(name, bytes, offset, size, form) {
  const text = decodedText(form, bytes.subarray(offset, offset + size), form.little);
  if (text === null) throw new CodecError("unknown_value", `${name} has bytes that are not a text of its form`, offset);
  return text;
}

/** Writes a text in a form of its own. Throws CodecError for one that the form does not have, or that is too long. */
export function putEncodedText(name, value, bytes, offset, size, form) {
  if (typeof value !== "string") throw wrongType(name, value, "a text");
  const fault = textFault(form, size, value);
  if (fault !== null) throw new CodecError(fault[0], `${name} ${fault[1]}`);
  bytes.set(textBytes(form, size, value, form.little), offset);
}

/** Throws CodecError unless there are exactly `size` bytes. */
export function checkExact(name, bytes, size) {
  if (bytes.length === size) return;
  const reason = bytes.length < size ? "incomplete" : "wrong_length";
  throw new CodecError(reason, `${name} has ${size} bytes, not ${bytes.length}`, Math.min(bytes.length, size));
}

/** Writes `size` bytes, or from the `least` on. Throws CodecError for a wrong number of them. */
export function putBytes(name, value, bytes, offset, size, least = size) {
  if (!(value instanceof Uint8Array)) throw wrongType(name, value, "a Uint8Array");
  if (value.length < least || value.length > size) throw new CodecError("wrong_length", `${name} has ${size} bytes, not ${value.length}`);
  bytes.set(value, offset);
}

/** A number of `bits` bits with a sign, given without. */
export function signed48(number, bits) {
  return wholeOfBits(number, bits, true);
}

/** Throws CodecError for what is not a list of `least` to `most` elements. */
export function checkList(name, value, least, most) {
  if (!Array.isArray(value) || value.length < least || value.length > most) throw refusedList(name, value, least, most);
}

/** The number of elements for which there is room before a list is checked: none for what is not a list, `most` at the most. */
export function listLength(value, key, most) {
  const list = value?.[key];
  return Array.isArray(list) ? Math.min(list.length, most) : 0;
}

/** What a word begins as without a number. Throws CodecError where what has to be given is left out. */
export function initialWord(name, bits, initial, needed) {
  for (const [key, reason, keys] of needed) {
    if (!keys.some((other) => Object.hasOwn(bits, other))) {
      throw new CodecError("missing_value", `${key} of ${name} is not given, and its ${reason}`);
    }
  }
  return initial;
}

/** The number that bits of a word are: the first one and the number of each run, the least significant run first. */
export function bitsNumber(runs, raw, signed) {
  let [number, weight] = [0n, 0];
  for (const [first, width] of runs) {
    number |= BigInt.asUintN(width, BigInt(raw) >> BigInt(first)) << BigInt(weight);
    weight += width;
  }
  return signed ? BigInt.asIntN(weight, number) : number;
}

/** A word with some of its bits set as an object says. Throws CodecError for unknown bits and wrong values. */
export function setBits(name, places, bits, raw, size) {
  let word = BigInt(raw);
  for (const [key, value] of Object.entries(bits)) {
    const place = places[key];
    if (place === undefined) throw new CodecError("unknown_field", `${name} has no bit ${printed(key)}`);
    const [first, width, signed, runs] = place;
    const low = signed ? -(2 ** (width - 1)) : 0;
    const high = signed ? 2 ** (width - 1) - 1 : 2 ** width - 1;
    const number = width === 1 && typeof value === "boolean" ? Number(value) : value;
    if (!Number.isInteger(number) || number < low || number > high) {
      throw new CodecError("out_of_range", `${key} is ${printed(value)}, not in ${low}..${high}`);
    }
    let rest = BigInt(number);
    for (const [at, bitCount] of runs ?? [[first, width]]) {
      word = (word & ~(((1n << BigInt(bitCount)) - 1n) << BigInt(at))) | (BigInt.asUintN(bitCount, rest) << BigInt(at));
      rest >>= BigInt(bitCount);
    }
  }
  return typeof raw === "bigint" ? word : Number(BigInt.asUintN(size, word));
}
