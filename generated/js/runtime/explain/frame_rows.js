import { Body } from "./body.js";
import { DecodedValue, Meaning, decodeValue, repeatedValue, whole } from "./values.js";
import { EscapeError, originalPlaces } from "./links.js";
import { Explanation } from "./explained_frame.js";
import { NO_REGISTERS, RegisterRows } from "./registers.js";
import { SENTENCES } from "./sentences.js";
import { Spot, endRows, escapeRow, factRow, startRows, surplusRow, unwrapped, wrongRow } from "./row.js";
import { accessedSpans } from "./spans.js";
import { errataOfMessage, errataOfWords } from "./device.js";
import { missingText } from "./texts.js";
import { py } from "./python.js";

/** The rows of a frame: every byte of it, also of one that is wrong. */

/** The explanation of a frame that answers a request which is explained already. Raises as `explained` does. */
export function explainedAfter(layout, link, direction, frame, message, request) {
  return (new FrameRowsFrame(layout, link, direction, frame, message, request)).explanation();
}

/** Whether a checksum is wrong, so that no reading of the frame in this direction fits. */
export function isDamaged(layout, link, direction, frame) {
  return (new FrameRowsFrame(layout, link, direction, frame, "", null)).isDamaged;
}

/**
 * A frame while it is being explained. `data` are the bytes of its parts, `surplus` are those after them.
 *
 * `empty_escape` are the bytes that an escape sends for no bytes at all.
 */
class FrameRowsFrame {
  constructor(layout, link, direction, frame, message, request) {
    [this.layout, this.link, this.direction, this.frame] = [layout, py.item(layout.links, link).link, direction, frame];
    this.shape = py.item(layout.links, link).frame(direction);
    this.asked = request;
    this.wrapped = unwrapped(this.link, direction, frame);
    this.spot = new Spot({
      frame,
      start: this.wrapped.start.length,
      width: this.link.transmission === "hex_ascii" ? 2 : 1,
    });
    this.unreadable = null;
    this.emptyEscape = Uint8Array.of();
    [this.sentData, this.surplus] = this._withoutSurplus(this.wrapped.data);
    this.data = this.shape.escape != null ? this._original(this.sentData) : this.sentData;
    this.named = message || (py.truth(request) ? request.message : "");
    this.sent = py.item(layout.links, link).carried(direction);
    this.message = this.sent.get(this.named);
    this.error = false;
    this.values = py.dict([]);
    this.accessed = null;
  }

  /** The whole explanation. The header comes first, because its code determines the body. */
  explanation() {
    if (this.unreadable != null) {
      return this._unreadable(this.unreadable);
    }
    let rows = [...startRows(this.wrapped), ...this._parts(this.shape.header, 0)];
    let registers = NO_REGISTERS;
    if (this.data.length >= this.shape.headerSize) {
      this.error = this.error || this._isMarked();
      let bodyRows;
      [bodyRows, registers] = this._body();
      rows = [...rows, ...bodyRows, ...this._tail()];
    }
    if (py.truth(this.surplus)) {
      rows.push(surplusRow(this.spot, this.data.length, this.surplus));
    }
    rows = [...rows, ...endRows(this.wrapped)];
    if (py.truth(this.emptyEscape)) {
      const row = escapeRow(this.spot, this.link, this.shape.escapeStart, this.emptyEscape);
      rows = py.sorted([...rows, row], (row) => row.offset);
    }
    let [errata, name] = [errataOfWords(this.layout.device, [this.link.path]), ""];
    if (this.message != null) {
      errata = [...errata, ...errataOfMessage(this.layout.device, this.message.message)];
      name = this.message.name;
    }
    return new Explanation({
      link: this.link.name,
      direction: this.direction,
      message: name,
      error: this.error,
      frame: this.frame,
      rows: py.tuple(rows),
      registerRows: registers,
      values: this.values,
      errata,
      accessed: this.accessed,
    });
  }

  /** Whether the parts are whole, and one of their checksums is wrong. */
  get isDamaged() {
    const partsSize = this.shape.headerSize + this.shape.trailerSize;
    if (this.unreadable != null || !this.wrapped.whole || this.data.length < partsSize) {
      return false;
    }
    return [...this.shape.checksums].some((part) => !py.equal(part.checksum(this._measured(part)), py.slice(py.slice(this.data, part.at(this.data.length)), undefined, part.size)));
  }

  /** Whether a part or the data say that a frame without a code is an exception response. */
  _isMarked() {
    const link = py.item(this.layout.links, this.link.name);
    const refusal = link.link.exceptionResponse;
    if (refusal == null || this.direction === "request" || !link.hasUncodedExceptions) {
      return false;
    }
    if (link.mark != null) {
      return link.mark.isIn(py.slice(this.data, this.shape.headerSize, this._bodyEnd()));
    }
    return refusal.isMarked(0, this.shape.numbers(this.data));
  }

  /** The offset of the first byte after the body. */
  _bodyEnd() {
    const [shape, size] = [this.shape, this.data.length];
    return this.wrapped.whole ? py.max(shape.headerSize, size - shape.trailerSize) : size;
  }

  /** The bytes of the parts before they were escaped; finds out where they are in the frame. */
  _original(escapedData) {
    let originals;
    const shape = this.shape;
    if (escapedData.length < (shape.headerSize + shape.trailerSize)) {
      return escapedData;
    }
    const [start, stop] = [shape.escapeStart, escapedData.length + py.either(shape.escapeStop, () => 0)];
    try {
      originals = originalPlaces(shape.escape, py.slice(escapedData, start, stop));
    } catch (error) {
      if (!(error instanceof EscapeError)) throw error;
      this.unreadable = start + error.offset;
      return escapedData;
    }
    this.emptyEscape = py.truth(originals) ? Uint8Array.of() : py.slice(escapedData, start, stop);
    const inner = [...py.enumerate(originals)].map(([number, [, place]]) => py.truth(number) ? (place + start) : start);
    const data = py.bytes([...py.slice(escapedData, undefined, start), ...[...originals].map(([byte, ]) => byte), ...py.slice(escapedData, stop)]);
    const end = escapedData.length + this.surplus.length;
    this.spot = py.replace(this.spot, {
      places: [...py.range(start), ...inner, ...py.range(stop, end + 1)],
      originals: py.bytes([...data, ...(this.surplus ?? [])]),
      escape: shape.escape,
      gap: py.truth(originals) ? null : start,
    });
    return data;
  }

  /** The explanation of a frame with bytes that are the escape of nothing, from the byte at `offset` on. */
  _unreadable(offset) {
    const [start, stop] = [this.shape.escapeStart, this.data.length + py.either(this.shape.escapeStop, () => 0)];
    let text = py.format(SENTENCES.NOT_ESCAPED, { offset: this.wrapped.start.length + offset });
    if (this.shape.escape != null && this.shape.escape.method === "can") {
      text = this.shape.escape.headerFault(py.slice(this.data, start, stop), offset - start);
    }
    let rows = [...startRows(this.wrapped), ...this._unescapedRows(this.shape.header)];
    rows.push(wrongRow(this.spot, start, py.slice(this.data, start, stop), "wrong_mark", text));
    rows = [...rows, ...this._unescapedRows(this.shape.trailer)];
    if (py.truth(this.surplus)) {
      rows.push(surplusRow(this.spot, this.data.length, this.surplus));
    }
    rows = [...rows, ...endRows(this.wrapped)];
    return new Explanation({
      link: this.link.name,
      direction: this.direction,
      message: this.named,
      error: false,
      frame: this.frame,
      rows: py.tuple(rows),
      registerRows: NO_REGISTERS,
      values: py.dict([]),
    });
  }

  /** The rows of parts that are not escaped. */
  *_unescapedRows(parts) {
    for (const part of parts) {
      if (!py.truth(part.escaped)) {
        const offset = part.at(this.data.length);
        const data = py.slice(this.data, offset, offset + part.size);
        yield this._part(part, offset, data, this._partText(part, data));
      }
    }
  }

  /** The bytes whose length or checksum a part has: those that are sent, or those before they are escaped. */
  _measured(part) {
    return (this.shape.escape != null && !py.truth(part.beforeEscape)) ? this.sentData : this.data;
  }

  /** The bytes of the parts and those after them: length and checksum may show that the frame ends earlier. */
  _withoutSurplus(data) {
    const isEscaped = this.shape.escape != null;
    const length = py.next([...this.shape.lengths].filter((part) => !isEscaped || !py.truth(part.beforeEscape)), null);
    const checks = [...this.shape.checksums].filter((part) => !isEscaped || !py.truth(part.beforeEscape));
    if (length == null || !py.truth(checks) || !this.wrapped.whole) {
      return [data, Uint8Array.of()];
    }
    const number = length.read(py.slice(data, length.offset, length.offset + length.size));
    const stated = number != null ? (number * length.unitSize + length.base) : 0;
    const early = (this.shape.headerSize + this.shape.trailerSize) <= stated && stated < data.length;
    if (early && !frameRowsIsRight(checks, data) && frameRowsIsRight(checks, py.slice(data, undefined, stated))) {
      return [py.slice(data, undefined, stated), py.slice(data, stated)];
    }
    return [data, Uint8Array.of()];
  }

  /** The rows of parts, whose offsets count from `base`, up to the first one that is not whole. */
  *_parts(parts, base) {
    for (const part of parts) {
      const offset = base + part.offset;
      const data = py.slice(this.data, offset, offset + part.size);
      if (data.length < part.size) {
        if (this.wrapped.whole || py.truth(data)) {
          yield this._short(part, offset, data);
        }
        return;
      }
      yield this._part(part, offset, data, this._partText(part, data));
    }
  }

  _part(part, offset, data, read) {
    return factRow(this.layout.device, "part", part.name, part.part, this.spot, offset, data, read, this.link);
  }

  _short(part, offset, data) {
    const missing = part.size - data.length;
    const text = missingText(missing, part.name);
    return wrongRow(this.spot, offset, data, "incomplete", text, part.name, part.part.path);
  }

  /** The value of a part, judged by its role. */
  _partText(part, raw) {
    if (part.role === "checksum") {
      return this._checked(part, raw);
    }
    if (part.reserved) {
      return decodeValue(this.layout.device, part.value, part.ownBytes(raw), part.order, false, part.reserved);
    }
    const read = decodeValue(this.layout.device, part.value, part.ownBytes(raw), part.order, false);
    if (!py.isWhole(read.number)) {
      return read;
    }
    if (part.role === "length") {
      return this._judgedLength(part, read);
    }
    if (part.offset < 0) {
      return read;
    }
    py.put(this.values, part.name, this.shape.statedNumber(part, read.number));
    if (part.role === "code") {
      return this._code(part, py.replace(read, { number: py.item(this.values, part.name) }), read.number);
    }
    if (part.role === "unit_address") {
      return this._unitAddress(read);
    }
    const stated = py.truth(this.asked) ? this.asked.values.get(part.part.sameAs) : null;
    return (read.reason || stated == null) ? read : repeatedValue(read, stated, part.value);
  }

  /** A length, compared with the bytes that it counts. */
  _judgedLength(part, read) {
    if (!this.wrapped.whole) {
      return read;
    }
    const expected = part.number(this._measured(part).length);
    const right = expected != null && py.equal(read.number, expected);
    return read.judged(right, expected != null ? expected : SENTENCES.ANOTHER_LENGTH, "wrong_length");
  }

  /** A checksum, compared with the one that the bytes have. */
  _checked(part, raw) {
    const read = new DecodedValue(py.truth(part.digits) ? py.decode(raw, "latin-1") : whole(raw, part.order));
    if (!this.wrapped.whole) {
      return read;
    }
    const expected = part.checksum(this._measured(part));
    const text = py.truth(part.digits) ? py.decode(expected, "ascii") : py.hex(expected, " ").toUpperCase();
    return read.judged(py.equal(raw, expected), text, "wrong_checksum");
  }

  /** The message that a code names. An exception response marks the code. */
  _code(part, read, code) {
    let expected, message, text;
    const refusal = this.link.exceptionResponse;
    const head = this.shape.numbers(this.data);
    if (refusal != null && this.direction === "response" && refusal.isMarked(code, head)) {
      this.error = true;
      code = py.without(code, refusal.flag);
      py.put(this.values, part.name, code);
      if (refusal.code != null) {
        return this._refusingCode(read);
      }
    }
    const link = py.item(this.layout.links, this.link.name);
    const start = this.shape.headerSize;
    const end = py.max(start, this.data.length - this.shape.trailerSize);
    if (this.error) {
      this.message = link.refusedMessage(code, this.named);
    } else {
      this.message = link.messageWithCode(code, this.direction, py.slice(this.data, start, end), this.named);
    }
    if (this.message == null) {
      if (this.error) {
        text = py.format(SENTENCES.CODE_REFUSED, { code: `0x${py.hexadecimal(code, "02x")}` });
        return py.replace(read, { meanings: [new Meaning("", "", text, "")] });
      }
      const ambiguous = link.ambiguousCodes(this.direction).get(code);
      if (ambiguous != null) {
        const names = py.join(", ", [...ambiguous].map((message) => message.name));
        return read.judged(false, py.format(SENTENCES.SHARED_CODE, { names }), "unknown_code");
      }
      expected = this.sent.get(this.named);
      const known = py.join(", ", [...this.sent.values()].map((message) => link.codeText(message, this.direction)));
      const sentence = known ? SENTENCES.PERMITTED_NAMES : SENTENCES.CODE_OF_NONE;
      const severalText = py.format(sentence, { names: known, direction: this.direction });
      text = expected == null ? severalText : link.codeText(expected, this.direction);
      return read.judged(false, text, "unknown_code");
    }
    message = this.message.message;
    const title = py.either(message.title, () => message.label || message.name);
    text = this.error ? py.format(SENTENCES.REFUSED_CODE, { message: title }) : message.title;
    const meaning = new Meaning(message.name, message.label, text, "");
    read = py.replace(read, { meanings: [meaning], notes: message.notes, facts: [message.path] });
    expected = this.sent.get(this.named);
    if (expected == null || expected === this.message || this.error) {
      return read;
    }
    return read.judged(false, link.codeText(expected, this.direction), "unknown_code");
  }

  /** The code of all exception responses, which does not say what it answers: only the request does. */
  _refusingCode(read) {
    this.message = py.item(this.layout.links, this.link.name).carried("request").get(this.named);
    if (this.message == null) {
      return py.replace(read, { meanings: [new Meaning("", "", SENTENCES.REQUEST_REFUSED, "")] });
    }
    const message = this.message.message;
    const text = py.format(SENTENCES.MESSAGE_REFUSED, { message: py.either(message.title, () => message.label || message.name) });
    return py.replace(read, {
      meanings: [new Meaning("", "", text, "")],
      notes: message.notes,
      facts: [message.path],
    });
  }

  _unitAddress(read) {
    const addresses = this.link.unitAddresses;
    if (addresses == null || addresses.ranges == null) {
      return read;
    }
    if (py.equal(read.number, addresses.broadcast)) {
      return py.replace(read, {
        meanings: [new Meaning("broadcast", "", SENTENCES.BROADCAST, "")],
        verdict: "",
        reason: "",
      });
    }
    if (py.has(addresses.ranges, read.number)) {
      return read;
    }
    return read.judged(false, addresses.ranges.text(), "out_of_range");
  }

  /** The record of the body; None where no message is known. */
  _record() {
    if (this.error && this.link.exceptionResponse != null) {
      return py.item(this.layout.records, this.link.exceptionResponse.record);
    }
    return this.message ? this.message.data(this.direction) : null;
  }

  /** The rows of the body, and of the registers that it reads or writes. */
  _body() {
    let span;
    const [start, record] = [this.shape.headerSize, this._record()];
    const end = this._bodyEnd();
    if (record == null) {
      return [py.list(this._unknown(start, end)), NO_REGISTERS];
    }
    const message = this.message ? this.message.message : null;
    const requestValues = py.truth(this.asked) ? this.asked.values : py.dict([]);
    const body = new Body(this.layout, record, py.either(message, () => record.record), this.data, start, end, this.spot, requestValues);
    this.values.update(body.values);
    const rows = [...body.rows].filter((row) => this.wrapped.whole || row.kind !== "unexplained" || row.length);
    if (message == null || this.error) {
      return [rows, NO_REGISTERS];
    }
    const answeredValues = this.direction === "response" ? requestValues : null;
    const bodyBytes = [start, py.slice(this.data, start, end)];
    const accesses = py.list(accessedSpans(this.layout, message, record, bodyBytes, body.values, answeredValues));
    if (message.singleAccess != null && py.truth(accesses)) {
      [[, span]] = accesses;
      this.accessed = [span.address, span.end - 1];
    }
    return [rows, new RegisterRows(this.layout, this.spot, [...accesses].map(([access, span]) => [access.operation, span]))];
  }

  /** The row of a body that nothing describes. */
  *_unknown(start, end) {
    if (this.shape.role("code") == null) {
      yield wrongRow(this.spot, start, py.slice(this.data, start, end), "unknown_code", SENTENCES.NO_CODE);
    } else if (end > start) {
      const row = wrongRow(this.spot, start, py.slice(this.data, start, end), "", "");
      yield py.replace(row, { verdict: "", doc: SENTENCES.UNKNOWN_DATA });
    }
  }

  _tail() {
    const end = py.max(this.shape.headerSize + this.shape.trailerSize, this.data.length);
    return this._parts(this.wrapped.whole ? this.shape.trailer : [], end);
  }
}

/** Whether the parts carry the checksums that they should. */
function frameRowsIsRight(checks, data) {
  return [...checks].every((check) => py.equal(check.checksum(data), py.slice(py.slice(data, check.at(data.length)), undefined, check.size)));
}
