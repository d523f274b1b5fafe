const TABLE = new Uint16Array(256);
for (let byte = 0; byte < 256; byte++) {
  let crc = byte;
  for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >> 1) ^ 0xa001 : crc >> 1;
  TABLE[byte] = crc;
}

/** CRC-16 with polynomial A001h, reflected, and initial value FFFFh, over the bytes from `start` to `stop`. */
export function crc16(bytes, start, stop) {
  let crc = 0xffff;
  for (let at = start; at < stop; at++) crc = (crc >> 8) ^ TABLE[(crc ^ bytes[at]) & 0xff];
  return crc;
}

/** The low byte of the sum of the bytes from `start` to `stop`. */
export function sum8(bytes, start, stop) {
  let sum = 0;
  for (let at = start; at < stop; at++) sum += bytes[at];
  return sum & 0xff;
}

/** The two's complement of the sum of the bytes from `start` to `stop`. */
export function lrc(bytes, start, stop) {
  return -sum8(bytes, start, stop) & 0xff;
}

/** The bits of a number of `width` bits in the opposite order. */
function reversed(number, width) {
  let result = 0n;
  for (let place = 0n; place < width; place++) result |= ((number >> place) & 1n) << (BigInt(width) - 1n - place);
  return result;
}

/**
 * A function that computes a CRC over the bytes from `start` to `stop`. The register is that of a reflected CRC; one
 * that is not reflected takes the bits of each byte in the opposite order. Its numbers are bigints.
 */
export function crcOf({ width, polynomial, initial, reflectIn, reflectOut, finalXor }) {
  const [size, term] = [BigInt(width), reversed(polynomial, width)];
  const terms = Array.from({ length: 256 }, (_, byte) => {
    let register = BigInt(byte);
    for (let bit = 0; bit < 8; bit++) register = register & 1n ? (register >> 1n) ^ term : register >> 1n;
    return register;
  });
  const wide = width > 32;
  const table = wide ? terms : Uint32Array.from(terms, Number);
  const bytesIn = Uint8Array.from({ length: 256 }, (_, byte) => (reflectIn ? byte : Number(reversed(BigInt(byte), 8))));
  const begin = wide ? reversed(initial, width) : Number(reversed(initial, width));
  return (bytes, start, stop) => {
    let register = begin;
    if (wide) {
      for (let at = start; at < stop; at++) register = (register >> 8n) ^ table[Number(register & 255n) ^ bytesIn[bytes[at]]];
    } else {
      for (let at = start; at < stop; at++) register = (register >>> 8) ^ table[(register & 255) ^ bytesIn[bytes[at]]];
      register >>>= 0;
    }
    const number = BigInt.asUintN(Number(size), BigInt(register));
    return (reflectOut ? number : reversed(number, width)) ^ finalXor;
  };
}

/** The `unitSize` bytes from `at` on as one number; zeros follow where bytes before `stop` are missing. */
function unitAt(bytes, at, stop, unitSize, order) {
  let unit = 0n;
  for (let place = 0; place < unitSize; place++) {
    const offset = at + (order === "little" ? unitSize - 1 - place : place);
    unit = (unit << 8n) | (offset < stop ? BigInt(bytes[offset]) : 0n);
  }
  return unit;
}

/**
 * A function that adds, or combines by exclusive or, the bytes from `start` to `stop`, `unitSize` of them at a time as
 * one number in the byte order `order`; zeros follow where the last are missing. Its numbers are bigints.
 */
export function totalOf({ method, width, initial, complement, unitSize, order }) {
  const combine = method === "sum" ? (total, unit) => total + unit : (total, unit) => total ^ unit;
  return (bytes, start, stop) => {
    let total = initial;
    for (let at = start; at < stop; at += unitSize) {
      total = combine(total, unitAt(bytes, at, stop, unitSize, order));
    }
    if (complement === "twos") total = -total;
    if (complement === "ones") total = ~total;
    return BigInt.asUintN(width, total);
  };
}

/**
 * A function that computes a Fletcher checksum of the bytes from `start` to `stop`: two sums modulo `modulus`, that of
 * the numbers and, in the upper half of the bits, that of all values of the first one. Its numbers are bigints.
 */
export function fletcherOf({ width, initial, modulus, unitSize, order }) {
  const half = BigInt(width / 2);
  return (bytes, start, stop) => {
    let [upper, lower] = [initial >> half, BigInt.asUintN(width / 2, initial)];
    for (let at = start; at < stop; at += unitSize) {
      lower = (lower + unitAt(bytes, at, stop, unitSize, order)) % modulus;
      upper = (upper + lower) % modulus;
    }
    return (upper << half) | lower;
  };
}

/** A function that computes a checksum of the bytes from `start` to `stop`, and of more bytes after them. */
export function followedBy(algorithm, suffix) {
  return (bytes, start, stop) => {
    const data = [...bytes.subarray(start, stop), ...suffix];
    return algorithm(data, 0, data.length);
  };
}

/** A function that computes a checksum of numbers of `unitSize` bytes, of which it takes the last byte first. */
export function swapping(algorithm, unitSize) {
  return (bytes, start, stop) => {
    const data = new Uint8Array(Math.ceil((stop - start) / unitSize) * unitSize);
    data.set(bytes.slice(start, stop));
    for (let at = 0; at < data.length; at += unitSize) data.subarray(at, at + unitSize).reverse();
    return algorithm(data, 0, data.length);
  };
}

/** A function that computes a checksum of `size` bytes, with others in place of the bytes that must not occur. */
export function avoiding(algorithm, size, avoided, replacements) {
  return (bytes, start, stop) => {
    const number = BigInt(algorithm(bytes, start, stop));
    let result = 0n;
    for (let shift = 0n; shift < 8 * size; shift += 8n) {
      const byte = Number((number >> shift) & 255n);
      const place = avoided.indexOf(byte);
      result |= BigInt(place < 0 ? byte : replacements[place]) << shift;
    }
    return result;
  };
}

/** The bytes of a checksum in a frame: those of its number, or its digits. */
export function checksumBytes({ algorithm, size, order, digits }, bytes, first, last) {
  let number = algorithm(bytes, first, last);
  if (digits) {
    const text = number.toString(digits === "decimal" ? 10 : 16).padStart(size, "0");
    return Array.from(digits === "upper_hex" ? text.toUpperCase() : text, (character) => character.charCodeAt(0));
  }
  const result = [];
  if (typeof number === "number") {
    for (let place = 0; place < size; place++, number >>>= 8) result.push(number & 0xff);
  } else {
    for (let place = 0; place < size; place++, number >>= 8n) result.push(Number(number & 255n));
  }
  return order === "little" ? result : result.reverse();
}
