import {
  decimalOf, decimalQuotient, decimalRounded, decimalSum, decimalText, floatText, isWhole,
} from "./numbers.js";
import { loaded, WIDE, wholeOf } from "./interpreter.js";
import { py } from "./python.js";
import { SENTENCES } from "./sentences.js";
import { intervalsText, isWithin, sameValue, sentence, valueText } from "./texts.js";
import { memberOf } from "./device.js";

/** Reasons with which a codec still accepts a value. */
export const ACCEPTED = ["", "out_of_range"];

const EXACT_DIGITS = 120;

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
  if (below === undefined) {
    const { coefficient, exponent } = decimalOf(scale);
    return decimalSum({ coefficient: BigInt(number) * coefficient, exponent }, decimalOf(offset));
  }
  const share = decimalQuotient(BigInt(number) * BigInt(above), BigInt(below), EXACT_DIGITS);
  return decimalRounded(decimalSum(share, decimalOf(offset)), EXACT_DIGITS);
}

/** Whether a value has ranges, and a number is in one of them. */
export const hasInRanges = (value, number) => isWithin(value.ranges ?? [], number);

export const intervalsOf = (value) => value.ranges ?? [];

/** A value with the scale that the number of its exponent makes; unchanged for a number that is not an exponent. */
export function exponentApplied(value, exponent, number) {
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
export class DecodedValue {
  constructor(number, { text = "", meanings = [], verdict = "", reason = "", notes = [], facts = [] } = {}) {
    [this.number, this.text, this.meanings, this.verdict, this.reason] = [number, text, meanings, verdict, reason];
    [this.notes, this.facts] = [notes, facts];
  }

  /** The same value with a verdict: right, or wrong with what it should be. */
  judged(isRight, expected, reason) {
    return py.replace(this, isRight ? { verdict: "right", reason: "" } : { verdict: sentence(SENTENCES.SHOULD_BE, { expected }), reason });
  }
}

/** What a verdict says of a wrong value: `should be 5`. */
export function faultOf(verdict) {
  return verdict.replace(sentence(SENTENCES.WRONG, { fault: "" }), "");
}

/** A name of a value, or of some of its bits: `bits` is empty, `3`, or `9..10`. */
export class Meaning {
  constructor(name, label, text, bits = "") {
    Object.assign(this, { name: name ?? "", label: label ?? "", text: text ?? "", bits });
  }
}

/** The value with the range of writing as its only range. */
export function forWriting(value) {
  const { ranges, writeRanges = ranges, order, writePlaces = order } = value;
  return { ...value, ranges: writeRanges, order: writePlaces };
}

/** The meaning of the bytes of a value that is read: a constant binds only what is written; a trigger has its type alone. */
export function decodeAnswer(device, value, bytes, _order, _isSwapped, reserved, isTrigger) {
  let read = decodeValue(device, value, bytes, "", false, reserved);
  if (read.reason === "wrong_const") {
    const answer = decodeValue(device, { ...value, const: undefined }, bytes, "", false, reserved);
    read = py.replace(answer, { notes: [...answer.notes, sentence(SENTENCES.IT, { statement: faultOf(read.verdict) })] });
  }
  if (!isTrigger) return read;
  const { reason } = decodeValue(device, { ...value, const: undefined, enum: undefined }, bytes, "", false, reserved);
  return reason === "unknown_value" ? read : py.replace(read, { verdict: "", reason: "" });
}

/** The meaning of all bytes of a value, which knows their order. Never throws. */
export function decodeValue(device, value, bytes, _order, _isSwapped, reserved = false) {
  return decodedRow(device, loaded({ value, reserved }, bytes), value);
}

/** The meaning of what some bytes gave; `value` is that of the field, with a scale that is read. */
export function decodedRow(device, { field, image, content, number }, value) {
  if (field.reserved || value.kind === "bytes") return new DecodedValue(number);
  if (content === null) {
    return new DecodedValue(number).judged(false, image === null ? value.sentForm ?? value.form : value.form, "unknown_value");
  }
  switch (value.kind) {
    case "boolean": return decodedBoolean(device, value, number);
    case "text": return new DecodedValue(number);
    case "float": return decodedFloat(value, number);
    case "integer": return decodedWhole(device, value, number);
    default: throw new RangeError(`unknown kind: ${value.kind}`);
  }
}

function decodedFloat(value, number) {
  const sentinel = sentinelOf(value, number);
  if (sentinel) return new DecodedValue(number, { meanings: [new Meaning(sentinel.name, "", sentinel.doc)] });
  const result = new DecodedValue(number, { text: value.unit ? `${floatText(number, value.size)} ${value.unit}` : "" });
  if (value.ranges === undefined || isWithin(value.ranges, number)) return result;
  return result.judged(false, `${intervalsText(value.ranges)} ${value.unit ?? ""}`.trim(), "out_of_range");
}

function decodedBoolean(device, value, number) {
  if (typeof number !== "boolean") return new DecodedValue(number).judged(false, SENTENCES.TRUTH_NUMBERS, "unknown_value");
  return value.enum ? py.replace(namedValue(device, value, Number(number)), { number }) : new DecodedValue(number);
}

function decodedWhole(device, value, number) {
  if (value.const !== undefined && number != value.const) return new DecodedValue(number).judged(false, value.const, "wrong_const");
  let result = new DecodedValue(number, { verdict: value.const === undefined ? "" : "right" });
  const sentinel = sentinelOf(value, number);
  if (sentinel) return py.replace(result, { meanings: [new Meaning(sentinel.name, "", sentinel.doc)] });
  if (value.enum) {
    const named = namedValue(device, value, number);
    result = py.replace(named, { text: inUnit(value, number), verdict: named.verdict || result.verdict });
  } else if (value.flags) {
    const word = device.flags.get(value.flags);
    const meanings = setBitsOf(device, word, number);
    const notes = word.remark && meanings.some(({ bits }) => bits) ? [word.remark] : [];
    result = py.replace(result, { meanings, notes, facts: [word.path] });
  } else {
    result = py.replace(result, { text: inUnit(value, number) });
  }
  if (!result.reason && value.ranges !== undefined && !isWithin(value.ranges, number)) {
    result = result.judged(false, rangeInUnit(value, value.ranges), "out_of_range");
  }
  const bit = !result.reason && value.flags && refusedBitOf(device.flags.get(value.flags), number);
  if (bit) result = result.judged(false, `${bit.name} ${rangeInUnit(bit, bit.ranges)}`, "out_of_range");
  return result;
}

/** The meaning of a number that a member of the value's enum names. */
function namedValue(device, value, number) {
  const listing = device.enums.get(value.enum);
  const member = memberOf(listing, number);
  if (!member && listing.open) {
    const note = sentence(SENTENCES.UNLISTED_MEMBER, { enum: listing.name, number });
    return new DecodedValue(number, { notes: [note], facts: [listing.path] });
  }
  const meanings = member && [new Meaning(member.name, member.label, member.problem || member.doc)];
  const result = new DecodedValue(number, member && { meanings, notes: member.notes ?? [], facts: [listing.path, member.path] });
  return member && (listing.open || !member.unavailable) ? result : result.judged(false, listing.taken, "unknown_value");
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
    if ((unknown >> BigInt(at)) & 1n) meanings.push(new Meaning("", "", SENTENCES.UNLISTED_BIT, String(at)));
  }
  for (const state of word.states ?? []) {
    if ((raw & BigInt(state.mask ?? 0)) === BigInt(state.value ?? 0)) {
      meanings.push(new Meaning(state.name, state.label, state.text));
    }
  }
  return meanings;
}

/** The adjacent bits of a field of bits: the first one, and as many as there are, the least significant run first. */
const runsOf = ({ runs, first, width }) => runs ?? [[first, width]];

/** The bits of a field of bits in its word. */
export function bitMask(bit) {
  return bitsPlaced(bit, -1n);
}

/** The word in which the bits of a field are those of a number, and all others are 0. */
export function bitsPlaced(bit, number) {
  let [word, rest] = [0n, number];
  for (const [first, width] of runsOf(bit)) {
    word |= BigInt.asUintN(width, rest) << BigInt(first);
    rest >>= BigInt(width);
  }
  return word;
}

/** The first field of bits whose number in a word is not in its range. */
export function refusedBitOf(word, number) {
  const raw = BigInt.asUintN(8 * word.size, BigInt(number));
  return word.bits?.find((bit) => bit.ranges && !isWithin(bit.ranges, bitsNumber(bit, raw)));
}

/** The number of a field of bits in a word. */
export function bitsNumber(bit, raw) {
  let [number, weight] = [0n, 0n];
  for (const [first, width] of runsOf(bit)) {
    number |= BigInt.asUintN(width, raw >> BigInt(first)) << weight;
    weight += BigInt(width);
  }
  const signed = bit.signed ? BigInt.asIntN(bit.width, number) : number;
  return bit.width > 8 * WIDE ? signed : Number(signed);
}

function bitMeaning(device, bit, number) {
  const runs = runsOf(bit).map(([first, width]) => (width === 1 ? String(first) : `${first}..${first + width - 1}`));
  const bits = runs.join(", ");
  const member = bit.enum && memberOf(device.enums.get(bit.enum), number);
  if (member) return new Meaning(`${bit.name}=${member.name}`, member.label || bit.label, member.doc, bits);
  if (bit.width > 1) {
    const text = [inUnit(bit, number), bit.text].filter(Boolean).join(": ");
    return new Meaning(`${bit.name}=${number}`, bit.label, text, bits);
  }
  return new Meaning(bit.name, bit.label, bit.text, bits);
}

/** A decoded value, compared with the one that it repeats. */
export function repeatedValue(read, expected, value) {
  return read.judged(sameValue(read.number, expected), valueText(expected, value?.kind === "float" ? value.size : 0), "");
}

/** Bytes as an unsigned number. */
export function whole(bytes, order) {
  return wholeOf(bytes, order === "big" ? "big" : "little", false);
}
