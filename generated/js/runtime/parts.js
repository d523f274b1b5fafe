import { bitsOfWhole, wholeOfBits } from "./number_bits.js";

const known = { decimal: "0123456789", upper_hex: "0123456789ABCDEF", lower_hex: "0123456789abcdef" };

/** The number of a part: a bigint where it has more than six bytes and users see it; NaN for what are not its digits. */
export function readPart(bytes, offset, { size, order, signed, wide, digits }) {
  if (digits) return readDigits(bytes, offset, size, digits, wide);
  if (wide) return readWide(bytes, offset, { size, order, signed });
  let number = 0;
  for (let place = 0; place < size; place++) {
    number = number * 256 + bytes[order === "big" ? offset + place : offset + size - 1 - place];
  }
  return wholeOfBits(number, 8 * size, signed);
}

function readDigits(bytes, offset, size, form, wide) {
  const text = String.fromCharCode(...bytes.subarray(offset, offset + size));
  if (![...text].every((digit) => known[form].includes(digit))) return NaN;
  const number = BigInt(form === "decimal" ? text : `0x${text}`);
  return wide ? number : Number(number);
}

function readWide(bytes, offset, { size, order, signed }) {
  let number = 0n;
  for (let at = 0; at < size; at++) number = (number << 8n) | BigInt(bytes[order === "big" ? offset + at : offset + size - 1 - at]);
  return wholeOfBits(number, 8 * size, signed);
}

/** Writes the number of a part. */
export function writePart(bytes, offset, { size, order, signed, digits }, number) {
  if (digits) {
    const text = number.toString(known[digits].length).padStart(size, "0");
    const cased = digits === "upper_hex" ? text.toUpperCase() : text;
    for (let at = 0; at < size; at++) bytes[offset + at] = cased.charCodeAt(at);
    return;
  }
  const bits = bitsOfWhole(number, 8 * size, signed);
  if (typeof bits === "bigint") {
    for (let at = 0; at < size; at++) {
      bytes[order === "big" ? offset + size - 1 - at : offset + at] = Number((bits >> BigInt(8 * at)) & 255n);
    }
    return;
  }
  let rest = bits;
  for (let place = size - 1; place >= 0; place--) {
    bytes[order === "big" ? offset + place : offset + size - 1 - place] = rest % 256;
    rest = Math.floor(rest / 256);
  }
}
