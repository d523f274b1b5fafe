import { isAmbiguous, isException, messageWithCode, refusedMessage } from "./device.js";
import { SENTENCES } from "./sentences.js";
import { hexOf, intervalsText, isWithin, latinOf, missingText, portableValue, sameBytes, sentence } from "./texts.js";
import { wholeOf } from "./interpreter.js";
import { decoded, decodeValue, judged, meaningOf, repeatedValue } from "./values.js";
import { endRows, escapeRow, factRow, rowData, Spot, startRows, surplusRow, wrongRow } from "./rows.js";
import { checksumOf, lengthNumber, originalPlaces, partOffset, unwrapped } from "./frames.js";
import { CodecError } from "../error.js";
import { accessedSpans, NOTHING, registerRows } from "./registers.js";
import { ExplainedBody } from "./body.js";
import { digitsNumber } from "../digit_texts.js";
import { exactWhole, onBits } from "../number_bits.js";
import { isWhole } from "./numbers.js";

/** The explanation of a whole frame as the answer to `request`, the explanation of another one, or null. Never throws. */
export function explained(device, link, direction, frame, message = "", request = null) {
  return new ExplainedFrame(device, link, direction, frame, message, request).explanation();
}

/** The reasons for which a codec refuses a frame; none if it accepts the frame. */
export function reasonsOf({ rows }) {
  return rows.map(({ reason }) => reason).filter((reason) => reason && reason !== "out_of_range");
}

/**
 * A frame while it is being explained. `data` are the bytes of its parts, `surplus` are those after them, and
 * `emptyEscape` those that an escape sends for no bytes at all.
 */
class ExplainedFrame {
  constructor(device, link, direction, frame, message, asked) {
    Object.assign(this, { device, direction, frame, asked });
    this.link = device.links.get(link);
    this.shape = this.link[direction];
    this.wrapped = unwrapped(this.link, direction, frame);
    this.spot = new Spot(frame, this.wrapped.start.length, this.link.transmission === "hex_ascii" ? 2 : 1);
    this.unreadable = null;
    this.emptyEscape = new Uint8Array();
    [this.sentData, this.surplus] = this.withoutSurplus(this.wrapped.data);
    this.data = this.shape.escape ? this.original(this.sentData) : this.sentData;
    this.named = message || (asked?.message ?? "");
    this.sent = this.link.carriedMessages[direction];
    this.message = this.sent.get(this.named);
    this.error = false;
    this.values = new Map();
  }

  /** The whole explanation. The header comes first, as its code tells what the body is. */
  explanation() {
    if (this.unreadable !== null) return this.unreadableFrame(this.unreadable);
    const rows = [...startRows(this.wrapped), ...this.partRows(this.shape.header, 0)];
    let registers = [];
    if (this.data.length >= this.shape.headerSize) {
      this.error ||= this.isMarked();
      const body = this.body();
      registers = body.registers;
      rows.push(...body.rows, ...this.tailRows());
    }
    if (this.surplus.length) rows.push(surplusRow(this.spot, this.data.length, this.surplus));
    rows.push(...endRows(this.wrapped));
    if (this.emptyEscape.length) {
      rows.push(escapeRow(this.spot, this.link, this.shape.escapeStart, this.emptyEscape));
      rows.sort((row, other) => row.offset - other.offset);
    }
    const errata = [...this.device.errataOfWords([this.link.path]), ...(this.message?.errata ?? [])];
    return this.result(this.message?.name ?? "", rows, registers, errata);
  }

  /** Whether a part or the data say that a frame without a code is an exception response. */
  isMarked() {
    const { exception } = this.link;
    if (!exception || this.direction === "request" || this.shape.code) return false;
    const { mark } = exception;
    if (!mark) return isException(exception, 0, (name) => this.partNumber(name));
    const at = this.shape.headerSize + mark.offset;
    return at + mark.bytes.length <= this.bodyEnd() && sameBytes(this.data.subarray(at, at + mark.bytes.length), mark.bytes);
  }

  /** The offset of the first byte after the body. */
  bodyEnd() {
    const { headerSize, trailerSize } = this.shape;
    return this.wrapped.whole ? Math.max(headerSize, this.data.length - trailerSize) : this.data.length;
  }

  result(message, rows, registers, errata) {
    const { link, direction, error, frame, values } = this;
    return { link: link.name, direction, message, error, frame, rows, registers, values, errata };
  }

  /** The bytes of the parts before they were escaped; finds out where they are in the frame. */
  original(sent) {
    const { escape, escapeStart: start, escapeStop } = this.shape;
    if (sent.length < this.shape.headerSize + this.shape.trailerSize) return sent;
    const stop = sent.length + escapeStop;
    let originals;
    try {
      originals = originalPlaces(escape, sent.subarray(start, stop));
    } catch (error) {
      if (!(error instanceof CodecError)) throw error;
      this.unreadable = { at: start + error.offset, detail: error.detail };
      return sent;
    }
    if (!originals.length) this.emptyEscape = sent.subarray(start, stop);
    const inner = originals.map(([, place]) => place + start);
    if (inner.length) inner[0] = start;  // what is sent before the first byte belongs to it
    const data = Uint8Array.from([...sent.subarray(0, start), ...originals.map(([byte]) => byte), ...sent.subarray(stop)]);
    const end = sent.length + this.surplus.length;
    this.spot.places = [
      ...Array.from({ length: start }, (_, at) => at),
      ...inner,
      ...Array.from({ length: end + 1 - stop }, (_, at) => stop + at),
    ];
    this.spot.escape = escape;
    this.spot.gap = originals.length ? null : start;
    this.spot.originals = Uint8Array.from([...data, ...this.surplus]);
    return data;
  }

  /** The explanation of a frame with bytes that are the escape of nothing, from the byte `at` on. */
  unreadableFrame({ at, detail }) {
    const [start, stop] = [this.shape.escapeStart, this.data.length + this.shape.escapeStop];
    const { escape } = this.shape;
    const text = escape.method === "can"
      ? detail
      : sentence(SENTENCES.NOT_ESCAPED, { offset: this.wrapped.start.length + at });
    const rows = [...startRows(this.wrapped), ...this.outsideRows(this.shape.header)];
    rows.push(wrongRow(this.spot, start, this.data.subarray(start, stop), "wrong_mark", text));
    rows.push(...this.outsideRows(this.shape.trailer));
    if (this.surplus.length) rows.push(surplusRow(this.spot, this.data.length, this.surplus));
    rows.push(...endRows(this.wrapped));
    this.values = new Map();
    this.error = false;
    return this.result(this.named, rows, [], []);
  }

  /** The rows of parts that are not escaped. */
  outsideRows(parts) {
    return parts.filter(({ escaped }) => !escaped).map((part) => {
      const at = partOffset(part, this.data.length);
      const data = this.data.subarray(at, at + part.size);
      return this.partRow(part, at, data);
    });
  }

  partRow(part, at, data) {
    return factRow(this.device, "part", part.name, part, this.spot, at, data, this.partValue(part, data), this.link);
  }

  /** The bytes whose length or checksum a part has: those that are sent, or those before they are escaped. */
  measuredBytes(part) {
    return this.shape.escape && !part.beforeEscape ? this.sentData : this.data;
  }

  /** The bytes of the parts and those after them: length and checksum may show that the frame ends earlier. */
  withoutSurplus(data) {
    const nothing = data.subarray(data.length);
    const ofSent = (part) => !this.shape.escape || !part.beforeEscape;
    const [length] = this.shape.lengths.filter(ofSent);
    const checks = this.shape.checks.filter(ofSent);
    if (!length || !checks.length || !this.wrapped.whole) return [data, nothing];
    const number = Number(numberOf(length, data));
    const stated = number * (length.unitSize ?? 1) + (length.base ?? 0);
    const early = this.shape.headerSize + this.shape.trailerSize <= stated && stated < data.length;
    const isRight = (bytes) => checks.every((check) => {
      const at = partOffset(check, bytes.length);
      return sameBytes(checksumOf(check, bytes), bytes.subarray(at, at + check.size));
    });
    if (early && !isRight(data) && isRight(data.subarray(0, stated))) return [data.subarray(0, stated), data.subarray(stated)];
    return [data, nothing];
  }

  /** The rows of parts, whose offsets count from `base`, up to the first one that is not whole. */
  partRows(parts, base) {
    const rows = [];
    for (const part of parts) {
      const at = base + part.offset;
      const data = this.data.subarray(at, at + part.size);
      if (data.length < part.size) {
        if (this.wrapped.whole || data.length) rows.push(this.shortRow(part, at, data));
        return rows;
      }
      rows.push(this.partRow(part, at, data));
    }
    return rows;
  }

  shortRow(part, at, data) {
    const missing = part.size - data.length;
    return wrongRow(this.spot, at, data, "incomplete", missingText(missing, part.name), part.name, part.path);
  }

  /** The value of a part, judged by its role. */
  partValue(part, raw) {
    if (part.role === "checksum") return this.checkedValue(part, raw);
    const read = decodeValue(this.device, part.value, raw, part.reserved);
    if (part.reserved || !isWhole(read.number)) return read;
    if (part.role === "length") return this.judgedLength(part, read);
    if (part.offset < 0) return read;
    this.values.set(part.name, read.number);
    if (part.role === "code") return this.codeValue(part, read);
    if (part.role === "unit_address") return this.addressValue(read);
    const should = part.sameAs ? this.asked?.values.get(part.sameAs) : undefined;
    return read.reason || should === undefined ? read : repeatedValue(read, should);
  }

  /** A length, compared with the bytes that it counts. */
  judgedLength(part, read) {
    if (!this.wrapped.whole) return read;
    const should = lengthNumber(part, this.measuredBytes(part).length);
    return judged(read, should !== undefined && read.number == should, should ?? SENTENCES.ANOTHER_LENGTH, "wrong_length");
  }

  /** A checksum, compared with the one that the bytes have. */
  checkedValue(part, raw) {
    const read = decoded(part.digits ? latinOf(raw) : wholeOf(raw, part.order ?? "big", false));
    if (!this.wrapped.whole) return read;
    const should = checksumOf(part, this.measuredBytes(part));
    return judged(read, sameBytes(raw, should), part.digits ? latinOf(should) : hexOf(should, " "), "wrong_checksum");
  }

  /** The message that a code names. An exception response marks the code. */
  codeValue(part, read) {
    let code = exactWhole(read.number);
    if (this.shape.escape?.remote !== undefined) {
      read = { ...read, number: onBits(code, 2 ** 30, (bits, flag) => bits & ~flag) };
      this.values.set(part.name, read.number);
    }
    const { link, direction } = this;
    const { exception } = link;
    if (exception && direction === "response" && isException(exception, code, (name) => this.partNumber(name))) {
      this.error = true;
      code = onBits(code, exception.flag, (bits, mask) => bits & ~mask);
      this.values.set(part.name, code);
      if (exception.code !== undefined) return this.refusingCode(read);
    }
    const end = this.data.length - this.shape.trailerSize;
    const body = this.data.subarray(this.shape.headerSize, Math.max(this.shape.headerSize, end));
    this.message = this.error
      ? refusedMessage(link, code, this.named)
      : messageWithCode(link, direction, code, body, this.named);
    if (!this.message) {
      const digits = code.toString(16).padStart(2, "0");
      if (this.error) return { ...read, meanings: [meaningOf("", "", sentence(SENTENCES.CODE_REFUSED, { code: `0x${digits}` }))] };
      if (isAmbiguous(link, direction, code)) {
        const names = link.messagesByCode[direction].get(code).map(({ name }) => name).join(", ");
        return judged(read, false, sentence(SENTENCES.SHARED_CODE, { names }), "unknown_code");
      }
      const known = Object.values(link.codes[direction]).join(", ");
      const several = sentence(known ? SENTENCES.PERMITTED_NAMES : SENTENCES.CODE_OF_NONE, { names: known, direction });
      return judged(read, false, this.sent.has(this.named) ? link.codes[direction][this.named] : several, "unknown_code");
    }
    const { name, label, title = "", notes = [], path } = this.message;
    const text = this.error ? sentence(SENTENCES.REFUSED_CODE, { message: title || label || name }) : title;
    const meaning = { ...read, meanings: [meaningOf(name, label, text)], notes, facts: [path] };
    const expected = this.sent.get(this.named);
    if (!expected || expected === this.message || this.error) return meaning;
    return judged(meaning, false, link.codes[direction][this.named], "unknown_code");
  }

  /** The code of all exception responses, which does not say what it answers: only the request does. */
  refusingCode(read) {
    this.message = this.link.carriedMessages.request.get(this.named);
    if (!this.message) return { ...read, meanings: [meaningOf("", "", SENTENCES.REQUEST_REFUSED)] };
    const { name, label, title, notes = [], path } = this.message;
    const text = sentence(SENTENCES.MESSAGE_REFUSED, { message: title || label || name });
    return { ...read, meanings: [meaningOf("", "", text)], notes, facts: [path] };
  }

  /** The number of a part before the body; undefined where bytes of it are missing. */
  partNumber(name) {
    const part = this.shape.header.find((own) => own.name === name);
    return part.offset + part.size <= this.data.length ? numberOf(part, this.data) : undefined;
  }

  addressValue(read) {
    const { addresses } = this.link;
    if (!addresses?.ranges) return read;
    if (addresses.broadcast !== undefined && read.number == addresses.broadcast) {
      return { ...read, meanings: [meaningOf("broadcast", "", SENTENCES.BROADCAST)], verdict: "", reason: "" };
    }
    if (isWithin(addresses.ranges, read.number)) return read;
    return judged(read, false, intervalsText(addresses.ranges), "out_of_range");
  }

  /** The rows of the body, and those of the registers that it reads or writes. */
  body() {
    const start = this.shape.headerSize;
    const end = this.bodyEnd();
    const isException = this.error && this.link.exception;
    const record = isException ? this.device.records.get(this.link.exception.record) : this.message?.[this.direction];
    if (!record) return { rows: this.unknownRows(start, end), registers: [] };
    const { message } = this;
    const asked = this.asked?.values ?? NOTHING;
    const isRequest = Boolean(message) && record === message.request;
    const body = new ExplainedBody(this.device, record, message ?? record, isRequest, this.data, start, end, this.spot, asked);
    for (const [name, value] of body.values) this.values.set(name, value);
    const rows = body.rows.filter((row) => this.wrapped.whole || row.kind !== "unexplained" || row.length);
    if (!message || this.error) return { rows, registers: [] };
    const answered = this.direction === "request" ? null : asked;
    const spans = accessedSpans(message, record, start, this.data.subarray(start, Math.max(start, end)), body.values, answered);
    return { rows, registers: spans.flatMap(([{ operation }, span]) => registerRows(this.device, span, this.spot, operation)) };
  }

  /** The row of a body that nothing describes. */
  unknownRows(start, end) {
    const data = this.data.subarray(start, end);
    if (!this.shape.code) return [wrongRow(this.spot, start, data, "unknown_code", SENTENCES.NO_CODE)];
    if (end <= start) return [];
    return [{ ...wrongRow(this.spot, start, data, "", ""), verdict: "", doc: SENTENCES.UNKNOWN_DATA }];
  }

  tailRows() {
    const { headerSize, trailerSize, trailer } = this.shape;
    return this.wrapped.whole ? this.partRows(trailer, Math.max(headerSize + trailerSize, this.data.length)) : [];
  }
}

/** The number of a part before the body, as far as the bytes reach; NaN for what are not its digits. */
function numberOf({ offset, size, order, value }, data) {
  const bytes = data.subarray(offset, offset + size);
  if (value.digits) return (bytes.length === size ? digitsNumber(value, bytes) : undefined) ?? NaN;
  return wholeOf(bytes, order === "little" ? "little" : "big", value.signed);
}

/** The names of the messages whose body can be as long as that of a frame. */
export function namesOfLength(link, direction, frame) {
  const { length } = unwrapped(link, direction, frame).data;
  const fitting = link.lengths[direction].filter(([, least, most]) => least <= length && (most === null || length <= most));
  return fitting.map(([name]) => name);
}

/** Readings as data: link, direction, message and whether it is an exception response. */
function readingData([link, direction, message, error]) {
  return { link, direction, message: message || null, error };
}

/** An explanation as data, with the readings that fit, how one of them was chosen, and remarks on the input. */
export function explanationData(device, explanation, readings, chosen, remarks, wrong) {
  const rows = [...explanation.rows, ...explanation.registers];
  const errata = new Set([...explanation.errata, ...rows.flatMap((row) => row.errata)]);
  return {
    device: device.data.device,
    version: device.data.version,
    frame: hexOf(explanation.frame),
    link: explanation.link,
    direction: explanation.direction,
    direction_name: device.links.get(explanation.link).directionNames[explanation.direction],
    message: explanation.message || null,
    error: explanation.error,
    wrong,
    reasons: reasonsOf(explanation),
    chosen,
    readings: readings.map(readingData),
    remarks,
    values: portableValue(explanation.values),
    rows: explanation.rows.map(rowData),
    registers: explanation.registers.map(rowData),
    errata: device.data.errata.filter(({ id }) => errata.has(id)),
  };
}
