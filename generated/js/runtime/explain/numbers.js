import { roundedReal } from "../number_bits.js";

/** Whether a raw value is a whole number; truth values are. A floating-point number is one by its value alone. */
export function isWhole(number) {
  return typeof number === "bigint" || typeof number === "boolean" || Number.isInteger(number);
}

/** An exact decimal number, coefficient * 10 ** exponent, of a text without an exponent. */
export function decimalOf(text) {
  const [whole, places = ""] = text.split(".");
  return { coefficient: BigInt(whole + places), exponent: -places.length };
}

/** The exact sum of two decimal numbers, with the places of the one that has more. */
export function decimalSum(left, right) {
  const exponent = Math.min(left.exponent, right.exponent);
  const at = (decimal) => decimal.coefficient * 10n ** BigInt(decimal.exponent - exponent);
  return { coefficient: at(left) + at(right), exponent };
}

/** A decimal number with at most so many digits, of two equally near ones the even one. */
export function decimalRounded({ coefficient, exponent }, digits) {
  const negative = coefficient < 0n;
  const size = negative ? -coefficient : coefficient;
  const surplus = size.toString().length - digits;
  if (surplus <= 0) return { coefficient, exponent };
  const unit = 10n ** BigInt(surplus);
  let whole = size / unit;
  const twice = 2n * (size % unit);
  if (twice > unit || (twice === unit && whole % 2n === 1n)) whole += 1n;
  const rounded = { coefficient: negative ? -whole : whole, exponent: exponent + surplus };
  return whole.toString().length > digits ? decimalRounded(rounded, digits) : rounded;
}

/** A quotient of whole numbers: exact with as few places as it needs, else rounded to so many digits. */
export function decimalQuotient(above, below, digits) {
  const negative = above < 0n !== below < 0n;
  const [top, bottom] = [above < 0n ? -above : above, below < 0n ? -below : below];
  if (top % bottom === 0n) return { coefficient: negative ? -(top / bottom) : top / bottom, exponent: 0 };
  const places = Math.max(0, digits + 2 + bottom.toString().length - top.toString().length);
  const scaled = top * 10n ** BigInt(places);
  // Two digits more than are wanted, the last one odd where a rest remains, so that rounding sees no tie.
  let coefficient = scaled / bottom;
  const isExact = scaled % bottom === 0n;
  if (!isExact) coefficient = coefficient * 10n + 1n;
  const rounded = decimalRounded({ coefficient, exponent: -places - (isExact ? 0 : 1) }, digits);
  const result = isExact ? shortest(rounded) : rounded;
  return negative ? { ...result, coefficient: -result.coefficient } : result;
}

/** A decimal number without zeros at its end. */
function shortest({ coefficient, exponent }) {
  if (coefficient === 0n) return { coefficient, exponent: 0 };
  while (coefficient % 10n === 0n) {
    coefficient /= 10n;
    exponent += 1;
  }
  return { coefficient, exponent };
}

function inFull({ coefficient, exponent }) {
  if (exponent >= 0) return String(coefficient * 10n ** BigInt(exponent));
  const sign = coefficient < 0n ? "-" : "";
  const digits = String(coefficient < 0n ? -coefficient : coefficient).padStart(1 - exponent, "0");
  return `${sign}${digits.slice(0, exponent)}.${digits.slice(exponent)}`;
}

const digitsOf = ({ coefficient }) => String(coefficient < 0n ? -coefficient : coefficient).length;

const MOST_PLACES = 6;
const MOST_DIGITS = 8;
const ROUNDED_DIGITS = 6;

/** The fewest places, at least one, whose last digit is worth less than a count: `1/60`, or a decimal number. */
function resolvingPlaces(count) {
  const [above, below = "1"] = count.split("/");
  const { coefficient, exponent } = decimalOf(above);
  const top = coefficient < 0n ? -coefficient : coefficient;
  const bottom = BigInt(below) * 10n ** BigInt(-exponent);
  let places = 1;
  while (top * 10n ** BigInt(places) <= bottom) places += 1;
  return places;
}

/**
 * A number without an exponent: in full if it is short, else rounded after the point. The last digit is worth less
 * than a count. If the rounded number would look exact, as 25 for 24.9999999 does, more digits are written.
 */
export function decimalText(number, count = "1") {
  if (-number.exponent <= MOST_PLACES) return inFull(number);
  const short = shortest(number);
  if (-short.exponent <= MOST_PLACES || digitsOf(short) <= MOST_DIGITS) return inFull(short);
  const adjusted = digitsOf(short) + short.exponent - 1;
  for (let places = Math.max(resolvingPlaces(count), ROUNDED_DIGITS - 1 - adjusted); places < -short.exponent; places++) {
    const rounded = decimalRounded(short, adjusted + 1 + places);
    if (rounded.exponent === -places && rounded.coefficient % 10n !== 0n) return inFull(rounded);
  }
  return inFull(short);
}

const MOST_REAL_DIGITS = 17;  // they tell all numbers of eight bytes apart

/** The number with the fewest digits that is nearest to the same floating-point number of `size` bytes. */
function shortestReal(number, size) {
  for (let digits = 1; digits < MOST_REAL_DIGITS; digits++) {
    const rounded = Number(number.toPrecision(digits));
    if (roundedReal(rounded, size) === number) return rounded;
  }
  return number;
}

/** The fewest digits that lead to a floating-point number of `size` bytes, with a point or an exponent: `25.0`, `1e-07`. */
export function floatText(number, size = 8) {
  if (Number.isNaN(number)) return "nan";
  if (!Number.isFinite(number)) return number < 0 ? "-inf" : "inf";
  const shown = size === 8 ? number : shortestReal(number, size);
  const [, sign, lead, rest = "", power] = /^(-?)(\d)(?:\.(\d+))?e([+-]\d+)$/.exec(shown.toExponential());
  const exponent = Number(power);
  const minus = sign || (Object.is(number, -0) ? "-" : "");
  if (exponent < -4 || exponent >= 16) {
    const size = String(Math.abs(exponent)).padStart(2, "0");
    return `${minus}${lead}${rest && `.${rest}`}e${exponent < 0 ? "-" : "+"}${size}`;
  }
  const digits = lead + rest;
  if (exponent < 0) return `${minus}0.${"0".repeat(-exponent - 1)}${digits}`;
  const whole = digits.slice(0, exponent + 1).padEnd(exponent + 1, "0");
  return `${minus}${whole}.${digits.slice(exponent + 1) || "0"}`;
}
