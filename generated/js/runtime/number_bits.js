const VIEW = new DataView(new ArrayBuffer(8));
/** The bits of a NaN by the bytes of a number. Engines choose others at will, also while a program runs. */
const QUIET_NANS = { __proto__: null, 2: 0x7e00, 4: 0x7fc00000, 8: 0x7ff8000000000000n };

/** The number of half precision of 16 bits, given as a whole number. */
export function halfOf(bits) {
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 0x3ff;
  // Numbers without an exponent have no implied bit, and the step of the least exponent.
  const finite = (exponent ? fraction + 1024 : fraction) * 2 ** (Math.max(exponent, 1) - 25);
  const size = exponent < 31 ? finite : fraction ? NaN : Infinity;
  return bits >> 15 ? -size : size;
}

/**
 * The 16 bits of the nearest number of half precision, of two equally near ones of the even one; those of infinity where
 * a number is too great.
 */
function halfBits(number) {
  VIEW.setFloat64(0, number);
  const sign = (VIEW.getUint8(0) >> 7) << 15;
  const exponent = Math.max(((VIEW.getUint16(0) >> 4) & 0x7ff) - 1023, -14);
  // No number has places after the point once 2 ** 52 is added to it.
  const steps = Math.abs(number) / 2 ** (exponent - 10) + 2 ** 52 - 2 ** 52;
  return sign | Math.min((exponent + 14) * 1024 + steps, 0x7c00);
}

/** The nearest floating-point number of `size` bytes; infinite where a number is too great. */
export function roundedReal(number, size) {
  switch (size) {
    case 2: return halfOf(realBits(number, size));
    case 4: return Math.fround(number);
    case 8: return number;
    default: throw new RangeError(`no floating-point number has ${size} bytes`);
  }
}

/** The floating-point number of `size` bytes whose bits are a whole number, a bigint where there are eight. */
export function realOfBits(bits, size) {
  switch (size) {
    case 2: return halfOf(bits);
    case 4:
      VIEW.setUint32(0, bits);
      return VIEW.getFloat32(0);
    case 8:
      VIEW.setBigUint64(0, bits);
      return VIEW.getFloat64(0);
    default: throw new RangeError(`no floating-point number has ${size} bytes`);
  }
}

/** The bits of the nearest floating-point number of `size` bytes. */
export function realBits(number, size) {
  if (Number.isNaN(number) && size in QUIET_NANS) return QUIET_NANS[size];
  switch (size) {
    case 2: return halfBits(number);
    case 4:
      VIEW.setFloat32(0, number);
      return VIEW.getUint32(0);
    case 8:
      VIEW.setFloat64(0, number);
      return VIEW.getBigUint64(0);
    default: throw new RangeError(`no floating-point number has ${size} bytes`);
  }
}

/** Whether a number is finite and becomes infinite in a floating-point number of `size` bytes. */
export function exceedsReal(number, size) {
  return Number.isFinite(number) && !Number.isFinite(roundedReal(number, size));
}

/** A whole number that a double has exactly as a number, any other as it is. */
export const exactWhole = (number) => (Number.isSafeInteger(Number(number)) ? Number(number) : number);

/** The result of an operation on the bits of two whole numbers without a sign. */
export function onBits(left, right, operation) {
  const isNarrow = left <= 0xffffffff && right <= 0xffffffff;
  return isNarrow ? operation(Number(left), Number(right)) >>> 0 : exactWhole(operation(BigInt(left), BigInt(right)));
}

/** A power of two, as a bigint where another number is one. */
const powerBeside = (number, exponent) => (typeof number === "bigint" ? 1n << BigInt(exponent) : 2 ** exponent);

/** The number of `count` bits, given as a whole number, of which the highest one says that it is below zero. */
export function magnitudeOf(bits, count) {
  const highest = powerBeside(bits, count - 1);
  return bits < highest ? bits : highest - bits;
}

/** The `count` bits of a number, of which the highest one says that it is below zero, as a whole number. */
export function magnitudeBits(number, count) {
  return number < 0 ? powerBeside(number, count - 1) - number : number;
}

/**
 * The `count` bits of a whole number, as one. `signed` is how it shows that it is below zero: true for two's complement,
 * `magnitude` for the highest bit alone.
 */
export function bitsOfWhole(number, count, signed) {
  switch (signed) {
    case undefined: case false: return number;
    case true: return number < 0 ? number + powerBeside(number, count) : number;
    case "magnitude": return magnitudeBits(number, count);
    default: throw new RangeError(`unknown sign: ${signed}`);
  }
}

/** The number of `count` bits, given as a whole number; `signed` as in `bitsOfWhole`. */
export function wholeOfBits(bits, count, signed) {
  switch (signed) {
    case undefined: case false: return bits;
    case true: return bits < powerBeside(bits, count - 1) ? bits : bits - powerBeside(bits, count);
    case "magnitude": return magnitudeOf(bits, count);
    default: throw new RangeError(`unknown sign: ${signed}`);
  }
}

/** The least and the greatest whole number of `count` bits, as bigints; `signed` as in `bitsOfWhole`. */
export function wholeBounds(count, signed) {
  const highest = 1n << BigInt(count - 1);
  switch (signed) {
    case undefined: case false: return [0n, 2n * highest - 1n];
    case true: return [-highest, highest - 1n];
    case "magnitude": return [1n - highest, highest - 1n];
    default: throw new RangeError(`unknown sign: ${signed}`);
  }
}
