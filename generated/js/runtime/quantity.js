import { CodecError, printed } from "./error.js";
import { roundedReal } from "./number_bits.js";
import { rangesText, within } from "./values.js";

const DOUBLE = new DataView(new ArrayBuffer(8));

/** Whether a count is one of some counts, or in one of some intervals among them. */
function isAmong(counts, count) {
  return counts.some((other) => (Array.isArray(other) ? count !== null && other[0] <= count && count <= other[1] : other == count));
}

/**
 * The unit of a whole number: quantity = (count * factor + shift) / divisor, with whole numbers as bigints. `absent`
 * are the counts that stand for no quantity, and intervals of them; `ranges` are the counts that may be written.
 */
export function unit({ unit: symbol, factor, shift, divisor, absent, ranges, wide }) {
  const plain = [factor, shift, divisor].every((number) => number >= -(2n ** 53n) && number <= 2n ** 53n);
  const [small, offset, below] = [factor, shift, divisor].map(Number);
  return Object.freeze({
    unit: symbol,
    /** The quantity of a count, rounded once; null for a count that stands for no quantity. */
    inUnit(count) {
      if (isAmong(absent, count)) return null;
      if (plain && typeof count === "number") {
        const above = count * small + offset;
        if (Number.isSafeInteger(above) && Number.isSafeInteger(count * small)) return above / below;
      }
      return quotient(BigInt(count) * factor + shift, divisor);
    },
    /**
     * The count that is nearest to a quantity, of two equally near ones the even one. Throws CodecError out of range,
     * and for a count that stands for no quantity.
     */
    fromUnit(quantity) {
      const [above, under] = fraction(quantity);
      const count = nearest((above * divisor - shift * under) * (factor < 0n ? -1n : 1n), under * (factor < 0n ? -factor : factor));
      if (!within(ranges, count)) {
        throw new CodecError("out_of_range", `${quantity} is the count ${count}, not in ${rangesText(ranges)}`);
      }
      if (isAmong(absent, count)) {
        throw new CodecError("out_of_range", `${quantity} is the count ${count}, which stands for no quantity`);
      }
      return wide ? count : Number(count);
    },
  });
}

/**
 * The unit of a floating-point number of `size` bytes, which is in the unit already. `absent` are the numbers that stand
 * for no quantity, NaN for any NaN; `ranges` are those that may be written, null for all.
 */
export function realUnit({ unit: symbol, absent, ranges, size }) {
  const isAbsent = (number) => absent.some((other) => other === number || (Number.isNaN(other) && Number.isNaN(number)));
  return Object.freeze({
    unit: symbol,
    /** The number; null for one that stands for no quantity. */
    inUnit(number) {
      return isAbsent(Number(number)) ? null : Number(number);
    },
    /** The nearest number that can be sent. Throws CodecError out of range, and for one that stands for no quantity. */
    fromUnit(quantity) {
      fraction(quantity);
      const number = roundedReal(Number(quantity), size);
      if (!Number.isFinite(number)) throw new CodecError("out_of_range", `${quantity} is more than ${8 * size} bits hold`);
      if (isAbsent(number)) throw new CodecError("out_of_range", `${quantity} is sent as ${number}, which stands for no quantity`);
      if (ranges !== null && !within(ranges, number)) {
        throw new CodecError("out_of_range", `${quantity} is not in ${rangesText(ranges)}`);
      }
      return number;
    },
  });
}

/**
 * The unit of a whole number whose scale is a power of ten: quantity = count * 10 ** exponent. The exponent is in one of
 * the intervals `exponents`, or one of the numbers `unknown`, which stand for none; the rest is as in `unit`.
 */
export function powerUnit({ unit: symbol, exponents, unknown, ...counts }) {
  const power = (exponent) => {
    const number = Number(exponent);
    if (exponent === null || !Number.isInteger(number) || !within(exponents, number)) {
      throw new CodecError("out_of_range", `the exponent is ${printed(exponent)}, not in ${rangesText(exponents)}`);
    }
    const [factor, divisor] = number > 0 ? [10n ** BigInt(number), 1n] : [1n, 10n ** BigInt(-number)];
    return unit({ unit: symbol, factor, shift: 0n, divisor, ...counts });
  };
  return Object.freeze({
    unit: symbol,
    /** The quantity of a count, rounded once; null where the count or the exponent stands for none. Throws CodecError. */
    inUnit(count, exponent) {
      return isAmong(unknown, exponent) ? null : power(exponent).inUnit(count);
    },
    /** The count that is nearest to a quantity, as `fromUnit` of a unit. Throws CodecError. */
    fromUnit(quantity, exponent) {
      return power(exponent).fromUnit(quantity);
    },
  });
}

/**
 * A share of a reference: quantity = reference * count / full; with `complement`, reference * (1 - count / full).
 * `low` and `high` bound the count.
 */
export function conversion({ full, complement, low, high }) {
  return Object.freeze({
    /** The quantity of a count, the raw value. */
    fromRaw(raw, reference) {
      const [above, under] = fraction(reference);
      const share = complement ? full - BigInt(raw) : BigInt(raw);
      return quotient(above * share, under * full);
    },
    /** The nearest count of a quantity, of two equally near ones the even one. Throws CodecError out of range. */
    toRaw(quantity, reference) {
      const [above, under] = fraction(quantity);
      const [over, below] = fraction(reference);
      if (over === 0n) throw new CodecError("out_of_range", "the reference is 0");
      let [top, bottom] = [above * below * full, under * over];
      if (complement) top = full * bottom - top;
      if (bottom < 0n) [top, bottom] = [-top, -bottom];
      const count = nearest(top, bottom);
      if (count < low || count > high) throw new CodecError("out_of_range", `${quantity} is the count ${count}, not in ${low}..${high}`);
      return Number(count);
    },
  });
}

/** A number as an exact fraction of bigints; the lower one is positive. Throws CodecError for what is not a number. */
export function fraction(quantity) {
  if (typeof quantity === "bigint") return [quantity, 1n];
  if (typeof quantity === "number" && Number.isFinite(quantity)) {
    DOUBLE.setFloat64(0, quantity);
    const bits = DOUBLE.getBigUint64(0);
    const exponent = Number((bits >> 52n) & 0x7ffn);
    const mantissa = (bits & 0xfffffffffffffn) | (exponent ? 0x10000000000000n : 0n);
    const signed = bits >> 63n ? -mantissa : mantissa;
    const power = (exponent || 1) - 1075;
    return power < 0 ? [signed, 1n << BigInt(-power)] : [signed << BigInt(power), 1n];
  }
  const match = typeof quantity === "string" && /^([+-]?)(\d{1,60})(?:\.(\d{1,60}))?$/.exec(quantity);
  if (!match) throw new CodecError("wrong_type", `${printed(quantity)} is not a number`);
  const digits = match[3] ?? "";
  const whole = BigInt(match[2] + digits);
  return [match[1] === "-" ? -whole : whole, 10n ** BigInt(digits.length)];
}

/** The nearest whole number of a fraction with a positive divisor, of two equally near ones the even one. */
function nearest(above, below) {
  let whole = above / below;
  if (above % below < 0n) whole -= 1n;
  const twice = 2n * (above - whole * below);
  return twice > below || (twice === below && whole % 2n !== 0n) ? whole + 1n : whole;
}

/** A fraction as a number, rounded once. */
function quotient(above, below) {
  if (above === 0n) return 0;
  const size = above < 0n ? -above : above;
  const shift = 66 - (size.toString(2).length - below.toString(2).length);
  const [top, bottom] = shift > 0 ? [size << BigInt(shift), below] : [size, below << BigInt(-shift)];
  // A last bit for the rest keeps Number from seeing a tie where there is none.
  const exact = ((top / bottom) << 1n) | (top % bottom === 0n ? 0n : 1n);
  const number = Number(exact) * 2 ** (-shift - 1);
  return above < 0n ? -number : number;
}
