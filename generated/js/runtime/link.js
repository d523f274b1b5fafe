import { checksumBytes } from "./checksums.js";
import { hexText, matches, withDelimiters, withoutDelimiters } from "./delimiters.js";
import { CodecError, refusedNumber } from "./error.js";
import { onBits } from "./number_bits.js";
import { readCode, readPart, writePart } from "./parts.js";
import { rangesText, within } from "./values.js";

/** A message: its data in both directions; `code` is null where frames do not carry one. */
export function message(name, code, request, response, number = null, responseCode = code) {
  return Object.freeze({ name, code, responseCode, number, request, response });
}

/**
 * The frames of a link in both directions: `header` and `trailer` are the parts before and after the body, in their
 * order, `start` and `end` the delimiters.
 */
export function frames({ name, hex, request, response, unitAddresses }) {
  return { name, hex, request: frame(request), response: frame(response), unitAddresses };
}

/**
 * A link with its frames and the messages that it carries. `exception` has the flag in the code and the record of an
 * exception response, or is null; its `mark` are bytes at a place in the data, where responses carry no code. `unanswered` are the messages to which the device sends no response. `subcodes` has
 * for each direction the number in the data that tells messages with one code apart, by this code; or the messages whose
 * `answers` nothing in the data tells apart, so that only the request does. `barred` are the messages whose requests
 * cannot be broadcast.
 */
export function link(shapes, messages, exception, unanswered = [], subcodes = {}, barred = []) {
  const silent = new Set(unanswered);
  const byCode = {
    request: codesOf(messages.filter((entry) => entry.request !== null), "code"),
    response: codesOf(messages.filter((entry) => !silent.has(entry)), "responseCode"),
    refused: refusedCodesOf(messages.filter((entry) => entry.request !== null)),
  };
  const context = { ...shapes, messages: new Set(messages), byCode, exception, unanswered: silent, subcodes };
  const { name, request, response, unitAddresses } = shapes;
  return Object.freeze({
    name,
    messages,
    unitAddresses,
    /** The frame of a request. Throws CodecError. */
    encodeRequest(header, entry, data) {
      const alone = barred.includes(entry) ? entry.name : "";
      const code = codeOf(context, request, entry, "code");
      expectRequest(entry);
      return encoded(context, request, header, code, entry.request, data, undefined, alone);
    },
    /** The frame of a response. Throws CodecError. */
    encodeResponse(header, entry, data) {
      expectAnswer(context, entry);
      const code = codeOf(context, response, entry, "responseCode");
      return encoded(context, response, header, code, entry.response, data, context.exception?.normal);
    },
    /** The exception response in place of the usual response with a code; null where frames carry none. Throws CodecError. */
    encodeExceptionResponse(header, code, data) {
      const exception = expectedException(context);
      if ((code === null) !== (response.code === null)) {
        throw new CodecError("unknown_code", code === null ? "an exception response has a code" : "frames here carry no code");
      }
      const own = exception.code ?? onBits(code, exception.flag, (bits, mask) => bits | mask);
      const bytes = encoded(context, response, header, own, exception.record, data, exception.marks);
      if (exception.code !== undefined && code !== own) {
        throw new CodecError("unknown_code", `an exception response has the code ${own}`);
      }
      return bytes;
    },
    /** The meaning of a request. `entry` is needed where frames carry no code. Throws CodecError. */
    decodeRequest(bytes, entry) {
      return decoded(context, request, bytes, entry, "request");
    },
    /** The meaning of a response, to the message `entry` where it is present. Throws CodecError. */
    decodeResponse(bytes, entry) {
      return decoded(context, response, bytes, entry, "response");
    },
  });
}

function codesOf(messages, key) {
  const byCode = new Map();
  for (const entry of messages) if (entry[key] !== null && !byCode.has(entry[key])) byCode.set(entry[key], entry);
  return byCode;
}

/** The messages that exception responses refuse, by the code of these. */
function refusedCodesOf(messages) {
  const byCode = new Map();
  for (const entry of messages) byCode.set(entry.responseCode, [...(byCode.get(entry.responseCode) ?? []), entry]);
  return byCode;
}

function frame({ header, trailer, start, end, preamble, checksums, escape, escapeStart, escapeStop }) {
  const parts = [...header, ...trailer];
  return {
    header,
    trailer,
    parts,
    start,
    preamble,
    end,
    headerSize: Math.max(0, ...header.map(({ offset, size }) => offset + size)),
    trailerSize: trailer.reduce((size, part) => size + part.size, 0),
    lengths: header.filter((part) => part.role === "length"),
    checksums: checksums.map((index) => parts[index]),
    escape,
    escapeStart,
    escapeStop,
    digits: parts.filter((part) => part.digits && part.role !== "checksum" && !part.reserved),
    constants: parts.filter((part) => part.constant !== null && !part.reserved),
    visible: header.filter((part) => part.key !== null),
    keys: Object.assign({ __proto__: null }, ...parts.filter((part) => part.key !== null).map((part) => ({ [part.key]: 0 }))),
    code: parts.find((part) => part.role === "code") ?? null,
  };
}

function codeOf(context, { code }, entry, key) {
  if (!context.messages.has(entry)) throw new CodecError("unknown_code", `${context.name} does not carry ${entry?.name}`);
  return code === null ? null : entry[key];
}

function expectAnswer({ name, unanswered }, entry) {
  if (unanswered.has(entry)) throw new CodecError("unknown_code", `${entry.name} is not answered on ${name}`);
}

function expectRequest({ name, request }) {
  if (request === null) throw new CodecError("unknown_code", `only the device sends ${name}`);
}

function expectedException({ name, exception }) {
  if (exception === null) throw new CodecError("unknown_code", `${name} has no exception responses`);
  return exception;
}

/** The offset of a place in parts of `size` bytes; negative ones count from the end, and null is the end. */
function place(offset, size) {
  return offset === null ? size : offset < 0 ? size + offset : offset;
}

/** Whether a length or a checksum is that of the bytes which are sent, not of those before they were escaped. */
function isOfSent(shape, part) {
  return shape.escape !== null && !part.beforeEscape;
}

/** The parts before they were escaped. Throws CodecError for what is wrong around them, and for a wrong escape. */
export function originalParts(shape, data) {
  if (shape.escape === null) return data;
  const lengths = shape.digits.filter((part) => part.role === "length" && isOfSent(shape, part));
  const early = wrongSize(shape, data) ?? wrongDigits(lengths, data);
  const wrong = early ?? wrongLength(shape, data, true) ?? wrongChecksum(shape, data, true);
  if (wrong !== null) throw wrong;
  const [first, stop] = [shape.escapeStart, place(shape.escapeStop, data.length)];
  const inner = shape.escape.original(data.subarray(first, stop), shape.start.length + first);
  return joined(data.subarray(0, first), inner, data.subarray(stop));
}

/** What is sent for the bytes of the parts. */
function sentParts(shape, data) {
  if (shape.escape === null) return data;
  const [first, stop] = [shape.escapeStart, place(shape.escapeStop, data.length)];
  return joined(data.subarray(0, first), shape.escape.escaped(data.subarray(first, stop)), data.subarray(stop));
}

function joined(...pieces) {
  const bytes = new Uint8Array(pieces.reduce((size, piece) => size + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    bytes.set(piece, at);
    at += piece.length;
  }
  return bytes;
}

/**
 * The first reason why the parts of a frame are wrong: its size, the digits of a part, a length, a checksum or a
 * constant; null for none.
 */
export function wrongParts(shape, data) {
  return (
    wrongSize(shape, data) ??
    wrongDigits(shape.digits, data) ??
    wrongLength(shape, data, false) ??
    wrongChecksum(shape, data, false) ??
    wrongConstant(shape, data)
  );
}

function wrongSize(shape, data) {
  const [size, least] = [data.length, shape.headerSize + shape.trailerSize];
  return size < least ? new CodecError("incomplete", `a frame has at least ${least} bytes, not ${size}`, size) : null;
}

function wrongDigits(parts, data) {
  for (const part of parts) {
    const at = place(part.offset, data.length);
    if (Number.isNaN(readPart(data, at, part))) {
      return new CodecError("unknown_value", `${part.name} is not ${part.size} digits`, at);
    }
  }
  return null;
}

function wrongLength(shape, data, ofSent) {
  const size = data.length;
  for (const part of shape.lengths) {
    if (isOfSent(shape, part) !== ofSent) continue;
    const units = readPart(data, part.offset, part);
    const extent = units * part.unitSize + part.base;
    if (extent !== size) {
      return new CodecError("wrong_length", `${part.name} is ${units}, for a frame of ${extent} bytes, but there are ${size}`, part.offset);
    }
  }
  return null;
}

function wrongChecksum(shape, data, ofSent) {
  const size = data.length;
  for (const part of shape.checksums) {
    if (isOfSent(shape, part) !== ofSent) continue;
    const at = place(part.offset, size);
    const want = checksumBytes(part, data, place(part.start, size), place(part.stop, size));
    if (!matches(data, at, want)) {
      const have = data.subarray(at, at + part.size);
      return new CodecError("wrong_checksum", `${part.name} is ${hexText(have)}, not ${hexText(want)}`, at);
    }
  }
  return null;
}

function wrongConstant(shape, data) {
  for (const part of shape.constants) {
    const at = place(part.offset, data.length);
    const number = readPart(data, at, part);
    if (number !== part.constant) {
      return new CodecError("wrong_const", `${part.name} is ${number}, not ${part.constant}`, at);
    }
  }
  return null;
}

function decoded(context, shape, bytes, entry, direction) {
  const data = originalParts(shape, withoutDelimiters(context, shape, bytes));
  const wrong = wrongParts(shape, data);
  if (wrong !== null) throw wrong;
  const end = data.length - shape.trailerSize;
  const header = {};
  for (const part of shape.visible) header[part.key] = readPart(data, part.offset, part);
  if (shape.code === null) {
    if (!context.messages.has(entry)) {
      throw new CodecError("unknown_code", "the frame carries no code: pass the message that it belongs to");
    }
    if (direction === "response") expectAnswer(context, entry);
    else expectRequest(entry);
    const { exception } = context;
    if (exception !== null && direction === "response" && isUncodedException(exception, shape, data)) {
      const record = exception.record.read(data, shape.headerSize, end);
      return { kind: "exception", name: entry.name, header, message: entry, code: entry.responseCode ?? 0, data: record };
    }
    return { kind: direction, name: entry.name, header, message: entry, data: entry[direction].read(data, shape.headerSize, end) };
  }
  const offset = place(shape.code.offset, data.length);
  const code = readCode(data, offset, shape.code);
  const { exception } = context;
  if (exception !== null && direction === "response" && isMarked(exception, shape, code, data)) {
    const asked = onBits(code, exception.flag, (bits, mask) => bits & ~mask);
    const record = exception.record.read(data, shape.headerSize, end);
    const answered = answeredBy(context, asked, entry);
    return { kind: "exception", name: answered?.name ?? null, header, message: answered, code: asked, data: record };
  }
  const known = knownBy(context, shape, direction, code, data.subarray(shape.headerSize, end), entry, offset);
  if (known === undefined) {
    throw new CodecError("unknown_code", `no message has the code 0x${code.toString(16).padStart(2, "0")}`, offset);
  }
  if (entry !== undefined && entry !== known) {
    throw new CodecError("unknown_code", `the code is that of ${known.name}, not of ${entry?.name}`, offset);
  }
  return { kind: direction, name: known.name, header, message: known, data: known[direction].read(data, shape.headerSize, end) };
}

/** Whether a response without a code is an exception response: by another part, or by bytes in its data. */
function isUncodedException(exception, shape, data) {
  if (exception.mark === undefined) return isMarked(exception, shape, 0, data);
  const { headerSize, trailerSize } = shape;
  const { offset, bytes } = exception.mark;
  const at = headerSize + offset;
  return at + bytes.length <= data.length - trailerSize && matches(data, at, bytes);
}

/** Whether a response is an exception response: by a bit in its code, by its code, or by another part. */
function isMarked({ flag, code, part, all }, shape, own, data) {
  if (part === undefined) return code === undefined ? onBits(own, flag, (bits, mask) => bits & mask) !== 0 : own === code;
  const row = shape.header.find(({ name }) => name === part);
  return !within(all, readPart(data, row.offset, row));
}

/** The message that an exception response answers: null where its code is unknown, or where several messages have it. */
function answeredBy({ byCode }, code, entry) {
  const refused = byCode.refused.get(code) ?? [];
  return refused.length === 1 ? refused[0] : refused.find((message) => message === entry) ?? null;
}

/**
 * The message with a code, and with a number in its data where several have the code; or that of the request, `entry`,
 * where only the request tells. Throws CodecError.
 */
function knownBy({ byCode, subcodes }, shape, direction, code, body, entry, offset) {
  const shared = subcodes[direction]?.get(code);
  if (shared === undefined) return byCode[direction].get(code);
  if (shared.answers !== undefined) {
    if (shared.answers.includes(entry)) return entry;
    throw new CodecError("unknown_code", "several messages have the code: pass the one that was asked", offset);
  }
  if (body.length < shared.offset + shared.size) return shared.messages.values().next().value;
  const number = readCode(body, shared.offset, shared);
  const known = shared.messages.get(number);
  if (known === undefined) {
    throw new CodecError("unknown_code", `no message has the subcode 0x${number.toString(16)}`, shape.headerSize + shared.offset);
  }
  return known;
}

/**
 * A frame. `marks` are the numbers of the part that tells exception responses from others, if one does; `alone` is the
 * name of a message that cannot be broadcast.
 */
function encoded(context, shape, header, code, record, value, marks, alone = "") {
  for (const key in header) {
    if (!(key in shape.keys)) throw new CodecError("unknown_field", `the header has no part ${key.slice(0, 60)}`);
  }
  record.check(value);
  const { headerSize, trailerSize } = shape;
  const size = headerSize + (record.size === null ? record.least : record.size(value)) + trailerSize;
  const data = new Uint8Array(size);
  // Of several reasons to refuse, one in the body comes first, as in the other codecs.
  record.write(value, data, headerSize);
  if (alone !== "") refuseBroadcast(context, shape, header, alone);
  for (const part of shape.parts) {
    if (part.role !== "length" && part.role !== "checksum") {
      writePart(data, place(part.offset, size), part, partValue(context, part, header, code, marks));
    }
  }
  // What is escaped comes first: how many bytes are sent depends on all of its bytes.
  complete(shape, data, false);
  if (shape.escape !== null) complete(shape, data, true);
  return withDelimiters(context, shape, sentParts(shape, data));
}

/** Fills in the lengths and the checksums of the bytes that are sent, or those of the bytes before they are escaped. */
function complete(shape, data, ofSent) {
  for (const part of shape.lengths) {
    if (isOfSent(shape, part) !== ofSent) continue;
    const total = ofSent ? sentParts(shape, data).length : data.length;
    const units = (total - part.base) / part.unitSize;
    if (!Number.isInteger(units) || units < part.low || units > part.high) {
      throw new CodecError("wrong_length", `${part.name} cannot say that the frame has ${total} bytes`);
    }
    writePart(data, part.offset, part, units);
  }
  for (const part of shape.checksums) {
    if (isOfSent(shape, part) !== ofSent) continue;
    const covered = ofSent ? sentParts(shape, data) : data;
    const [start, stop] = [place(part.start, covered.length), place(part.stop, covered.length)];
    data.set(checksumBytes(part, covered, start, stop), place(part.offset, data.length));
  }
}

function refuseBroadcast({ unitAddresses }, shape, header, message) {
  const part = shape.header.find(({ role }) => role === "unit_address");
  if (header[part.key] == unitAddresses.broadcast) {
    throw new CodecError("out_of_range", `${part.name} is ${header[part.key]}: ${message} cannot be broadcast`);
  }
}

function partValue({ unitAddresses, exception }, part, header, code, marks) {
  if (part.constant !== null) return part.constant;
  if (part.role === "code") return code;
  const number = header[part.key];
  const address = part.role === "unit_address" ? unitAddresses : null;
  const isMark = marks !== undefined && exception?.part === part.name;
  const ranges = isMark ? marks : (address?.ranges ?? part.ranges);
  const whole = part.wide ? typeof number === "bigint" : Number.isInteger(number);
  if (whole && address !== null && number == address.broadcast) return number;
  if (!whole || number < part.low || number > part.high || (ranges !== null && !within(ranges, number))) {
    throw refusedNumber(part.name, number, rangesText(ranges ?? [[part.low, part.high]]), typeof part.low === "bigint");
  }
  return number;
}
