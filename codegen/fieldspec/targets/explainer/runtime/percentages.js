import { decimalQuotient, decimalText, isWhole } from "./numbers.js";
import { py } from "./python.js";
import { SENTENCES } from "./sentences.js";
import { sentence } from "./texts.js";
import { Meaning } from "./values.js";

/** The row of a field that carries a signal, with the percentages that its conversions give. */
export function withPercentages(device, row, field, number) {
  if (!field.signal || field.value.kind === "float" || !isWhole(number)) return row;
  const conversions = device.data.conversions.filter(({ signals }) => signals.includes(field.signal));
  const meanings = conversions.map((conversion) => {
    const { name, label, complement, full, references } = conversion;
    const count = complement ? BigInt(full) - BigInt(number) : BigInt(number);
    const percent = decimalText(decimalQuotient(100n * count, BigInt(full), 200), `100/${full}`);
    return new Meaning(name, label, sentence(SENTENCES.PERCENTAGE, { percent, references }));
  });
  return meanings.length ? py.replace(row, { meanings: [...row.meanings, ...meanings] }) : row;
}
