import { CodecError, printed } from "./error.js";
import { bitsOfWhole, wholeOfBits } from "./number_bits.js";
import { checkExact } from "./values.js";

/**
 * A numbered parameter. `read(bytes, start)` and `write(value, bytes, start)` are its generated functions for `size`
 * bytes; `places` are the places of these, the most significant one first.
 */
export function parameter(name, number, base, access, read, write, more) {
  const own = { name, size: more.size, signed: more.signed, carriedSigned: more.carriedSigned, kind: more.kind, places: more.places, absent: more.absent ?? null, read, write };
  const subindices = more.subindices ?? [];
  const elementOf = (index) => subindices.find(({ indices }) => indices.some(([low, high]) => index >= low && index <= high)) ?? own;
  return Object.freeze({
    name,
    number,
    wireNumber: base + number,
    access,
    units: null,
    absent: null,
    default: null,
    elements: null,
    printedName: String(number),
    ...more,
    subindices,
    /** Whether the element with an index can be read and written: ro, rw, wo, or empty where nothing says it. */
    accessOf(subindex) {
      return elementOf(subindex).access ?? access;
    },
    /** The values of the element with an index that stand for a state; null where none does. */
    absentOf(subindex) {
      return elementOf(subindex).absent ?? null;
    },
    /** The value of exactly all of its bytes. Throws CodecError. */
    decode(bytes) {
      checkExact(name, bytes, more.size);
      return read(bytes, 0);
    },
    /** The bytes of a value. Throws CodecError. */
    encode(value) {
      const bytes = new Uint8Array(more.size);
      write(value, bytes, 0);
      return bytes;
    },
    /** The value of a raw value in a message, which may be signed or not, for the element with an index. */
    fromRaw(raw, subindex = 0) {
      return fromRaw(elementOf(subindex), raw);
    },
    /**
     * The value of exactly all of the bytes that a message carries, for the element with an index. Of a text, the zeros
     * that fill it up may be missing. Throws CodecError.
     */
    fromBytes(bytes, subindex = 0) {
      const element = elementOf(subindex);
      if (element.kind === "text" && bytes.length < element.size) {
        const filled = new Uint8Array(element.size);
        filled.set(bytes);
        return element.read(filled, 0);
      }
      if (bytes.length !== element.size) {
        throw new CodecError("wrong_length", `${element.name} has ${element.size} bytes, not ${bytes.length}`);
      }
      return element.read(bytes, 0);
    },
    /** The bytes of a value for a message. Throws CodecError. */
    toBytes(value, subindex = 0) {
      const element = elementOf(subindex);
      const bytes = new Uint8Array(element.size);
      element.write(value, bytes, 0);
      return bytes;
    },
    /**
     * The raw value of a value for a message: with a sign where the field of the message has one, and without where
     * `unsigned` is set. Throws CodecError.
     */
    toRaw(value, { subindex = 0, unsigned = false } = {}) {
      return toRaw(elementOf(subindex), value, unsigned);
    },
  });
}

/** Whether the raw value of an element is a whole number of its bits. */
function isCounted({ kind }) {
  switch (kind) {
    case "integer": case "boolean": return true;
    case "float": case "text": case "bytes": return false;
    default: throw new RangeError(`unknown kind: ${kind}`);
  }
}

function fromRaw(element, raw) {
  if (!isCounted(element)) {
    const bytes = new Uint8Array(element.size);
    element.write(raw, bytes, 0);
    return element.read(bytes, 0);
  }
  const whole = typeof raw === "boolean" ? Number(raw) : raw;
  if (typeof whole !== "bigint" && !Number.isInteger(whole)) {
    throw new CodecError("wrong_type", `${element.name} is a whole number, not ${printed(raw)}`);
  }
  const [number, span] = [BigInt(whole), 1n << BigInt(8 * element.size)];
  if (number >= span || number < -span / 2n) {
    throw new CodecError("out_of_range", `${element.name} is ${number}, which ${element.size} bytes do not hold`);
  }
  const bits = bitsOfWhole(number, 8 * element.size, element.carriedSigned ?? element.signed);
  const bytes = new Uint8Array(element.size);
  element.places.forEach((place, index) => {
    bytes[place] = Number((bits >> BigInt(8 * (element.size - 1 - index))) & 255n);
  });
  return element.read(bytes, 0);
}

function toRaw(element, value, unsigned) {
  const bytes = new Uint8Array(element.size);
  element.write(value, bytes, 0);
  if (!isCounted(element)) return value;
  let number = 0n;
  for (const place of element.places) number = number * 256n + BigInt(bytes[place]);
  if (!unsigned) number = wholeOfBits(number, 8 * element.size, element.carriedSigned ?? element.signed);
  return element.size > 6 ? number : Number(number);
}

/** Equal parameters with numbers in a row. */
export function parameters(count, name, number, base, ...rest) {
  return Object.freeze(Array.from({ length: count }, (_, index) => parameter(`${name}[${index}]`, number + index, base, ...rest)));
}

/**
 * The parameters of a set by name; `byNumber(wireNumber)` is one of them, or undefined. `carried` has the property of a
 * response with the bytes of a value; the property `by` says how many of them count, by `sizes`.
 */
export function parameterSet(name, rows, carried = undefined) {
  const index = new Map();
  for (const row of Object.values(rows)) for (const entry of [row].flat()) index.set(entry.wireNumber, entry);
  const own = { setName: name, parameters: Object.freeze(rows), byNumber: (wireNumber) => index.get(wireNumber) };
  if (!carried) return Object.freeze(own);
  const { bytes, by, sizes } = carried;
  return Object.freeze({
    ...own,
    valueIn(response, entry, subindex = 0) {
      return entry.fromBytes(by ? response[bytes].subarray(0, sizes[response[by]] ?? 0) : response[bytes], subindex);
    },
  });
}
