import { CodecError } from "./error.js";

const DIGITS_OF = { decimal: /^[0-9]*$/, upper_hex: /^[0-9A-F]*$/, lower_hex: /^[0-9a-f]*$/ };

const latinText = (bytes) => Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
const latinBytes = (text) => Uint8Array.from(text, (character) => character.charCodeAt(0));

/** What is sent of the bytes in the image of a value: no leading zeros, and a sign only below zero. */
function narrowedBytes({ form, hasSign }, image) {
  const text = latinText(image);
  if (form === "text") return latinBytes(text.replace(/\0+$/, ""));
  const digits = (hasSign ? text.slice(1) : text).replace(/^0+(?=[0-9A-Fa-f])/, "");
  const isNegative = hasSign && text[0] === "-" && /[^0.]/.test(digits);
  return latinBytes((isNegative ? "-" : "") + digits);
}

/** The bytes in the image of a value; null for bytes that are none of it. */
export function widenedBytes(field, bytes) {
  const { form, size, most, places = 0, hasSign = false } = field;
  let text = latinText(bytes);
  if (text.length > most) return null;
  if (form === "bytes") return bytes;
  if (form === "text") return text.includes("\0") ? null : latinBytes(text.padEnd(size, "\0"));
  let sign = hasSign ? "+" : "";
  if (hasSign && (text[0] === "+" || text[0] === "-")) {
    sign = text[0];
    text = text.slice(1);
  }
  const point = places ? text.indexOf(".") : -1;
  const whole = point < 0 ? text : text.slice(0, point);
  const fraction = point < 0 ? "" : text.slice(point + 1);
  if (whole === "" || (point >= 0 && fraction === "") || fraction.length > places) return null;
  if (!DIGITS_OF[form].test(whole + fraction)) return null;
  const room = most - (places ? places + 1 : 0);
  const after = places ? `.${fraction.padEnd(places, "0")}` : "";
  const image = latinBytes(sign + whole.replace(/^0+(?=.)/, "").padStart(room, "0") + after);
  return narrowedBytes(field, image).length <= most ? image : null;
}

/** The number of digits of a form; NaN for what are no digits. */
export function numberOfDigits(form, bytes) {
  const text = latinText(bytes);
  return DIGITS_OF[form].test(text) ? parseInt(text, form === "decimal" ? 10 : 16) : NaN;
}

/** The digits of a number in a form. */
export function digitsOfNumber(form, number, length) {
  const text = number.toString(form === "decimal" ? 10 : 16).padStart(length, "0");
  return latinBytes(form === "upper_hex" ? text.toUpperCase() : text);
}

/** The number of bytes of a text that another field counts; NaN for what are no digits. */
function textNumber({ count, plus, little, digits }, bytes, extents) {
  const sent = bytes.slice(extents[count].start, extents[count].stop);
  if (digits) return numberOfDigits(digits, sent) - plus;
  return (little ? sent.reverse() : sent).reduce((sum, byte) => 256 * sum + byte, 0) - plus;
}

/** The same; undefined for a number that the text cannot have. */
function countedText(field, bytes, extents) {
  const number = textNumber(field, bytes, extents);
  return number >= 0 && number <= field.most ? number : undefined;
}

/** A number as digits, in one byte or in two. */
function countBytes(number, size, { little, digits }) {
  if (digits) return digitsOfNumber(digits, number, size);
  if (size === 1) return Uint8Array.of(number);
  return Uint8Array.from(little ? [number & 255, number >> 8] : [number >> 8, number & 255]);
}

/** Where a field ends that begins at a byte; undefined where its bytes, or its end, are missing. */
function stopOf(field, bytes, at, extents) {
  const { size, most, end } = field;
  if (most === undefined) return at + size <= bytes.length ? at + size : undefined;
  if (field.count !== undefined) {
    const number = countedText(field, bytes, extents);
    return number !== undefined && at + number <= bytes.length ? at + number : undefined;
  }
  if (end === undefined) return bytes.length;
  const stop = bytes.indexOf(end, at);
  return stop < 0 ? undefined : stop;
}

/**
 * The fields of a record whose values vary in width, as far as the data go: where they are, and their bytes in the
 * image, in which each value has all the bytes that it may have; null for bytes that are none of the value.
 */
export function extentsOf(fields, bytes) {
  const extents = [];
  let start = 0;
  for (const field of fields) {
    const stop = stopOf(field, bytes, start, extents);
    if (stop === undefined) return extents;
    const piece = bytes.subarray(start, stop);
    extents.push({ start, stop, image: field.most === undefined ? piece : widenedBytes(field, piece) });
    if (field.count !== undefined) {
      const count = extents[field.count];
      count.image = countBytes(field.size + field.plus, count.stop - count.start, field);
    }
    start = stop;
  }
  return extents;
}

/** What `read(image, start, end)` makes of the image of a record. Throws CodecError with the place in the data. */
export function readImage(fields, read, bytes, offset, end) {
  const data = bytes.subarray(offset, end);
  const extents = extentsOf(fields, data);
  const unfit = extents.findIndex(({ image }) => image === null);
  if (unfit >= 0) throw new CodecError("unknown_value", `${fields[unfit].name} is not in its form`, offset + extents[unfit].start);
  const { count } = fields[extents.length] ?? {};
  if (count !== undefined && countedText(fields[extents.length], data, extents) === undefined) {
    const reason = Number.isNaN(textNumber(fields[extents.length], data, extents)) ? "unknown_value" : "wrong_measure";
    throw new CodecError(reason, `${fields[count].name} is not a number of bytes`, offset + extents[count].start);
  }
  if (extents.length < fields.length) throw new CodecError("incomplete", `${fields[extents.length].name} has no end`, end);
  const stop = extents.at(-1).stop;
  if (stop < data.length) throw new CodecError("wrong_length", `${fields.at(-1).name} is followed by more bytes`, offset + stop);
  const image = Uint8Array.from(extents.flatMap((extent) => [...extent.image]));
  try {
    return read(image, 0, image.length);
  } catch (error) {
    if (!(error instanceof CodecError) || error.offset === null) throw error;
    throw new CodecError(error.reason, error.detail, offset + placeInData(fields, extents, error.offset));
  }
}

/** The byte in the data for a byte of the image. */
function placeInData(fields, extents, at) {
  let first = 0;
  for (const [number, { size, most }] of fields.entries()) {
    if (at < first + size) return extents[number].start + (most === undefined ? at - first : 0);
    first += size;
  }
  return extents.at(-1).stop;
}

/** What is sent of an image. Throws CodecError for a text that has the byte which would end it. */
export function narrowedImage(fields, image) {
  const pieces = [];
  const starts = [];
  let at = 0;
  for (const field of fields) {
    const piece = image.subarray(at, at + field.size);
    at += field.size;
    starts.push(pieces.length);
    const bytes = field.most === undefined ? piece : narrowedBytes(field, piece);
    if (field.most !== undefined && field.end !== undefined && bytes.includes(field.end)) {
      throw new CodecError("unknown_value", `${field.name} has the character that ends it`);
    }
    if (field.count !== undefined) {
      const count = countBytes(bytes.length + field.plus, fields[field.count].size, field);
      pieces.splice(starts[field.count], count.length, ...count);
    }
    pieces.push(...bytes);
  }
  return Uint8Array.from(pieces);
}
