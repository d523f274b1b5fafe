import { CodecError } from "./error.js";
import { checkExact } from "./values.js";

/**
 * A value in registers, `words` of them from `address` on: words of 16 bits, or bytes where the `unitSize` is 1. `read(bytes, start)` and `write(value, bytes, start)` are its
 * generated functions; `more` has what applies to it beside.
 */
export function register(name, address, words, access, read, write, more = {}) {
  const size = (more.unitSize ?? 2) * words;
  return Object.freeze({
    name,
    address,
    words,
    access,
    space: "",
    atomic: false,
    trigger: false,
    unitSize: 2,
    units: null,
    absent: null,
    ...more,
    /** The value of exactly all of its bytes. Throws CodecError. */
    decode(bytes) {
      checkExact(name, bytes, size);
      return read(bytes, 0);
    },
    /** The bytes of a value. Throws CodecError. */
    encode(value) {
      const bytes = new Uint8Array(size);
      write(value, bytes, 0);
      return bytes;
    },
  });
}

/** Equal registers, `stride` words apart, numbered from `first`. */
export function registerArray(count, first, stride, name, address, words, access, read, write, more = {}) {
  const registers = Array.from({ length: count }, (_, index) =>
    register(`${name}[${first + index}]`, address + index * stride, words, access, read, write, more),
  );
  return Object.freeze({
    name,
    address,
    first,
    stride,
    length: count,
    /** The register with a number. Throws RangeError. */
    at(number) {
      return registers[indexOf(name, first, count, number)];
    },
    [Symbol.iterator]: () => registers[Symbol.iterator](),
  });
}

/**
 * A table of records, `stride` words apart, numbered from `first`. Each is a register whose value is the record.
 * `countBy` is the register with the number of records that the device has, null where it has all of them. `baseBy` is the one
 * with the address of the first record, of which `address` is the usual one; null where the table does not move.
 */
export function table(count, first, stride, name, address, access, record, more = {}, countBy = null, baseBy = null) {
  const located = () => {
    if (baseBy !== null) throw new RangeError(`${name} begins where ${baseBy.name} says: use atBase`);
  };
  const make = (index) =>
    register(
      `${name}[${first + index}]`,
      address + index * stride,
      record.least / 2,
      access,
      (bytes, start) => record.read(bytes, start, start + record.least),
      (value, bytes, start) => {
        record.check(value);
        record.write(value, bytes, start);
      },
      more,
    );
  return Object.freeze({
    name,
    address,
    first,
    stride,
    length: count,
    record,
    countBy,
    baseBy,
    /** The record with a number, as a register. Throws RangeError. */
    at(number) {
      located();
      return make(indexOf(name, first, count, number));
    },
    /** The records of a device that has so many. Throws RangeError for more than there can be. */
    present(number) {
      located();
      const size = Number(number);
      if (!Number.isInteger(size) || size < 0 || size > count) throw new RangeError(`${name} has 0..${count} records, not ${number}`);
      return Array.from({ length: size }, (_, index) => make(index));
    },
    /** The table of a device that has its first record at an address. Throws RangeError for what is no such address. */
    atBase(base) {
      const start = Number(base);
      const last = 0x10000 - (count - 1) * stride - record.least / 2;
      if (!Number.isInteger(start) || start < 0 || start > last) throw new RangeError(`${name} does not fit after the address ${base}`);
      return table(count, first, stride, name, start, access, record, more, countBy);
    },
  });
}

/** The index of an element with a number, the first of which is `first`. Throws RangeError. */
function indexOf(name, first, count, number) {
  if (Number.isInteger(number) && number >= first && number < first + count) return number - first;
  throw new RangeError(`${name} has the numbers ${first}..${first + count - 1}, not ${number}`);
}

/** The words of bytes, in the byte order of a device; the bytes themselves where the `unitSize` is 1. */
function wordsOf(bytes, order, unitSize = 2) {
  if (unitSize === 1) return Array.from(bytes);
  const [high, low] = order === "big" ? [0, 1] : [1, 0];
  return Array.from({ length: bytes.length / 2 }, (_, word) => bytes[2 * word + high] * 256 + bytes[2 * word + low]);
}

/** The bytes of words, in the byte order of a device; of bytes where the `unitSize` is 1. */
function bytesOf(words, order, unitSize = 2) {
  if (unitSize === 1) return Uint8Array.from(words);
  const [high, low] = order === "big" ? [0, 1] : [1, 0];
  const bytes = new Uint8Array(2 * words.length);
  words.forEach((word, index) => {
    bytes[2 * index + high] = word >> 8;
    bytes[2 * index + low] = word & 0xff;
  });
  return bytes;
}

/** Throws CodecError for several registers, and for other objects. */
function refuseOthers(entry) {
  if (typeof entry?.decode === "function") return;
  const text = entry?.first === undefined ? `${String(entry)} is not a register` : `${entry.name} has several registers: pass one of them, such as at(${entry.first})`;
  throw new CodecError("wrong_type", text);
}

/** Throws CodecError for a register that can only be read, or only be written. */
function allowed(entry, operation) {
  refuseOthers(entry);
  if (operation === "write" && entry.access === "ro") throw new CodecError("read_only", `${entry.name} can only be read`);
  if (operation === "read" && entry.access === "wo") throw new CodecError("write_only", `${entry.name} can only be written`);
}

/** The error of registers that no message of the device reads or writes. */
function noMessage(entry, operation) {
  return new CodecError("unknown_code", `no message can ${operation} ${entry.name}, ${entry.words} ${entry.unitSize === 2 ? "words" : "bytes"} in ${entry.space || "the device"}`);
}

function accessOf(accesses, entry, operation, words) {
  const own = accesses.filter((access) => access.operation === operation && access.space === entry.space);
  const access = own.find((candidate) => candidate.single === (words === 1)) ?? own.find((candidate) => !candidate.single) ?? own[0];
  if (access === undefined) throw noMessage(entry, operation);
  return access;
}

function* spansOf(entry, access) {
  const most = Math.min(access.most, entry.words);
  if (entry.words > most && entry.atomic) throw noMessage(entry, access.operation);
  for (let at = 0; at < entry.words; at += most) yield [at, Math.min(most, entry.words - at)];
}

/** What a message carries for words; in a space of bits, each is 0 or 1. */
function carriedOf(access, words) {
  if (access.bit === undefined) return access.single ? words[0] : words;
  if (access.single) return access.bit[words[0]];
  const bytes = Array(Math.ceil(words.length / 8)).fill(0);
  words.forEach((bit, index) => (bytes[index >> 3] |= bit << (index & 7)));
  return bytes;
}

/** The words that a message carries for a register; in a space of bits, each is 0 or 1. Throws CodecError. */
function wordsIn(access, entry, carried) {
  if (access.bit === undefined) return carried;
  const bits = access.single ? [access.bit.indexOf(carried)] : Array.from({ length: entry.words }, (_, index) => (carried[index >> 3] >> (index & 7)) & 1);
  if (bits.includes(-1)) throw new CodecError("unknown_value", `${entry.name} is ${carried}, neither ${access.bit[0]} nor ${access.bit[1]}`);
  return bits;
}

function requestOf(access, entry, at, count, words) {
  const data = { [access.start]: entry.address + at };
  if (access.count) data[access.count] = count;
  if (words !== null) data[access.values] = carriedOf(access, words.slice(at, at + count));
  return { message: access.message, data };
}

/**
 * The functions for registers of a device with some byte order, by `accesses`, its messages that read and write words: by those
 * of a link, if links differ. Throws RangeError for a link without such messages.
 */
export function registerFunctions(accesses, order, link) {
  const own = accesses.filter(({ links }) => links === undefined || links.includes(link));
  if (own.length === 0) {
    const known = [...new Set(accesses.flatMap(({ links }) => links))].join(", ");
    throw new RangeError(`there is no link ${link}; known are ${known}`);
  }
  return {
    /** The requests that read a register. Throws CodecError. */
    readRequests(entry) {
      allowed(entry, "read");
      const access = accessOf(own, entry, "read", 0);
      return [...spansOf(entry, access)].map(([at, count]) => requestOf(access, entry, at, count, null));
    },
    /** The value of a register from the data of responses. Throws CodecError. */
    readValue(entry, ...responses) {
      refuseOthers(entry);
      const access = accessOf(own, entry, "read", 0);
      const words = responses.flatMap((response) => {
        const carried = response?.[access.values];
        if (carried === undefined) throw new CodecError("missing_value", `${access.values} is missing: pass the data of the response that reads ${entry.name}`);
        return wordsIn(access, entry, carried);
      });
      return entry.decode(bytesOf(words, order, entry.unitSize));
    },
    /** The requests that write a value to a register. Throws CodecError. */
    writeRequests(entry, value) {
      allowed(entry, "write");
      const words = wordsOf(entry.encode(value), order, entry.unitSize);
      const access = accessOf(own, entry, "write", words.length);
      return [...spansOf(entry, access)].map(([at, count]) => requestOf(access, entry, at, count, words));
    },
  };
}
