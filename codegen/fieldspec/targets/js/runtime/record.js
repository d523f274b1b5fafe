import { CodecError, printed, wrongType } from "./error.js";

/**
 * A record. `read(bytes, start, end)` and `write(value, bytes, start)` are its generated functions; `size(value)`
 * counts the bytes of a value where they vary. `keys` are the names of its fields, `units` their quantities, `absent`
 * the values that stand for a state.
 */
export function record({ name, least, most, read, write, size: sizeOf, keys, units, absent = {} }) {
  const count = Object.keys(keys).length;
  const size = sizeOf === null ? null : (value) => writableSize(name, sizeOf(value));
  return Object.freeze({
    name,
    least,
    most,
    read,
    write,
    size,
    units,
    absent,
    /** The value of exactly these bytes. Throws CodecError. */
    decode(bytes) {
      return read(bytes, 0, bytes.length);
    },
    /** The bytes of a value. Throws CodecError. */
    encode(value) {
      try {
        const bytes = new Uint8Array(size === null ? least : size(value));
        write(value, bytes, 0);
        // The writer has found every field, so with as many keys as there are fields, none is unknown.
        let unknown = -count;
        for (const _ in value) unknown++;
        if (unknown !== 0 || typeof value !== "object" || value === null) knownKeys(name, value, keys);
        return bytes;
      } catch (error) {
        knownKeys(name, value, keys);
        throw error;
      }
    },
    /** Throws CodecError for what is not an object, and for a field that the record does not have. */
    check(value) {
      knownKeys(name, value, keys);
    },
  });
}

/** The bytes that a value has. Throws CodecError for more than the offsets of generated functions count. */
function writableSize(name, size) {
  if (size > 0x3fffffff) throw new CodecError("wrong_length", `${name} has ${size} bytes, which are too many`);
  return size;
}

/** Throws CodecError for what is not an object, and for a field that a record does not have. */
export function knownKeys(name, value, keys) {
  if (typeof value !== "object" || value === null) throw wrongType(name, value, "an object");
  for (const key in value) {
    if (!(key in keys)) throw new CodecError("unknown_field", `${name} has no field ${printed(key)}`);
  }
}
