/**
 * The values that stand for a state and not for a quantity, by the names of their states. `values` has no prototype; a
 * NaN in it means any NaN. A state for which all numbers of an interval stand has the least in `values`, and the greatest
 * in `lasts`.
 */
export function absentValues(values, lasts = {}) {
  const rows = Object.entries(values);
  return Object.freeze({
    values: Object.freeze(values),
    /** The name of the state that a value stands for; null for a quantity, and for what is no number. */
    nameOf(value) {
      if (typeof value !== "number" && typeof value !== "bigint") return null;
      const row = rows.find(([name, other]) =>
        name in lasts ? other <= value && value <= lasts[name] : other == value || (Number.isNaN(other) && Number.isNaN(value)),
      );
      return row === undefined ? null : row[0];
    },
  });
}
