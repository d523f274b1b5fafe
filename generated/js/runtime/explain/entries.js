import { CodecError } from "../error.js";
import { roundedReal } from "../number_bits.js";
import { bytesOfHex, hexOf, latinOf } from "./texts.js";
import { floatText } from "./numbers.js";
import { memberOf } from "./device.js";
import { bitMask, bitsPlaced, inUnit, sentinelOf } from "./values.js";

const COUNT = /^[-+]?(?:0x[0-9A-Fa-f]{1,16}|0|[1-9][0-9]{0,19})$/;
const NUMBER = /^[-+]?(?:0|[1-9][0-9]{0,19})(?:\.[0-9]{1,30})?(?:[eE][-+]?[0-9]{1,3})?$/;
const QUANTITY = /^([-+]?(?:0|[1-9][0-9]{0,29})(?:\.[0-9]{1,30})?)(?: (?=.)|(?=[^0-9 ]))(.*)$/s;
const LETTERS = { float: { nan: NaN, inf: Infinity, "-inf": -Infinity } };

/** The whole number that a text is, in decimal or hexadecimal; undefined where it is none. */
export function countOf(text) {
  if (!COUNT.test(text)) return undefined;
  const count = BigInt(text.replace(/^[-+]/, ""));
  return narrowed(text.startsWith("-") ? -count : count);
}

function narrowed(count) {
  return count >= -(2n ** 53n) && count <= 2n ** 53n ? Number(count) : count;
}

/** A decimal number, or a fraction of two whole numbers, as an exact fraction of bigints. */
function fractionOf(text) {
  const [above, below = "1"] = text.split("/");
  const [whole, places = ""] = above.replace(/^\+/, "").split(".");
  return [BigInt(whole + places), BigInt(below) * 10n ** BigInt(places.length)];
}

/** The exact count of a quantity as a fraction: (quantity - offset) / scale. */
function exactCount(value, text) {
  const [above, below] = fractionOf(text);
  const [shift, under] = fractionOf(value.offset ?? "0");
  const [factor, divisor] = fractionOf(value.scale ?? "1");
  const [top, bottom] = [(above * under - shift * below) * divisor, below * under * factor];
  return bottom < 0n ? [-top, -bottom] : [top, bottom];
}

function nearestCount([above, below]) {
  let whole = above / below;
  if (above % below < 0n) whole -= 1n;
  const twice = 2n * (above - whole * below);
  return twice > below || (twice === below && whole % 2n !== 0n) ? whole + 1n : whole;
}

/** A raw value as a person enters it: a member, a quantity, digits. */
export function entryOf(device, value, raw, inDigits = false) {
  if (raw instanceof Uint8Array) return value.kind === "text" ? latinOf(raw).replace(/\0+$/, "") : hexOf(raw, " ");
  if (typeof raw === "string") return raw;
  const sentinel = sentinelOf(value, raw);
  if (sentinel) return sentinel.name;
  switch (value.kind) {
    case "boolean": return String(raw == 1);
    case "float": return floatText(raw, value.size);
    case "integer": return countText(device, value, raw, inDigits);
    default: throw new RangeError(`no number has the kind ${value.kind}`);
  }
}

function countText(device, value, raw, inDigits) {
  const member = value.enum && memberOf(device.enums.get(value.enum), raw);
  if (member) return member.name;
  if (value.flags || inDigits) {
    const digits = BigInt.asUintN(8 * value.size, BigInt(raw)).toString(16).toUpperCase();
    return `0x${digits.padStart(2 * value.size, "0")}`;
  }
  return quantityText(value, raw) || String(raw);
}

/** The quantity of a raw value, if it leads back to the raw value: a rounded one may not. */
function quantityText(value, raw) {
  const text = inUnit(value, raw);
  const [, quantity] = QUANTITY.exec(text) ?? [];
  if (quantity === undefined || !value.unit) return "";
  const exact = exactCount(value, quantity);
  const isCount = value.isShare || exact[0] % exact[1] === 0n;
  return isCount && nearestCount(exact) === BigInt(raw) ? text : "";
}

/** The raw value of an entered text. Throws CodecError, which calls the value `name`. */
export function rawOf(device, name, value, text) {
  const entered = text.trim();
  if (value.flags && COUNT.test(entered) === false) return wordOf(device, name, value, entered);
  switch (value.kind) {
    case "boolean":
      return /^(?:true|false|1|0)$/i.test(entered) ? /^(?:true|1)$/i.test(entered) : countEntry(device, name, value, entered);
    case "text": return text;
    case "bytes": return bytesEntry(name, entered);
    case "float": return floatEntry(name, value, entered);
    case "integer": return countEntry(device, name, value, entered);
    default: throw new RangeError(`unknown kind: ${value.kind}`);
  }
}

function bytesEntry(name, text) {
  const digits = text.replace(/\s+/g, "");
  if (!/^(?:[0-9a-f]{2})*$/i.test(digits)) {
    throw new CodecError("wrong_type", `${name}: bytes are written as pairs of hexadecimal digits`);
  }
  return bytesOfHex(digits);
}

function floatEntry(name, value, text) {
  const sentinel = value.sentinels?.find((other) => other.name === text);
  if (sentinel) return sentinel.nan ? NaN : Number(sentinel.value);
  const [, quantity, unit] = QUANTITY.exec(text) ?? [];
  if (unit !== undefined && unit === value.unit) {
    const sent = roundedReal(Number(quantity), value.size);
    const absent = sentinelOf(value, sent);
    if (absent) throw new CodecError("out_of_range", `${name}: \`${text}\` would be sent as ${floatText(sent, value.size)}, ${meantBy(absent)}`);
    return Number(quantity);
  }
  if (text in LETTERS.float) return LETTERS.float[text];
  if (!NUMBER.test(text)) throw new CodecError("wrong_type", `${name}: \`${text}\` is not a number; write it as \`0.5\` or \`2.5e-3\``);
  return Number(text);
}

function meantBy({ name }) {
  return `which stands for ${name}; write \`${name}\` if you mean that`;
}

/** The raw value of a count, a member's name, a sentinel's name, or a quantity with its unit. */
function countEntry(device, name, value, text) {
  const count = countOf(text);
  if (count !== undefined) return count;
  const listing = value.enum && device.enums.get(value.enum);
  const member = listing && listing.names.get(text);
  if (member) return member.value;
  const sentinel = value.sentinels?.find((other) => other.name === text);
  if (sentinel) return sentinel.value;
  const [, quantity, unit] = QUANTITY.exec(text) ?? [];
  if (unit !== undefined && unit === value.unit) return quantityEntry(name, value, text, quantity);
  if (listing) {
    const names = listing.members.map((other) => other.name).join(", ");
    throw new CodecError("unknown_value", `${name}: \`${text}\` is not a member of ${value.enum}: ${names}`);
  }
  const more = value.unit ? `, or with its unit ${value.unit}` : "";
  throw new CodecError("wrong_type", `${name}: \`${text}\` is not a number; enter a count${more}`);
}

function quantityEntry(name, value, text, quantity) {
  const exact = exactCount(value, quantity);
  if (!value.isShare && exact[0] % exact[1] !== 0n) {
    throw new CodecError("wrong_type", `${name}: \`${text}\` is not a whole number of counts of ${value.scale ?? 1} ${value.unit}`);
  }
  const count = narrowed(nearestCount(exact));
  const absent = sentinelOf(value, count);
  if (absent) throw new CodecError("out_of_range", `${name}: \`${text}\` would be the count ${count}, ${meantBy(absent)}`);
  return count;
}

/**
 * The word with the named bits set. `name=member` or `name=number` sets a field of several bits. Fields that are not
 * named have their defaults, else 0; throws CodecError where 0 would mean something.
 */
function wordOf(device, name, value, text) {
  const special = value.sentinels?.find((other) => other.name === text);
  if (special) return special.value;
  const word = device.flags.get(value.flags);
  const named = new Set();
  let result = 0n;
  for (const bit of word.bits ?? []) result |= bitsPlaced(bit, BigInt(bit.default ?? 0));
  for (const item of text.split(/[, ]+/).filter(Boolean)) {
    const [bitName, setting] = item.split("=");
    const bit = word.bits?.find((other) => other.name === bitName);
    if (!bit) {
      const names = (word.bits ?? []).filter(({ reserved }) => !reserved).map((other) => other.name).join(", ");
      throw new CodecError("unknown_value", `${name}: \`${bitName}\` is not a bit of ${value.flags}: ${names}`);
    }
    if (named.has(bitName)) throw new CodecError("wrong_type", `${name}: \`${bitName}\` has two values`);
    named.add(bitName);
    const number = setting === undefined ? 1n : BigInt(countEntry(device, `${name}.${bitName}`, bit, setting));
    const high = (1n << BigInt(bit.width - (bit.signed ? 1 : 0))) - 1n;
    if (number > high || number < (bit.signed ? -high - 1n : 0n)) {
      throw new CodecError("out_of_range", `${name}: ${number} does not fit the ${bit.width} bits of ${bitName}`);
    }
    result = (result & ~bitMask(bit)) | bitsPlaced(bit, number);
  }
  const missing = word.needed?.find(([, , names]) => !names.some((other) => named.has(other)));
  if (missing) {
    const [own, reason] = missing;
    throw new CodecError("missing_value", `${name}: \`${own}\` is not given, and its ${reason}; give \`${own}=\`, or the whole word`);
  }
  return narrowed(result);
}
