import {
  decimalOf, decimalProduct, decimalQuotient, decimalRounded, decimalSum, decimalText, floatText, isWhole,
} from "./numbers.js";
import { decodedText } from "../encodings.js";
import { bitsOfWhole, realOfBits, wholeOfBits } from "../number_bits.js";
import { intervalsText, isWithin, sameValue, valueText } from "./texts.js";
import { memberOf, unsignedOf } from "./device.js";
import { digitsNumber } from "../digit_texts.js";

const WIDE = 6;
const EXACT_DIGITS = 120;

/** Bytes as a whole number; a bigint if there are more than six of them. `signed` is as in `wholeOfBits`. */
export function wholeOf(bytes, order, signed) {
  if (bytes.length > WIDE) return wholeOfBits(unsignedOf(bytes, order), 8 * bytes.length, signed);
  let bits = 0;
  for (let at = 0; at < bytes.length; at++) bits = bits * 256 + bytes[order === "big" ? at : bytes.length - 1 - at];
  return wholeOfBits(bits, 8 * bytes.length, signed);
}

/** The bytes of a whole number; `signed` is as in `bitsOfWhole`. */
export function bytesOfNumber(number, size, order, signed) {
  const bits = BigInt.asUintN(8 * size, bitsOfWhole(BigInt(number), 8 * size, signed));
  const big = Uint8Array.from({ length: size }, (_, at) => Number((bits >> BigInt(8 * (size - 1 - at))) & 255n));
  return order === "big" ? big : big.reverse();
}

/** Whether the raw value of a value is a sequence, a text or bytes, and not a number. */
export function isArray({ kind }) {
  switch (kind) {
    case "text": case "bytes": return true;
    case "integer": case "float": case "boolean": return false;
    default: throw new RangeError(`unknown kind: ${kind}`);
  }
}

/** Bytes with those of each word of 16 bits turned. */
export function turnedWords(bytes) {
  return Uint8Array.from(bytes, (_, at) => bytes[at ^ 1]);
}

/** The raw value of all bytes of a value; texts and bytes are returned as bytes. */
export function numberOfBytes(value, bytes, order, swapped) {
  if (isArray(value)) return bytes;
  const turned = swapped ? turnedWords(bytes) : bytes;
  const actual = (order === "big") !== Boolean(swapped) ? "big" : "little";
  if (value.digits) return digitsNumber(value, actual === "big" ? turned : Uint8Array.from(turned).reverse()) ?? bytes;
  if (value.kind === "float") return realOfBits(wholeOf(turned, actual, false), bytes.length);
  return wholeOf(turned, actual, value.signed);
}

/** The sentinel with a raw value. */
export function sentinelOf(value, number) {
  const isNan = Number.isNaN(number);
  const stands = ({ value: first, last = first }) => (last === first ? first == number : first <= number && number <= last);
  return value.sentinels?.find((sentinel) => (isNan ? sentinel.nan : !sentinel.nan && stands(sentinel)));
}

/** The exact quantity of a raw count, or 120 digits of it, as a decimal number. */
function quantityOf(value, number) {
  const { scale = "1", offset = "0" } = value;
  const [above, below] = scale.split("/");
  if (below === undefined) return decimalSum(decimalProduct(number, decimalOf(scale)), decimalOf(offset));
  const share = decimalQuotient(BigInt(number) * BigInt(above), BigInt(below), EXACT_DIGITS);
  return decimalRounded(decimalSum(share, decimalOf(offset)), EXACT_DIGITS);
}

/** A value with the scale that the bytes of its exponent make; unchanged where they are no exponent. */
export function exponentApplied(value, exponent, bytes) {
  const number = numberOfBytes(exponent, bytes, exponent.order ?? "big", exponent.swapped);
  const isExponent = isWhole(number) && isWithin(exponent.ranges ?? [], number) && !sentinelOf(exponent, number);
  return isExponent ? scaledBy(value, Number(number)) : value;
}

/** A value with the scale that an exponent makes of it, where `scaleBy` names what has the exponent. */
function scaledBy({ scaleBy, quantityUnit, unit, ...value }, exponent) {
  const scale = exponent < 0 ? `0.${"1".padStart(-exponent, "0")}` : "1".padEnd(exponent + 1, "0");
  return { ...value, ...(exponent === 0 ? {} : { scale, offset: "0" }), ...(quantityUnit ? { unit: quantityUnit } : {}) };
}

/** The quantity of a raw value with its unit; empty for a value without unit and scale, and for a sentinel. */
export function inUnit(value, number) {
  if ((value.unit === undefined && value.scale === undefined) || sentinelOf(value, number)) return "";
  return `${decimalText(quantityOf(value, number), value.scale)} ${value.unit ?? ""}`.trim();
}

function rangeInUnit(value, ranges) {
  const bound = (count) => decimalText(quantityOf(value, count), value.scale);
  const text = ranges.map(([low, high]) => (low == high ? bound(low) : `${bound(low)}..${bound(high)}`)).join(", ");
  return `${text} ${value.unit ?? ""}`.trim();
}

/** A decoded value: its raw value, its quantity, its names, and its verdict with the reason of a fault. */
export function decoded(number, more) {
  return { number, text: "", meanings: [], verdict: "", reason: "", notes: [], facts: [], ...more };
}

/** A decoded value with a verdict: right, or wrong with what it should be. */
export function judged(value, right, should, reason) {
  return right
    ? { ...value, verdict: "right", reason: "" }
    : { ...value, verdict: `wrong: should be ${should}`, reason };
}

/** A name of a value, or of some of its bits: `bits` is empty, `3`, or `9..10`. */
export function meaningOf(name, label, text, bits = "") {
  return { name: name ?? "", label: label ?? "", text: text ?? "", bits };
}

/** The value with the range of writing as its only range. */
export function forWriting(value) {
  return value.writeRanges === undefined ? value : { ...value, ranges: value.writeRanges };
}

/** The meaning of the bytes of a value that is read: a constant binds only what is written. */
export function decodeAnswer(device, value, ...rest) {
  const read = decodeValue(device, value, ...rest);
  if (read.reason !== "wrong_const") return read;
  const answer = decodeValue(device, { ...value, const: undefined }, ...rest);
  return { ...answer, notes: [...answer.notes, `It ${read.verdict.replace("wrong: ", "")}.`] };
}

/** The meaning of all bytes of a value. Never throws. */
export function decodeValue(device, value, bytes, order, swapped, reserved) {
  const number = numberOfBytes(value, bytes, order, swapped);
  if (reserved) return decoded(number);
  switch (value.kind) {
    case "boolean": return decodedBoolean(device, value, number);
    case "text": return decodedCharacters(value, bytes, order);
    case "bytes": return decoded(number);
    case "float": return decodedFloat(value, number);
    case "integer":
      if (value.digits && !isWhole(number)) return judged(decoded(bytes), false, value.digitsText, "unknown_value");
      return decodedWhole(device, value, number);
    default: throw new RangeError(`unknown kind: ${value.kind}`);
  }
}

function decodedCharacters(value, bytes, order) {
  const text = decodedText(value.textForm, bytes, order !== "big");
  if (text === null) return judged(decoded(bytes), false, value.textFormTitle ?? "ASCII", "unknown_value");
  return decoded(text);
}

function decodedFloat(value, number) {
  const sentinel = sentinelOf(value, number);
  if (sentinel) return decoded(number, { meanings: [meaningOf(sentinel.name, "", sentinel.doc)] });
  const result = decoded(number, { text: value.unit ? `${floatText(number, value.size)} ${value.unit}` : "" });
  if (value.ranges === undefined || isWithin(value.ranges, number)) return result;
  return judged(result, false, `${intervalsText(value.ranges)} ${value.unit ?? ""}`.trim(), "out_of_range");
}

function decodedBoolean(device, value, number) {
  if (number != 0 && number != 1) return judged(decoded(number), false, "0 or 1", "unknown_value");
  const named = value.enum ? namedValue(device, value, number) : decoded(number);
  // An enum of a truth value only names what it is.
  return { ...named, number: number == 1, verdict: "", reason: "" };
}

function decodedWhole(device, value, number) {
  if (value.const !== undefined && number != value.const) return judged(decoded(number), false, value.const, "wrong_const");
  let result = decoded(number, { verdict: value.const === undefined ? "" : "right" });
  const sentinel = sentinelOf(value, number);
  if (sentinel) return { ...result, meanings: [meaningOf(sentinel.name, "", sentinel.doc)] };
  if (value.enum) {
    const named = namedValue(device, value, number);
    result = { ...named, text: inUnit(value, number), verdict: named.verdict || result.verdict };
  } else if (value.flags) {
    const word = device.flags.get(value.flags);
    const meanings = setBitsOf(device, word, number);
    const notes = word.countedFromMost && meanings.some(({ bits }) => bits) ? [fromMostText(word)] : result.notes;
    result = { ...result, meanings, notes, facts: [word.path] };
  } else {
    result = { ...result, text: inUnit(value, number) };
  }
  if (!result.reason && value.ranges !== undefined && !isWithin(value.ranges, number)) {
    result = judged(result, false, rangeInUnit(value, value.ranges), "out_of_range");
  }
  const bit = !result.reason && value.flags && refusedBitOf(device.flags.get(value.flags), number);
  if (bit) result = judged(result, false, `${bit.name} ${rangeInUnit(bit, bit.ranges)}`, "out_of_range");
  return result;
}

/** The meaning of a number that a member of the value's enum names. */
function namedValue(device, value, number) {
  const listing = device.enums.get(value.enum);
  const member = memberOf(listing, number);
  if (!member) {
    if (listing.open) return decoded(number, { notes: [`${listing.name} does not list ${number}.`], facts: [listing.path] });
    return judged(decoded(number), false, memberList(listing), "unknown_value");
  }
  const meanings = [meaningOf(member.name, member.label, member.problem || member.doc)];
  const notes = member.notes ?? [];
  const result = decoded(number, { meanings, notes, facts: [listing.path, member.path] });
  if (member.unavailable && !listing.open) {
    const more = [...notes, `${member.name} is listed as not available.`];
    return judged({ ...result, notes: more }, false, memberList(listing), "unknown_value");
  }
  return result;
}

function memberList(listing) {
  return `one of ${listing.members.filter((member) => !member.unavailable).map((member) => member.value).join(", ")}`;
}

/** How the manual numbers the bits of a word whose bit 0 is the most significant one. */
function fromMostText({ size }) {
  const last = 8 * size - 1;
  return `Bit 0 is the least significant one here. The manual counts from the most significant: bit ${last} is its bit 0.`;
}

/** The bits that are 1, fields of several bits with names, bits that the spec does not list, and states. */
function setBitsOf(device, word, number) {
  const raw = BigInt.asUintN(8 * word.size, BigInt(number));
  const meanings = [];
  let unknown = raw;
  for (const bit of word.bits ?? []) {
    const count = bitsNumber(bit, raw);
    unknown &= ~bitMask(bit);
    if (count || ((bit.enum || bit.isNumber) && !bit.reserved)) meanings.push(bitMeaning(device, bit, count));
  }
  for (let at = 0; unknown >> BigInt(at); at++) {
    if ((unknown >> BigInt(at)) & 1n) meanings.push(meaningOf("", "", "not listed", String(at)));
  }
  for (const state of word.states ?? []) {
    if ((raw & BigInt(state.mask ?? 0)) === BigInt(state.value ?? 0)) {
      meanings.push(meaningOf(state.name, state.label, `state ${state.printed ?? ""}`.trim()));
    }
  }
  return meanings;
}

/** The bits of a field of bits in its word. */
export function bitMask({ first, width }) {
  return ((1n << BigInt(width)) - 1n) << BigInt(first);
}

/** The first field of bits whose number in a word is not in its range. */
export function refusedBitOf(word, number) {
  const raw = BigInt.asUintN(8 * word.size, BigInt(number));
  return word.bits?.find((bit) => bit.ranges && !isWithin(bit.ranges, bitsNumber(bit, raw)));
}

/** The number of a field of bits in a word. */
export function bitsNumber(bit, raw) {
  const number = (raw & bitMask(bit)) >> BigInt(bit.first);
  const signed = bit.signed ? BigInt.asIntN(bit.width, number) : number;
  return bit.width > 8 * WIDE ? signed : Number(signed);
}

function bitMeaning(device, bit, number) {
  const bits = bit.width === 1 ? String(bit.first) : `${bit.first}..${bit.first + bit.width - 1}`;
  const member = bit.enum && memberOf(device.enums.get(bit.enum), number);
  if (member) return meaningOf(`${bit.name}=${member.name}`, member.label || bit.label, member.doc, bits);
  if (bit.width > 1) {
    const text = [inUnit(bit, number), bit.doc].filter(Boolean).join(": ");
    return meaningOf(`${bit.name}=${number}`, bit.label, text, bits);
  }
  const text = bit.one || bit.doc || "";
  const edge = bit.edge ? [text.replace(/\.$/, ""), `acts at its ${bit.edge} edge`].filter(Boolean).join("; ") : text;
  return meaningOf(bit.name, bit.label, edge, bits);
}

/** A decoded value, compared with the one that it repeats. */
export function repeatedValue(value, should, floatSize = 0) {
  return judged(value, sameValue(value.number, should), valueText(should, floatSize), "");
}
