import { digitsBytes, digitsNumber } from "./digit_texts.js";
import { bitsOfWhole, exactWhole, wholeOfBits } from "./number_bits.js";

/**
 * The number of a part: a bigint where it has more than six bytes and users see it; NaN for what are not its digits. A
 * part with a `width` has that many bits of its bytes, the first of them at `shift`.
 */
export function readPart(bytes, offset, { size, order, signed, wide, digits, shift, width }) {
  if (width) {
    const whole = readPart(bytes, offset, { size, order, signed, wide });
    return wide ? BigInt.asUintN(width, whole >> BigInt(shift)) : Math.floor(whole / 2 ** shift) % 2 ** width;
  }
  if (digits) return readDigits(bytes, offset, size, digits, wide);
  if (wide) return readWide(bytes, offset, { size, order, signed });
  let number = 0;
  for (let place = 0; place < size; place++) {
    number = number * 256 + bytes[order === "big" ? offset + place : offset + size - 1 - place];
  }
  return wholeOfBits(number, 8 * size, signed);
}

function readDigits(bytes, offset, size, form, wide) {
  const number = digitsNumber({ digits: form }, bytes.subarray(offset, offset + size)) ?? NaN;
  return wide && !Number.isNaN(number) ? BigInt(number) : Number(number);
}

function readWide(bytes, offset, { size, order, signed }) {
  let number = 0n;
  for (let at = 0; at < size; at++) number = (number << 8n) | BigInt(bytes[order === "big" ? offset + at : offset + size - 1 - at]);
  return wholeOfBits(number, 8 * size, signed);
}

/** A code or a subcode: a bigint only where a number does not have it exactly, so that it is equal to that of a message. */
export const readCode = (bytes, offset, part) => exactWhole(readPart(bytes, offset, part));

/** Writes the number of a part; one of some bits adds them to its bytes, where they are 0. */
export function writePart(bytes, offset, { size, order, signed, digits, shift, width }, number) {
  if (width) {
    const whole = readWide(bytes, offset, { size, order, signed });
    writePart(bytes, offset, { size, order, signed }, whole + (BigInt(number) << BigInt(shift)));
    return;
  }
  if (digits) {
    bytes.set(digitsBytes({ digits, size }, number), offset);
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
