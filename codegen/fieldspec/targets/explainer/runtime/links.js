import { CodecError } from "../error.js";
import { digitsNumber } from "../digit_texts.js";
import { canBytes, isRemoteRequest } from "../escapes.js";
import { exactWhole, onBits } from "../number_bits.js";
import { py } from "./python.js";
import { checksumOf, lengthNumber, partOffset } from "./frames.js";
import { bytesOfNumber, unsignedOf, wholeOf } from "./interpreter.js";
import { bytesOfHex, intervalsText, isWithin } from "./texts.js";

// Links and their frames by the names that the modules of `codec/explain` have for them.

export const [CAN_EXTENDED, CAN_REMOTE, CAN_HEADER] = [2 ** 31, 2 ** 30, 8];
export const EscapeError = CodecError;

/** Some intervals of numbers. */
class Ranges {
  constructor(intervals) {
    this.intervals = intervals;
  }

  has(number) {
    return isWithin(this.intervals, number);
  }

  text() {
    return intervalsText(this.intervals);
  }
}

/** How bytes are escaped; `bytes` has the functions. */
class Escape {
  constructor(data) {
    Object.assign(this, data);
    this.fieldsSize = (data.fields ?? []).reduce((sum, [size]) => sum + size, 0);
  }

  isRemote(bytes) {
    return isRemoteRequest(bytes, this.remote ?? -1);
  }

  byteText(position) {
    return `byte ${position - this.fieldsSize} of the data`;
  }

  /** The most bytes that are sent for `size` bytes; one more for each `growth` bytes. */
  most(size) {
    if (this.method === "can") return size - this.fieldsSize + CAN_HEADER;
    return size + (this.growth ? Math.floor(size / this.growth) : 0) + (this.method === "cobs" ? 1 : 0);
  }

  headerFault(bytes) {
    try {
      return this.bytes.walk(bytes, () => {});
    } catch (error) {
      return error.detail;
    }
  }
}

/** The original bytes, each with the place of the byte that is sent for it. Throws EscapeError. */
export function originalPlaces(escape, data) {
  const places = [];
  escape.bytes.walk(data, (byte, place) => places.push([byte, place]));
  return places;
}

/** A part of a frame. */
class PartLayout {
  constructor(data) {
    Object.assign(this, { unitSize: 1, base: 0, shift: 0, ...data, part: this });
  }

  at(length) {
    return partOffset(this, length);
  }

  checksum(data) {
    return checksumOf(this, data);
  }

  number(length) {
    return lengthNumber(this, length);
  }

  numberText(number) {
    const { size, value, numberSize = size } = this;
    if (value.digits === "decimal") return String(number).padStart(size, "0");
    return `0x${number.toString(16).toUpperCase().padStart(value.digits ? size : 2 * numberSize, "0")}`;
  }

  read(bytes) {
    if (this.value.digits) return bytes.length === this.size ? digitsNumber(this.value, bytes) : undefined;
    const order = this.order === "little" ? "little" : "big";
    return wholeOf(this.ownBytes(bytes), order, this.value.signed);
  }

  /** The bytes of its number alone, where it shares them with other parts. */
  ownBytes(bytes) {
    if (!this.width) return bytes;
    const order = this.order === "little" ? "little" : "big";
    return bytesOfNumber(BigInt.asUintN(this.width, unsignedOf(bytes, order) >> BigInt(this.shift)), bytes.length, order, false);
  }
}

/** The frame of one direction. */
class FrameLayout {
  constructor(data) {
    Object.assign(this, data);
    this.escape = data.escape ? new Escape(data.escape) : null;
    [this.header, this.trailer] = [data.header, data.trailer].map((parts) => parts.map((part) => new PartLayout(part)));
    this.parts = [...this.header, ...this.trailer];
    this.checksums = data.checksums.map((name) => this.parts.find((part) => part.name === name));
    this.lengths = this.header.filter((part) => part.role === "length");
  }

  role(role) {
    return this.parts.find((part) => part.role === role);
  }

  numbers(data) {
    const parts = this.header.filter(({ value, offset, size }) => value && offset + size <= data.length);
    return py.dict(parts.map((part) => [part.name, part.read(data.subarray(part.offset, part.offset + part.size)) ?? -1]));
  }

  statedNumber({ role }, number) {
    const hasRemote = role === "code" && this.escape?.remote !== undefined;
    return hasRemote ? onBits(number, CAN_REMOTE, (bits, flag) => bits & ~flag) : number;
  }
}

/** A link with the messages of a device that it carries. */
export class LinkLayout {
  constructor(data, messages) {
    const { carried, ...rest } = data;
    const { exception, addresses, preamble } = rest;
    Object.assign(this, { ...rest, indexes: {}, link: this, messages, openings: py.dict(Object.entries(data.openings ?? {})) });
    this.isCan = data.request.escape?.method === "can";
    this.delimiters = Object.fromEntries(Object.entries(data.delimiters).map(([direction, marks]) => [direction, marks.map(bytesOfHex)]));
    [this.request, this.response] = [new FrameLayout(data.request), new FrameLayout(data.response)];
    this.escape = this.request.escape;
    this.carriedMessages = Object.fromEntries(Object.entries(carried)
      .map(([direction, names]) => [direction, py.dict(names.map((name) => [name, messages.get(name)]))]));
    this.preamble = preamble && { ...preamble, surplus: (frame) => preambleSurplus(preamble, frame) };
    this.exceptionResponse = exception && { ...exception, isMarked: (code, numbers) => isException(exception, code, numbers) };
    this.mark = exception?.mark && { isIn: (bytes) => py.equal(bytes.subarray(exception.mark.offset, exception.mark.offset + exception.mark.bytes.length), Uint8Array.from(exception.mark.bytes)) };
    this.unitAddresses = addresses && { ...addresses, ranges: addresses.ranges && new Ranges(addresses.ranges) };
    this.hasUncodedExceptions = Boolean(exception) && !this.response.role("code");
    this.subcodes = Object.fromEntries(Object.entries(data.subcodes).map(([direction, shared]) => [direction, new Map(shared.map((own) => [
      own.code, { ...own, named: new Map(own.messages.map(([number, name]) => [number, messages.get(name)])) },
    ]))]));
  }

  frame(direction) {
    return this[direction];
  }

  marks(direction) {
    return this.delimiters[direction];
  }

  carried(direction) {
    return this.carriedMessages[direction];
  }

  directionName(direction) {
    return this.directionNames[direction];
  }

  codeText({ name }, direction) {
    return this.codes[direction][name];
  }

  /** The messages that one direction carries, by their codes in the same or in another direction. */
  byCode(carrying, direction) {
    const index = (this.indexes[`${carrying} ${direction}`] ??= new Map());
    for (const message of index.size ? [] : this.carried(carrying).values()) {
      const code = message.codeOf(direction);
      index.set(code, [...(index.get(code) ?? []), message]);
    }
    return index;
  }

  ambiguousCodes(direction) {
    const codes = direction === "response" ? this.ambiguous ?? [] : [];
    return (this.indexes[direction] ??= py.dict(codes.map((code) => [code, this.byCode(direction, direction).get(code)])));
  }

  isGuessed(direction, message) {
    return !this[direction].role("code") || this.ambiguousCodes(direction).has(this.messages.get(message)?.codeOf(direction));
  }

  /**
   * The message with a code in one direction, and with some data where several have the code; `asked` names the message
   * of the request, which decides where nothing in the data does. Undefined if there is none, and where all of this
   * leaves open which one it is.
   */
  messageWithCode(code, direction, data, asked) {
    const messages = this.byCode(direction, direction).get(exactWhole(code)) ?? [];
    if (messages.length < 2) return messages[0];
    if (this.ambiguousCodes(direction).has(exactWhole(code))) return messages.find(({ name }) => name === asked);
    const shared = this.subcodes[direction].get(exactWhole(code));
    if (!shared) return undefined;
    // Data that are too short count as those of the first message.
    if (data.length < shared.offset + shared.size) return shared.named.values().next().value;
    return shared.named.get(exactWhole(unsignedOf(data.subarray(shared.offset, shared.offset + shared.size), shared.order)));
  }

  /** The message that an exception response refuses: the only one with the code, or else that of the request. */
  refusedMessage(code, asked) {
    const messages = this.byCode("request", "response").get(exactWhole(code)) ?? [];
    return messages.length === 1 ? messages[0] : messages.find(({ name }) => name === asked);
  }
}

/** How many bytes of a frame come before the least ones of its preamble. */
function preambleSurplus({ byte, least, most }, frame) {
  const other = frame.findIndex((own) => own !== byte);
  return Math.max(0, Math.min((other < 0 ? frame.length : other) - least, most - least));
}

function isException({ code: own, flag, part, normal }, code, numbers) {
  if (part) return numbers.has(part) && !isWithin(normal, numbers.get(part));
  return own === undefined ? onBits(code, flag, (bits, mask) => bits & mask) !== 0 : code === own;
}

export const repeatedParts = (link) => link.repeated.map((names) => names.map((name) => ({ name })));

export const canFrameBytes = (identifier, isExtended, isRemote, dlc, data) => canBytes({ identifier, isExtended, isRemote, dlc, data });
