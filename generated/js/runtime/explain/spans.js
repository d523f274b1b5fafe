import { BIT, BYTE, WORD, hasWordDigits, unpackedBits, wordBytes } from "./layouts.js";
import { py } from "./python.js";

/** The addresses that a frame reads or writes, with the bytes at them. */

/**
 * Bytes at `at` in the parts of a frame, and the bytes of the value that they carry.
 *
 * These are other bytes for a bit, one with 0 or 1, and for hexadecimal digits.
 */
export class Piece {
  constructor({ at, raw, content }) {
    this.at = at;
    this.raw = raw;
    this.content = content;
  }
}

/**
 * `words` from `address` on in a space. `data` are their bytes in the frame, at `at` in its parts, or empty.
 *
 * In a space of bits, `words` counts these, and `bits` has those that the frame carries, in order. A single one is
 * None if its number means neither 0 nor 1. In other spaces, `bits` is None. In a space of bytes, `words` counts
 * bytes, and an address has a `unit_size` of 1. `digits` are the hexadecimal digits that the frame has for `data`, two
 * for each byte; empty if it has the bytes themselves.
 */
export class Span {
  constructor({ space, address, words, at, data, bits = null, unitSize = 2, digits = Uint8Array.of() }) {
    this.space = space;
    this.address = address;
    this.words = words;
    this.at = at;
    this.data = data;
    this.bits = bits;
    this.unitSize = unitSize;
    this.digits = digits;
  }

  /** The address after the last word. */
  get end() {
    return this.address + this.words;
  }

  /** What one address of the space has: `word`, `byte` or `bit`. */
  get unit() {
    return this.bits != null ? BIT : py.equal(this.unitSize, 2) ? WORD : BYTE;
  }

  /**
   * The piece of the frame with a value of `size` bytes, `skip` bytes after an address; None unless the frame
   * has all of it.
   */
  piece(address, size, skip = 0) {
    if (this.bits != null) {
      return this._bit(address - this.address, this.bits);
    }
    const start = this.unitSize * (address - this.address) + skip;
    if (start < 0 || (start + size) > this.data.length) {
      return null;
    }
    const content = py.slice(this.data, start, start + size);
    if (py.truth(this.digits)) {
      return new Piece({
        at: this.at + (2 * start),
        raw: py.slice(this.digits, 2 * start, 2 * (start + size)),
        content,
      });
    }
    return new Piece({ at: this.at + start, raw: content, content });
  }

  _bit(index, bits) {
    const bit = 0 <= index && index < bits.length ? py.item(bits, index) : null;
    if (bit == null) {
      return null;
    }
    const [start, end] = bits.length === 1 ? [0, this.data.length] : [Math.floor(index / 8), Math.floor(index / 8) + 1];
    return new Piece({ at: this.at + start, raw: py.slice(this.data, start, end), content: py.bytes([bit]) });
  }

  /** The offset and the bytes of neighbouring words; none for bits, which share bytes with others. */
  unlisted(first, end) {
    const piece = this.bits == null ? this.piece(first, this.unitSize * (end - first)) : null;
    return piece != null ? [piece.at, piece.raw] : [0, Uint8Array.of()];
  }
}

/**
 * The words or bits that a message accesses, by its own values or values of the request that it answers.
 *
 * `data` are the bytes of the words, at `offset` in the parts; empty if the message does not carry them. None if the
 * words are unknown.
 */
export function accessed(device, access, values, requestValues, offset, data) {
  const start = (values.get(access.start) ?? requestValues.get(access.start));
  if (!py.isWhole(start)) {
    return null;
  }
  const space = device.space(access.space);
  const [isBits, size] = [space.unit === BIT, space.unitSize];
  if (access.set != null) {
    const number = py.truth(data) ? values.get(access.values) : null;
    const bit = py.equal(number, access.set) ? 1 : py.equal(number, access.clear) ? 0 : null;
    return new Span({ space: access.space, address: py.int(start), words: 1, at: offset, data, bits: [bit] });
  }
  const carried = isBits ? (8 * data.length) : Math.floor(data.length / size);
  const count = py.truth(access.count) ? (values.get(access.count) ?? requestValues.get(access.count)) : null;
  const unstated = py.truth(access.count) ? carried : isBits ? 1 : py.max(carried, 1);
  const words = py.isWhole(count) ? py.int(count) : unstated;
  if (isBits) {
    return new Span({
      space: access.space,
      address: py.int(start),
      words,
      at: offset,
      data,
      bits: py.slice(py.tuple(unpackedBits(data)), undefined, words),
    });
  }
  return new Span({
    space: access.space,
    address: py.int(start),
    words,
    at: offset,
    data: py.slice(data, undefined, carried * size),
    unitSize: size,
  });
}

/**
 * The accesses of a message with what they access. If there are several, a response has the reading ones.
 *
 * `body` is where the data begin in the parts of a frame, and their bytes. `request_values` are the values of the
 * request that a response answers, None for a request.
 */
export function* accessedSpans(layout, message, record, body, values, requestValues) {
  const [start, data] = body;
  const [isSingle, isResponse] = [message.singleAccess != null, requestValues != null];
  for (const access of message.accesses) {
    if (isResponse && !isSingle && access.operation === "write") {
      continue;
    }
    const isCarried = isSingle || (access.operation === "read") === isResponse;
    const field = isCarried ? record.named(access.values) : null;
    const [offset, content] = field != null ? [field.offset, py.slice(data, field.offset, field.end)] : [0, Uint8Array.of()];
    const carried = field != null ? wordBytes(field, content) : Uint8Array.of();
    const own = (isSingle || !isResponse) ? values : py.dict([]);
    let span = accessed(layout.device, access, own, py.either(requestValues, () => py.dict([])), start + offset, carried);
    if (span != null && field != null && py.truth(hasWordDigits(field))) {
      span = py.replace(span, { digits: content });
    }
    if (span != null) {
      yield [access, span];
    }
  }
}
