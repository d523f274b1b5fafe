/**
 * The values that stand for a state and not for a quantity, by the names of their states. `values` has no prototype; a
 * NaN in it means any NaN.
 */
export function absentValues(values) {
  const rows = Object.entries(values);
  return Object.freeze({
    values: Object.freeze(values),
    /** The name of the state that a value stands for; null for a quantity, and for what is no number. */
    nameOf(value) {
      if (typeof value !== "number" && typeof value !== "bigint") return null;
      const row = rows.find(([, other]) => other == value || (Number.isNaN(other) && Number.isNaN(value)));
      return row === undefined ? null : row[0];
    },
  });
}
