import { textBytes, textFault } from "../encodings.js";
import { CodecError } from "../error.js";
import { exceedsReal, onBits, realBits } from "../number_bits.js";
import { follows, sentOfImage } from "../lists.js";
import { narrowedImage } from "../widths.js";
import { bytesOfNumber, inPlaces, isArray } from "./interpreter.js";
import { isWhole } from "./numbers.js";
import { intervalsText, isWithin } from "./texts.js";
import { memberOf } from "./device.js";
import { formOfField } from "./layouts.js";
import { digitsBytes } from "../digit_texts.js";
import { refusedBitOf, sentinelOf } from "./values.js";
import { checksumOf, lengthNumber, typeBounds } from "./frames.js";

function joinedBytes(series) {
  return Uint8Array.from(series.flatMap((bytes) => [...bytes]));
}

function padded(bytes, size) {
  return joinedBytes([bytes, new Uint8Array(size - bytes.length)]);
}

/** The bytes of one value. Throws CodecError where no codec takes it. */
function bytesOfValue(device, name, value, raw) {
  const { kind, size } = value;
  if (value.textForm && typeof raw === "string") {
    const fault = textFault(value.textForm, size, raw);
    if (fault !== null) throw new CodecError(fault[0], `${name} ${fault[1]}`);
    return inPlaces(value, textBytes(value.textForm, size, raw, false));
  }
  if (isArray(value)) {
    const bytes = typeof raw === "string" ? Uint8Array.from(raw, (char) => char.charCodeAt(0)) : raw;
    if (typeof raw === "string" && /[^\x00-\x7f]/.test(raw)) throw new CodecError("unknown_value", `${name} has characters that are not ASCII`);
    if (bytes.length > size || (kind === "bytes" && bytes.length !== size)) {
      throw new CodecError("wrong_length", `${name} has ${size} bytes, not ${bytes.length}`);
    }
    return Uint8Array.from({ length: size }, (_, at) => bytes[at] ?? 0);
  }
  return inPlaces(value, kind === "float" ? bytesOfReal(name, value, raw) : bytesOfWhole(value, checkedNumber(device, name, value, raw)));
}

function bytesOfWhole(value, number) {
  return value.digits ? digitsBytes(value, number) : bytesOfNumber(number, value.size, "big", value.signed);
}

function bytesOfReal(name, value, number) {
  if (exceedsReal(number, value.size)) {
    throw new CodecError("out_of_range", `${name} is ${number}, which ${8 * value.size} bits do not hold`);
  }
  if (value.ranges && !isWithin(value.ranges, number) && !sentinelOf(value, number)) {
    throw new CodecError("out_of_range", `${name} is ${number}, not in ${intervalsText(value.ranges)}`);
  }
  const nan = Number.isNaN(number) && value.sentinels?.find((sentinel) => sentinel.nan);
  return bytesOfNumber(nan ? nan.value : realBits(number, value.size), value.size, "big", false);
}

function checkedNumber(device, name, value, raw) {
  if (!isWhole(raw)) throw new CodecError("wrong_type", `${name} is a whole number, not ${raw}`);
  if (value.const !== undefined && raw != value.const) throw new CodecError("wrong_const", `${name} is ${raw}, not ${value.const}`);
  if (value.enum) {
    const listing = device.enums.get(value.enum);
    const member = memberOf(listing, raw);
    if (!listing.open && !sentinelOf(value, raw) && (!member || member.unavailable)) {
      throw new CodecError("unknown_value", `${name} is ${raw}, which ${value.enum} does not list`);
    }
  }
  const number = inRange(name, value, raw);
  const bit = value.flags && refusedBitOf(device.flags.get(value.flags), number);
  if (bit && !sentinelOf(value, number)) {
    throw new CodecError("out_of_range", `${bit.name} of ${name} is not in ${intervalsText(bit.ranges)}`);
  }
  return number;
}

function inRange(name, value, number) {
  const [low, high] = typeBounds(value);
  const ranges = value.writeRanges ?? value.ranges;
  const isKnown = sentinelOf(value, number);
  if (number < low || number > high || (ranges && !isWithin(ranges, number) && !isKnown)) {
    throw new CodecError("out_of_range", `${name} is ${number}, not in ${ranges ? intervalsText(ranges) : `${low}..${high}`}`);
  }
  return number;
}

/** The form of a record for the values of its fields: the record itself, or what its selector decides. */
export function formOfValues(record, values) {
  if (!record.selector) return record;
  const number = values.get(record.selector.name);
  return isWhole(number ?? "") ? record.forms.get(BigInt(number)) : undefined;
}

/** The bytes of a record. Throws CodecError for values that are missing or that no codec takes. */
export function encodeRecord(device, record, values) {
  const form = formOfValues(record, values);
  if (!form) throw new CodecError("unknown_value", `${record.selector.name} is ${values.get(record.selector.name)}, which chooses nothing that may follow`);
  const known = new Map();
  const sent = new Map();
  const fields = form.fields.map((field) => decidedField(form, field, values));
  for (const field of fields) if (!field.measures) known.set(field.name, elementsOf(field, values));
  const bytes = joinedBytes(fields.map((field) => {
    if (!field.measures) {
      const list = form.inner?.lists.find(({ name }) => name === field.name);
      const elements = known.get(field.name).map((item) => bytesOfElement(device, field, item));
      sent.set(field.name, elements);
      const own = joinedBytes(list?.parts || list?.decision ? elements.map((bytes) => padded(bytes, list.element)) : elements);
      return list && list !== form.inner.lists.at(-1) ? padded(own, list.most) : own;
    }
    const [of, name, plus = 0] = field.measures;
    const other = form.named(name);
    const items = other.isList ? known.get(name).length : 1;
    const number = inRange(field.name, field.value, (of === "bytes" ? items * other.size : items) + plus);
    return bytesOfValue(device, field.name, { ...field.value, ranges: undefined, writeRanges: undefined }, number);
  }));
  for (const { name, presence } of fields) {
    const [number] = presence ? known.get(presence.by) : [];
    if (presence && !presence.fits(number, known.get(name).length)) {
      throw new CodecError("wrong_measure", `${presence.by} is ${number}, but there are ${known.get(name).length} of ${name}`);
    }
    const more = form.inner?.lists.find((list) => list.name === name)?.more;
    const wrong = more ? sent.get(name).findIndex((bytes, index, { length }) => follows(more, bytes) !== index < length - 1) : -1;
    if (wrong >= 0) throw new CodecError("wrong_measure", `element ${wrong} of ${name} is wrong about whether another one follows`);
  }
  if (form.inner) {
    const last = form.fields.at(-1);
    return sentOfImage(form.inner, bytes, known.get(last.name).length * last.size);
  }
  return form.spans?.length ? narrowedImage(form.spans, bytes) : bytes;
}

/** A field of the type that the values of its record decide. Throws CodecError where they decide nothing. */
function decidedField(record, field, values) {
  const number = field.forms && elementsOf(record.named(field.by), values)[0];
  const decided = number === undefined || isWhole(number) ? formOfField(record, field, values) : undefined;
  if (!decided) throw new CodecError("unknown_value", `${field.by} is ${number}, which chooses nothing that may follow`);
  return decided;
}

/** The values of the elements of a field: those entered, or its constant, no bytes or zeros where nobody enters them. */
function elementsOf(field, values) {
  const value = values.get(field.name);
  if (value === undefined) {
    const implied = field.value?.const ?? (field.reserved || field.value?.size === 0 ? impliedValue(field) : undefined);
    if (implied === undefined) throw new CodecError("missing_value", `${field.name} is missing`);
    return Array.from({ length: field.count ?? 0 }, () => implied);
  }
  if (!field.isList) return [value];
  const isRight = field.lengths ? isWithin(field.lengths, value.length) : value.length === field.count;
  if (!isRight) {
    const count = field.lengths ? intervalsText(field.lengths) : field.count;
    throw new CodecError("wrong_length", `${field.name} has ${count} elements, not ${value.length}`);
  }
  return value;
}

function impliedValue({ value }) {
  if (typeof value.default === "number") return value.default;
  return isArray(value) ? new Uint8Array(value.size) : 0;
}

function bytesOfElement(device, field, item) {
  if (field.record) return encodeRecord(device, device.records.get(field.record), item);
  return bytesOfValue(device, field.name, field.value, item);
}

/** Whether users supply the value of a part. */
export function isArgument({ role, constant, reserved }) {
  return (role === "unit_address" || role === "plain") && constant === undefined && !reserved;
}

/**
 * The frame of a message; `values` has the values of the parts of its header and of the fields of its body, by name.
 * With `error`, it is the exception response. Throws CodecError.
 */
export function encodeFrame(device, { link: linkName, direction, message: messageName, error = false }, values) {
  const link = device.links.get(linkName);
  const shape = link[direction];
  const message = link.carriedMessages[error ? "request" : direction].get(messageName);
  if (!message) throw new CodecError("unknown_code", `${messageName} is not sent on ${linkName}`);
  const record = error ? device.records.get(link.exception.record) : message[direction];
  const body = encodeRecord(device, record, values);
  if (direction === "request" && link.barred?.includes(messageName)) refuseBroadcast(link, shape, values, messageName);
  const numbers = new Map(shape.parts.map((part) => [part.name, partNumber(link, direction, part, values, message, error)]));
  const original = () => {
    const data = new Uint8Array(shape.headerSize + body.length + shape.trailerSize);
    data.set(body, shape.headerSize);
    for (const part of shape.parts) {
      partBytes(part, numbers.get(part.name)).forEach((byte, at) => (data[part.at(data.length) + at] |= byte));
    }
    return data;
  };
  const sent = () => sentBytes(shape, original());
  // What is escaped comes first: how many bytes are sent depends on all of its bytes.
  for (const bytes of [original, sent]) {
    const isOwn = (part) => (shape.escape && !part.beforeEscape ? sent : original) === bytes;
    for (const length of shape.lengths.filter(isOwn)) {
      const total = bytes().length;
      const units = lengthNumber(length, total);
      if (units === undefined) throw new CodecError("wrong_length", `${length.name} cannot say that the frame has ${total} bytes`);
      numbers.set(length.name, units);
    }
    for (const check of shape.checksums.filter(isOwn)) numbers.set(check.name, checksumOf(check, bytes()));
  }
  const inner = sent();
  const encoded = link.transmission === "hex_ascii" ? charactersOf(inner) : inner;
  const [start, end] = link.delimiters[direction];
  const { byte, sent: count } = link.preamble ?? { byte: 0, sent: 0 };
  return joinedBytes([new Uint8Array(count).fill(byte), start, encoded, end]);
}

function refuseBroadcast({ addresses }, shape, values, message) {
  const { name } = shape.header.find(({ role }) => role === "unit_address");
  if (values.get(name) == addresses.broadcast) {
    throw new CodecError("out_of_range", `${name} is ${addresses.broadcast}: ${message} cannot be broadcast`);
  }
}

function charactersOf(bytes) {
  const digits = Array.from(bytes, (byte) => byte.toString(16).toUpperCase().padStart(2, "0")).join("");
  return Uint8Array.from(digits, (char) => char.charCodeAt(0));
}

function sentBytes(shape, data) {
  if (!shape.escape) return data;
  const stop = data.length + shape.escapeStop;
  const inner = shape.escape.bytes.escaped(data.subarray(shape.escapeStart, stop));
  return joinedBytes([data.subarray(0, shape.escapeStart), inner, data.subarray(stop)]);
}

function partBytes(part, number) {
  if (number instanceof Uint8Array) return number;
  if (part.value.digits) return digitsBytes(part.value, number);
  return bytesOfNumber(BigInt(number) << BigInt(part.shift), part.size, part.order ?? "big", part.value.signed);
}

function partNumber(link, direction, part, values, message, error) {
  if (part.role === "length" || part.role === "checksum") return part.role === "length" ? 0 : new Uint8Array(part.size);
  if (part.constant !== undefined) return part.constant;
  const code = message.codeOf(direction);
  if (part.role === "code") return error ? link.exception.code ?? onBits(code, link.exception.flag, (bits, mask) => bits | mask) : code;
  const number = values.get(part.name);
  if (number === undefined) throw new CodecError("missing_value", `${part.name} is missing`);
  const addresses = part.role === "unit_address" ? link.addresses : undefined;
  if (addresses?.ranges && number == addresses.broadcast) return number;
  const { exception } = link;
  if (exception?.part === part.name && direction === "response" && isWithin(exception.normal, number) === error) {
    throw new CodecError("out_of_range", `${part.name} is ${number}, as in ${error ? "a response" : "an exception response"}`);
  }
  return inRange(part.name, { ...part.value, ranges: addresses?.ranges ?? part.value.ranges, writeRanges: undefined }, number);
}
