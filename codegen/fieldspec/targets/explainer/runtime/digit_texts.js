import { exactWhole } from "./number_bits.js";

const DIGIT_PATTERNS = { decimal: /^[0-9]+$/, upper_hex: /^[0-9A-F]+$/, lower_hex: /^[0-9a-f]+$/, bcd: /^[0-9]+$/, packed_decimal: /^[0-9]+$/ };
const LAST_NIBBLES = { true: { c: 1n, d: -1n }, false: { f: 1n } };

const hasNibbles = ({ digits }) => digits === "bcd" || digits === "packed_decimal";

/** Hexadecimal digits with those of the lowest byte first, or back. */
const turned = (text) => text.match(/../g).reverse().join("");

const isHexadecimal = ({ digits }) => digits === "upper_hex" || digits === "lower_hex";

/** The number of digits, the most significant digit first; undefined for anything but such digits. */
export function digitsNumber(value, bytes) {
  if (value.codec) return numberOfCodec(value, value.codec.decode(bytes));
  if (hasNibbles(value)) return numberOfNibbles(value, Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join(""));
  let text = String.fromCharCode(...bytes);
  if (value.hasBlanks) return numberBehindBlanks(value, text);
  const sign = value.hasSign ? text[0] : "";
  if (value.hasSign && sign !== "+" && sign !== "-") return undefined;
  if (value.hasSign) text = text.slice(1);
  if (value.places) {
    const point = text.length - value.places - 1;
    if (text[point] !== ".") return undefined;
    text = text.slice(0, point) + text.slice(point + 1);
  }
  if (!DIGIT_PATTERNS[value.digits].test(text)) return undefined;
  const whole = BigInt(isHexadecimal(value) ? `0x${value.isLowFirst ? turned(text) : text}` : text);
  return exactWhole(value.bits ? BigInt.asIntN(value.bits, whole) : sign === "-" ? -whole : whole);
}

/** What a codec has read, without the sign of a zero; undefined for what is no number of it. */
const numberOfCodec = ({ low, high }, number) => (Number.isInteger(number) && low <= number && number <= high ? number + 0 : undefined);

/** The number of decimal digits, of which the first or the last one may be a sign; undefined for anything else. */
function numberOfNibbles({ digits, signed }, text) {
  let [rest, sign] = [text, 1n];
  if (digits === "packed_decimal") [rest, sign] = [text.slice(0, -1), LAST_NIBBLES[Boolean(signed)][text.at(-1)]];
  else if (signed && text[0] === "f") [rest, sign] = [text.slice(1), -1n];
  return sign !== undefined && DIGIT_PATTERNS.bcd.test(rest) ? exactWhole(sign * BigInt(rest)) : undefined;
}

function nibblesOf({ digits, size, signed }, whole) {
  const text = (whole < 0n ? -whole : whole).toString();
  if (digits === "packed_decimal") return text.padStart(2 * size - 1, "0") + (!signed ? "f" : whole < 0n ? "d" : "c");
  return whole < 0n ? `f${text.padStart(2 * size - 1, "0")}` : text.padStart(2 * size, "0");
}

/** The number of ` -1.25`, whose first digit is a zero only before the point; undefined for anything else. */
function numberBehindBlanks({ places = 0, signed }, text) {
  const [, sign, whole, fraction = ""] = /^ *(-?)(0|[1-9][0-9]*)(?:\.([0-9]+))?$/.exec(text) ?? [];
  if (whole === undefined || fraction.length !== places || (sign && !signed)) return undefined;
  const number = BigInt(whole + fraction);
  return exactWhole(sign ? -number : number);
}

/** The bytes of the digits of a number, the most significant digit first. */
export function digitsBytes(value, number) {
  if (value.codec) return Uint8Array.from(value.codec.encode(Number(number)));
  const whole = value.bits ? BigInt.asUintN(value.bits, BigInt(number)) : BigInt(number);
  if (hasNibbles(value)) return Uint8Array.from(nibblesOf(value, whole).match(/../g), (pair) => parseInt(pair, 16));
  const count = value.size - (value.hasSign ? 1 : 0) - (value.places ? 1 : 0);
  const least = value.hasBlanks ? (value.places ?? 0) + 1 : count;
  let text = (whole < 0n ? -whole : whole).toString(isHexadecimal(value) ? 16 : 10).padStart(least, "0");
  if (value.digits === "upper_hex") text = text.toUpperCase();
  if (value.isLowFirst) text = turned(text);
  if (value.places) text = `${text.slice(0, -value.places)}.${text.slice(-value.places)}`;
  if (value.hasSign) text = (whole < 0n ? "-" : "+") + text;
  if (value.hasBlanks) text = (whole < 0n ? `-${text}` : text).padStart(value.size, " ");
  return Uint8Array.from(text, (character) => character.charCodeAt(0));
}
