import { bitsNumber, within } from "./values.js";

const isBitsWithin = ([mask, images, runs], word) => within(images, runs ? bitsNumber(runs, word, false) : word & mask);

/**
 * The states of a value that is read. `values` are those that stand for a state and not for a quantity, by the names of
 * their states. It has no prototype; a NaN in it means any NaN. A state for which all numbers of an interval stand has
 * the least in `values`, and the greatest in `lasts`. Any other value is out of range outside of `ranges`, where there
 * are any, and where the bits in a mask of `bits`, or of their runs, are in none of its intervals. It is a quantity all the same.
 */
export function absentValues(values, lasts = {}, { ranges = null, bits = [] } = {}) {
  const rows = Object.entries(values);
  return Object.freeze({
    values: Object.freeze(values),
    /** The name of the state that a value stands for, or `out_of_range`; null for any other, and for what is not a number. */
    nameOf(value) {
      if (typeof value !== "number" && typeof value !== "bigint") return null;
      const row = rows.find(([name, other]) =>
        name in lasts ? other <= value && value <= lasts[name] : other == value || (Number.isNaN(other) && Number.isNaN(value)),
      );
      if (row !== undefined) return row[0];
      const isWithin = ranges === null || within(ranges, value);
      return isWithin && bits.every((bit) => isBitsWithin(bit, BigInt(value))) ? null : "out_of_range";
    },
  });
}
