const DIGIT_PATTERNS = { decimal: /^[0-9]+$/, upper_hex: /^[0-9A-F]+$/, lower_hex: /^[0-9a-f]+$/, bcd: /^[0-9]+$/ };

const isHexadecimal = ({ digits }) => digits === "upper_hex" || digits === "lower_hex";

/** The number of digits, the most significant digit first; undefined for anything but such digits. */
export function digitsNumber(value, bytes) {
  let text = String.fromCharCode(...bytes);
  if (value.digits === "bcd") text = Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  if (value.hasBlanks) return numberBehindBlanks(value, text);
  const sign = value.hasSign ? text[0] : "";
  if (value.hasSign && sign !== "+" && sign !== "-") return undefined;
  if (value.hasSign) text = text.slice(1);
  if (value.places) {
    const point = text.length - value.places - 1;
    if (text[point] !== ".") return undefined;
    text = text.slice(0, point) + text.slice(point + 1);
  }
  if (!DIGIT_PATTERNS[value.digits].test(text)) return undefined;
  const whole = BigInt(isHexadecimal(value) ? `0x${text}` : text);
  return sized(value.bits ? BigInt.asIntN(value.bits, whole) : sign === "-" ? -whole : whole);
}

/** A number that a double has exactly as a number, any other as it is. */
const sized = (number) => (Number.isSafeInteger(Number(number)) ? Number(number) : number);

/** The number of ` -1.25`, whose first digit is a zero only before the point; undefined for anything else. */
function numberBehindBlanks({ places = 0, signed }, text) {
  const [, sign, whole, fraction = ""] = /^ *(-?)(0|[1-9][0-9]*)(?:\.([0-9]+))?$/.exec(text) ?? [];
  if (whole === undefined || fraction.length !== places || (sign && !signed)) return undefined;
  const number = BigInt(whole + fraction);
  return sized(sign ? -number : number);
}

/** The bytes of the digits of a number, the most significant digit first. */
export function digitsBytes(value, number) {
  const whole = value.bits ? BigInt.asUintN(value.bits, BigInt(number)) : BigInt(number);
  const count = value.digits === "bcd" ? 2 * value.size : value.size - (value.hasSign ? 1 : 0) - (value.places ? 1 : 0);
  const least = value.hasBlanks ? (value.places ?? 0) + 1 : count;
  let text = (whole < 0n ? -whole : whole).toString(isHexadecimal(value) ? 16 : 10).padStart(least, "0");
  if (value.digits === "bcd") return Uint8Array.from({ length: value.size }, (_, at) => parseInt(text.slice(2 * at, 2 * at + 2), 16));
  if (value.digits === "upper_hex") text = text.toUpperCase();
  if (value.places) text = `${text.slice(0, -value.places)}.${text.slice(-value.places)}`;
  if (value.hasSign) text = (whole < 0n ? "-" : "+") + text;
  if (value.hasBlanks) text = (whole < 0n ? `-${text}` : text).padStart(value.size, " ");
  return Uint8Array.from(text, (character) => character.charCodeAt(0));
}
