import { CodecError } from "./error.js";

/** A number as a number, or as a bigint where it is `wide`. */
const sized = (number, wide) => (wide ? number : Number(number));

/** The number that stands for the same bits with a sign; `bits` is 0 for one without. */
const withSign = (number, bits) => (bits ? BigInt.asIntN(bits, number) : number);

/**
 * The number of digits that are characters: `known` are the characters that they may be, `places` of them follow a
 * point, and a sign comes first where the number is `signed`. Throws CodecError for anything else.
 */
export function digitsOf(name, bytes, offset, size, known, places, signed, bits, wide) {
  const text = String.fromCharCode(...bytes.subarray(offset, offset + size));
  const sign = signed ? text[0] : "";
  let digits = signed ? text.slice(1) : text;
  const point = digits.length - places - 1;
  const isPointed = !places || digits[point] === ".";
  if (places) digits = digits.slice(0, point) + digits.slice(point + 1);
  if (!isPointed || (signed && sign !== "+" && sign !== "-") || ![...digits].every((digit) => known.includes(digit))) {
    throw new CodecError("unknown_value", `${name} is not ${digits.length} digits`, offset);
  }
  const number = withSign(BigInt(known.length > 10 ? `0x${digits}` : digits), bits);
  return sized(sign === "-" ? -number : number, wide);
}

/** Writes a number, whose digits fit, as characters. */
export function putDigits(number, bytes, offset, size, known, places, signed, bits) {
  const unsigned = bits ? BigInt.asUintN(bits, BigInt(number)) : BigInt(number);
  const count = size - (signed ? 1 : 0) - (places ? 1 : 0);
  let digits = (unsigned < 0n ? -unsigned : unsigned).toString(known.length).padStart(count, "0");
  if (known.includes("F")) digits = digits.toUpperCase();
  if (places) digits = `${digits.slice(0, -places)}.${digits.slice(-places)}`;
  const text = (signed ? (unsigned < 0n ? "-" : "+") : "") + digits;
  for (let at = 0; at < size; at++) bytes[offset + at] = text.charCodeAt(at);
}

/**
 * The number of decimal digits with blanks in place of leading zeros, `places` of them behind a point, and `-` below zero
 * where the number is `signed`. Throws CodecError for anything else.
 */
export function blankDigitsOf(name, bytes, offset, size, places, signed, wide) {
  const text = String.fromCharCode(...bytes.subarray(offset, offset + size));
  const [, sign, whole, fraction = ""] = /^ *(-?)(0|[1-9][0-9]*)(?:\.([0-9]+))?$/.exec(text) ?? [];
  if (whole === undefined || fraction.length !== places || (sign && !signed)) {
    throw new CodecError("unknown_value", `${name} is not a number behind blanks`, offset);
  }
  const number = BigInt(whole + fraction);
  return sized(sign ? -number : number, wide);
}

/** Writes a number, whose digits fit, with blanks in place of leading zeros. */
export function putBlankDigits(number, bytes, offset, size, places) {
  const whole = BigInt(number);
  let text = (whole < 0n ? -whole : whole).toString().padStart(places + 1, "0");
  if (places) text = `${text.slice(0, -places)}.${text.slice(-places)}`;
  text = (whole < 0n ? `-${text}` : text).padStart(size, " ");
  for (let at = 0; at < size; at++) bytes[offset + at] = text.charCodeAt(at);
}

/** The number of two decimal digits in each of some bytes, the first one first. Throws CodecError for other bytes. */
export function bcdOf(name, bytes, offset, wide) {
  const digits = Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  if (/[a-f]/.test(digits)) throw new CodecError("unknown_value", `${name} is not ${digits.length} digits`, offset);
  return sized(BigInt(digits), wide);
}

/** Writes a number, whose digits fit, with two decimal digits in each byte; `places` are those of the bytes. */
export function putBcd(number, bytes, places) {
  const digits = String(number).padStart(2 * places.length, "0");
  places.forEach((place, at) => (bytes[place] = parseInt(digits.slice(2 * at, 2 * at + 2), 16)));
}
