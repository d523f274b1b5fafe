import { bitsOfWhole, realOfBits, wholeOfBits } from "../number_bits.js";
import { decodedText } from "../encodings.js";
import { digitsNumber } from "../digit_texts.js";
import { extentsIn, packedPlace, unpackedNumber } from "../lists.js";
import { formOfField } from "./layouts.js";
import { widenedBytes } from "../widths.js";

/** The bytes up to which a whole number is not a bigint. */
export const WIDE = 6;

/** Whether the raw value of a value is a sequence, a text or bytes, and not a number. */
export function isArray({ kind }) {
  switch (kind) {
    case "text": case "bytes": return true;
    case "integer": case "float": case "boolean": return false;
    default: throw new RangeError(`unknown kind: ${kind}`);
  }
}

/** Bytes as an unsigned bigint. */
export function unsignedOf(bytes, order) {
  let number = 0n;
  for (let at = 0; at < bytes.length; at++) {
    number = (number << 8n) | BigInt(bytes[order === "big" ? at : bytes.length - 1 - at]);
  }
  return number;
}

/** Bytes as a whole number; a bigint if there are more than six of them. `signed` is as in `wholeOfBits`. */
export function wholeOf(bytes, order, signed) {
  if (bytes.length > WIDE) return wholeOfBits(unsignedOf(bytes, order), 8 * bytes.length, signed);
  let bits = 0;
  for (let at = 0; at < bytes.length; at++) bits = bits * 256 + bytes[order === "big" ? at : bytes.length - 1 - at];
  return wholeOfBits(bits, 8 * bytes.length, signed);
}

/** The bytes of a whole number; `signed` is as in `bitsOfWhole`. */
export function bytesOfNumber(number, size, order, signed) {
  const bits = BigInt.asUintN(8 * size, bitsOfWhole(BigInt(number), 8 * size, signed));
  const big = Uint8Array.from({ length: size }, (_, at) => Number((bits >> BigInt(8 * (size - 1 - at))) & 255n));
  return order === "big" ? big : big.reverse();
}

/** The bytes of a value from the most significant one on. */
export function inOrder({ order }, bytes) {
  return order ? Uint8Array.from(order, (place) => bytes[place]) : bytes;
}

/** The bytes of a value as they are sent, of those from the most significant one on. */
export function inPlaces({ order }, bytes) {
  return order ? Uint8Array.from(bytes, (_, place) => bytes[order.indexOf(place)]) : bytes;
}

/** The places of the bytes of a value, the most significant first; `isSwapped` words of 16 bits are in the other order. */
export function orderOf({ kind, size, textForm }, order, isSwapped) {
  if (kind === "text" || kind === "bytes") {
    return textForm?.encoding === "utf_16" && order !== "big" ? orderOf({ size }, "little", true) : undefined;
  }
  const isUpward = (order === "big") !== isSwapped;
  return Array.from({ length: size }, (_, at) => (isUpward ? at : size - 1 - at) ^ (isSwapped ? 1 : 0));
}

/** What all bytes of a value are; null for digits, or characters, that are none of its. */
export function contentOf(value, bytes) {
  const ordered = inOrder(value, bytes);
  switch (value.kind) {
    case "text": return decodedText(value.textForm, ordered, false);
    case "bytes": return bytes;
    case "float": return realOfBits(wholeOf(ordered, "big", false), bytes.length);
    case "boolean": return wholeOf(ordered, "big", false);
    case "integer": return value.digits ? digitsNumber(value, ordered) ?? null : wholeOf(ordered, "big", value.signed);
    default: throw new RangeError(`unknown kind: ${value.kind}`);
  }
}

/** The raw value of all bytes of a value; bytes that are not the digits of a number, as bytes. */
export const numberOf = (value, bytes) => contentOf(value, bytes) ?? bytes;

/** What a reader gets for a content: a truth value as such, and the bytes of what has none. */
function numberOfContent({ value, reserved }, content, raw, image) {
  if (content === null || (reserved && value.kind === "text")) return image ?? raw;
  return value.kind === "boolean" && !reserved && (content === 0 || content === 1) ? content === 1 : content;
}

/**
 * What all bytes of a field, or of another `value`, gave; of one that varies in width, or is number `index` of a packed
 * list, the `image` has all its bytes.
 */
export function loaded(field, raw, index) {
  const image = field.span ? widenedBytes(field.span, raw)
    : field.packing ? unpackedNumber(field.packing, raw, index, field.size) : raw;
  const content = image === null ? null : contentOf(field.value, image);
  return { field, raw, image, content, number: numberOfContent(field, content, raw, image) };
}

/**
 * The contents that a record gives, by name. Adds what gave them to `rows`. If it differs in size, `parts` tell the size of
 * its lists, which has been judged.
 */
function run(device, record, parts, data, start, stop, path, rows) {
  const { extents } = parts ? extentsIn(parts, data.subarray(start, stop)) : { extents: [] };
  const byName = new Map(extents.map((extent, number) => [parts.lists[number].name, extent]));
  const values = new Map();
  const beside = new Map();
  let at = start;
  for (const name of record.inner?.sent ?? record.fields.map((field) => field.name)) {
    const field = formOfField(record, record.named(name), values);
    const isOpen = field.span || field.count === undefined;
    const { size, elements, numbers } = byName.get(name) ?? { size: isOpen ? stop - at : field.size * field.count, elements: [] };
    const count = numbers ?? field.count ?? Math.floor(size / field.size);
    const all = field.isList ? new Array(count).fill(field.size) : [size];
    const contents = runElements(device, field, data, at, elements.length ? elements : all, path, rows, beside);
    values.set(name, field.isList ? contents : contents[0]);
    at += size;
  }
  return values;
}

/**
 * The contents of the elements of a field, which follow each other from `start` on and have some sizes. Adds what gave
 * them to `rows`, and to `beside`, those of the same record by the names of their fields.
 */
function runElements(device, field, data, start, sizes, path, rows, beside) {
  let stop = start;
  return sizes.map((size, index) => {
    const offset = stop;
    stop += size;
    const own = `${path}${field.name}${field.isList ? `[${index}]` : ""}`;
    const record = field.record && device.records.get(field.record);
    if (record) return run(device, record, field.parts, data, offset, stop, `${own}.`, rows);
    const [first, last] = field.packing ? packedPlace(field.packing, index).map((at) => start + at) : [offset, stop];
    const variable = { field, value: field.value, exponent: field.exponent };
    const { raw, image, content, number } = loaded(field, data.subarray(first, last), index);
    const row = { field, raw, image, content, number, variable, path: own, index, offset: first, rowsBeside: beside };
    if (index * (field.packing?.bits ?? 0) % 8) {  // the row of the number before it has the byte that both share
      row.raw = row.raw.subarray(1);
      row.offset++;
    }
    rows.push(row);
    beside.set(field.name, row);
    return row.number;
  });
}

/** Some bytes of data. */
export class Place {
  constructor(data, start, stop) {
    Object.assign(this, { data, start, stop });
  }
}

/** What reads a field of a record. */
export const fieldProgram = (device, record, field) => ({ device, field });

/** The contents of the elements of a field at a place, as `runElements` has them. */
export function runEach({ device, field }, { data, start }, sizes, rows, rowsBeside) {
  return runElements(device, field, data, start, sizes, "", rows, rowsBeside);
}
