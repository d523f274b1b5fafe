import { digitsBytes, digitsNumber } from "./digit_texts.js";
import { CodecError } from "./error.js";

const FORMS = { __proto__: null, "0123456789": "decimal", "0123456789ABCDEF": "upper_hex", "0123456789abcdef": "lower_hex" };

/** The form of digits that are characters, each of `known`, with `bits` of a number in two's complement, else 0. */
const formOf = (size, known, places, hasSign, bits, isLowFirst) => ({ digits: FORMS[known], size, places, hasSign, bits, isLowFirst });

/** The number of digits, a bigint where it is `wide`. Throws CodecError for what are none; `detail` says what they are. */
function numberOfDigits(name, form, digits, detail, offset, wide) {
  const number = digitsNumber(form, digits);
  if (number === undefined) throw new CodecError("unknown_value", `${name} is not ${detail}`, offset);
  return wide ? BigInt(number) : Number(number);
}

/**
 * The number of digits that are characters: `known` are the characters that they may be, `places` of them follow a
 * point, a sign comes first where the number is `signed`, and the digits of the lowest byte where they are `isLowFirst`. Throws CodecError for anything else.
 */
export function digitsOf(name, bytes, offset, wide, size, known, places, signed, bits, isLowFirst = false) {
  const detail = `${size - (signed ? 1 : 0) - (places ? 1 : 0)} digits`;
  const form = formOf(size, known, places, signed, bits, isLowFirst);
  return numberOfDigits(name, form, bytes.subarray(offset, offset + size), detail, offset, wide);
}

/** Writes a number, whose digits fit, as characters. */
export function putDigits(number, bytes, offset, ...form) {
  bytes.set(digitsBytes(formOf(...form), number), offset);
}

/**
 * The number of decimal digits with blanks in place of leading zeros, `places` of them after a point, and `-` below zero
 * where the number is `signed`. Throws CodecError for anything else.
 */
export function blankDigitsOf(name, bytes, offset, size, places, signed, wide) {
  const form = { digits: "decimal", hasBlanks: true, places, signed };
  return numberOfDigits(name, form, bytes.subarray(offset, offset + size), "a number after blanks", offset, wide);
}

/** Writes a number, whose digits fit, with blanks in place of leading zeros. */
export function putBlankDigits(number, bytes, offset, size, places) {
  bytes.set(digitsBytes({ digits: "decimal", hasBlanks: true, size, places }, number), offset);
}

/** The number of a codec in `size` bytes, a bigint where it is `wide`. Throws CodecError for bytes that are none. */
export function codedNumberOf(name, bytes, offset, wide, size, form) {
  return numberOfDigits(name, form, bytes.slice(offset, offset + size), "a number of its codec", offset, wide);
}

/** Writes a number that a codec has. */
export function putCodedNumber(number, bytes, offset, form) {
  bytes.set(digitsBytes(form, number), offset);
}

/** The number of two decimal digits in each of some bytes, the first one first. Throws CodecError for other bytes. */
export function bcdOf(name, bytes, offset, wide, signed = false, digits = "bcd") {
  return numberOfDigits(name, { digits, signed }, bytes, `${2 * bytes.length} digits`, offset, wide);
}

/** Writes a number, whose digits fit, with two decimal digits in each byte; `places` are those of the bytes. */
export function putBcd(number, bytes, places, signed = false, digits = "bcd") {
  digitsBytes({ digits, signed, size: places.length }, number).forEach((byte, at) => (bytes[places[at]] = byte));
}
