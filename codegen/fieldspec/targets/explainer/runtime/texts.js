import { floatText } from "./numbers.js";
import { SENTENCES } from "./sentences.js";

/** A sentence with the texts for its names in braces. */
export function sentence(text, parts) {
  return text.replace(/\{(\w+)\}/g, (_, name) => parts[name]);
}

/** `1 byte` or `8 bytes`. */
export function byteCount(count) {
  return count === 1 ? SENTENCES.SINGLE_BYTE : sentence(SENTENCES.BYTES, { count });
}

/** How many bytes are missing for the fields or the part of these names. */
export function missingText(count, names) {
  return sentence(count === 1 ? SENTENCES.BYTE_MISSING : SENTENCES.BYTES_MISSING, { count, names });
}

const DIGITS = Array.from({ length: 256 }, (_, byte) => byte.toString(16).toUpperCase().padStart(2, "0"));

/** Bytes as hexadecimal digits. */
export function hexOf(bytes, separator = "") {
  let text = "";
  for (const byte of bytes) text += (text && separator) + DIGITS[byte];
  return text;
}

/** The bytes of hexadecimal digits. */
export function bytesOfHex(digits) {
  return Uint8Array.from({ length: digits.length / 2 }, (_, at) => parseInt(digits.slice(2 * at, 2 * at + 2), 16));
}

/** The characters of bytes, one for each. */
export function latinOf(bytes) {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return text;
}

/** Whether two series of bytes are the same. */
export function sameBytes(left, right) {
  return left.length === right.length && left.every((byte, at) => byte === right[at]);
}

/** Whether two raw values are the same; a truth value is the same as its number. */
export function sameValue(left, right) {
  if (left instanceof Uint8Array || right instanceof Uint8Array) {
    return left instanceof Uint8Array && right instanceof Uint8Array && sameBytes(left, right);
  }
  if (Array.isArray(left) || Array.isArray(right)) {
    return Array.isArray(left) && Array.isArray(right) && left.length === right.length
      && left.every((item, at) => sameValue(item, right[at]));
  }
  if (left instanceof Map || right instanceof Map) {
    return left instanceof Map && right instanceof Map && left.size === right.size
      && [...left].every(([key, item]) => right.has(key) && sameValue(item, right.get(key)));
  }
  if (typeof left === "string" || typeof right === "string") return left === right;
  return left == right;  // numbers, bigints and truth values
}

/** A raw value as a verdict prints it. The number 3 of a field of floats is `3.0`; `floatSize` is their size. */
export function valueText(value, floatSize = 0) {
  if (typeof value === "number" && (floatSize || !Number.isInteger(value))) return floatText(value, floatSize);
  if (value instanceof Uint8Array) return hexOf(value, " ");
  if (typeof value === "string") return JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map((item) => valueText(item, floatSize)).join(", ")}]`;
  if (value instanceof Map) return `{${[...value].map(([key, item]) => `${key}: ${valueText(item)}`).join(", ")}}`;
  return String(value);
}

/** A raw value for JSON: bytes, and numbers that JSON does not have, as text; bigints stay. */
export function portableValue(value) {
  if (value instanceof Uint8Array) return hexOf(value);
  if (typeof value === "number" && !Number.isFinite(value)) return floatText(value);
  if (Array.isArray(value)) return value.map(portableValue);
  if (value instanceof Map) return Object.fromEntries([...value].map(([key, item]) => [key, portableValue(item)]));
  return value ?? null;
}

/** Intervals as a spec writes them: `0..127, 200`. */
export function intervalsText(ranges) {
  return ranges.map(([low, high]) => (low == high ? boundText(low) : `${boundText(low)}..${boundText(high)}`)).join(", ");
}

/** A bound with all its digits, of which a spec has at most 20 after the point, and never with an exponent. */
function boundText(bound) {
  const text = String(bound);
  return text.includes("e-") ? bound.toFixed(20).replace(/0+$/, "") : text;
}

/** Whether a number is in one of some intervals. */
export function isWithin(ranges, number) {
  return ranges.some(([low, high]) => low <= number && number <= high);
}

/** `a, b or c` */
export function enumeration(names, last) {
  return names.length > 1 ? `${names.slice(0, -1).join(", ")} ${last} ${names.at(-1)}` : names.join("");
}
