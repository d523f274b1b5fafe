/** Bytes or values that a codec refuses. */
export class CodecError extends Error {
  constructor(reason, detail, offset = null) {
    super(offset === null ? `${reason}: ${detail}` : `${reason} at byte ${offset}: ${detail}`);
    this.name = "CodecError";
    this.reason = reason;
    this.detail = detail;
    this.offset = offset;
  }
}

/** The error of data of a wrong size, which begin at `offset` of a frame. */
export function wrongSize(name, least, most, size, offset) {
  return size < least
    ? new CodecError("incomplete", `${name} has at least ${least} bytes, not ${size}`, offset + size)
    : new CodecError("wrong_length", `${name} has at most ${most} bytes, not ${size}`, offset + most);
}

/** The error of data that end within an element of a list. */
export function brokenList(name, left, end) {
  return new CodecError("wrong_length", `${left} bytes are not a whole number of ${name}`, end);
}

/** The error of a number that was received. */
export function wrongNumber(reason, name, number, expected, offset) {
  return new CodecError(reason, `${name} is ${number}, ${expected}`, offset);
}

/** The error of a value that cannot be encoded as a whole number that is allowed; `wide` where numbers are bigints. */
export function refusedNumber(name, value, allowed, wide) {
  return wrongWhole(name, value, wide) ?? new CodecError("out_of_range", `${name} is ${value}, not in ${allowed}`);
}

/** The error of a word with a field of bits that is out of its range. */
export function refusedBits(name, bits, allowed) {
  return new CodecError("out_of_range", `${bits} of ${name} is not in ${allowed}`);
}

/** The error of a value that a closed enum does not list; `wide` where its numbers are bigints. */
export function refusedMember(name, value, enumName, wide) {
  return wrongWhole(name, value, wide) ?? new CodecError("unknown_value", `${name} is ${value}, which ${enumName} does not list`);
}

/** The error of a value that is not a whole number, or null. */
function wrongWhole(name, value, wide) {
  if (wide ? typeof value === "bigint" : Number.isInteger(value)) return null;
  return wrongType(name, value, wide ? "a bigint" : "a whole number");
}

/** The error of a value that is missing, or not of its `kind`. */
export function wrongType(name, value, kind) {
  if (value === undefined) return new CodecError("missing_value", `${name} is missing`);
  return new CodecError("wrong_type", `${name} is ${kind}, not ${printed(value)}`);
}

/** The error of a value that must be a list of `least` to `most` elements. */
export function refusedList(name, value, least, most) {
  if (!Array.isArray(value)) return wrongType(name, value, "an array");
  const count = least === most ? `${least}` : `${least}..${most}`;
  return new CodecError("wrong_length", `${name} has ${count} elements, not ${value.length}`);
}

/** A value within a message: short, and without what it may do when it is turned into a text. */
export function printed(value) {
  if (typeof value === "string") return JSON.stringify(value.slice(0, 60));
  if (typeof value === "bigint") return `${value}n`;
  if (typeof value === "object" && value !== null) return Array.isArray(value) ? "an array" : "an object";
  return String(value);
}
