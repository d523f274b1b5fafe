import { isWhole } from "./numbers.js";
import { typeBounds } from "./frames.js";
import { bytesOfNumber, orderOf } from "./interpreter.js";
import { decodeAnswer, decodeValue, forWriting, meaningOf } from "./values.js";
import { SENTENCES } from "./sentences.js";
import { byteCount, isWithin, sentence } from "./texts.js";

/** The parameter with a number of a set. */
export function parameterNumbered(words, number) {
  return words.parameters.find((row) => row.number <= number && number < row.number + (row.count ?? 1));
}

/** A number as the manual writes it. */
export function numberText(words, number) {
  if (!words.digits) return String(number);
  const [least, base, upper, after] = words.digits;
  const digits = BigInt(number).toString(base).padStart(least, "0");
  return `${words.printedAs ?? ""}${upper ? digits.toUpperCase() : digits}${after}`;
}

/** The set, named or in a space, that has a number on the wire, and the number in it. */
export function parameterAt(device, name, wireNumber) {
  for (const words of device.setsNamed(name)) {
    const number = Number(wireNumber) - words.base;
    if (parameterNumbered(words, number) || (words.numbers && isWithin(words.numbers, number))) return { words, number };
  }
  return undefined;
}

/** A parameter of a set, or one of its elements. `parameter` is undefined for a number that the spec does not list. */
class ParameterElement {
  constructor(words, number, parameter, index = null, subindex = undefined) {
    Object.assign(this, { words, number, parameter, index, subindex });
  }

  get fact() {
    return this.subindex ?? this.parameter;
  }

  get meaning() {
    const index = this.index === null ? "" : `[${this.index}]`;
    const text = sentence(SENTENCES.PARAMETER, { number: numberText(this.words, this.number) + index });
    if (!this.fact) return meaningOf(this.words.name, "", text);
    const names = new Set([this.parameter, this.subindex].map((fact) => fact?.name).filter(Boolean));
    return meaningOf([...names].join("."), this.fact.label, text);
  }

  get source() {
    return this.fact?.source || this.parameter?.source || "";
  }
}

function elementOf(words, number, parameter, at) {
  const several = parameter && (parameter.elements !== undefined || parameter.subindices);
  if (!several || !isWhole(at ?? "")) return new ParameterElement(words, number, parameter);
  const subindex = parameter.subindices?.find(({ indices }) => isWithin(indices, at));
  return new ParameterElement(words, number, parameter, at, subindex);
}

/** The parameter and its number at a place among the values of all numbers of a set; nothing after the last. */
function placedParameter({ parameters }, place) {
  let rest = place;
  for (const parameter of parameters) {
    const { number, count = 1 } = parameter;
    if (rest < count) return [parameter, number + rest];
    rest -= count;
  }
  return [];
}

/**
 * The row of element `index` of a field, with the name and the meaning that its parameter gives it. `known` are the
 * values of the frame so far and those of the request that it answers. `outer` is the message.
 */
export function withParameter(device, row, field, index, known, outer, isRequest) {
  if (!field.value?.parameter) return row;
  const [name, part, numberField] = field.value.parameter;
  if (part === "values") {
    const [words] = device.setsNamed(name);
    const [parameter, number] = placedParameter(words, index);
    if (!parameter) return row;
    return readAs(device, row, field, new ParameterElement(words, number, parameter), isRequest);
  }
  const asked = part === "number" ? row.number : known.get(numberField);
  const match = isWhole(asked ?? "") ? parameterAt(device, name, asked) : undefined;
  if (!match) return row;
  const { words, number } = match;
  let at = null;
  if (part === "subindex") {
    at = row.number;
  } else if (part !== "number") {
    const first = known.get(outer.indices?.[numberField]) ?? 0;
    at = isWhole(first) ? Number(first) + index : null;
  }
  const element = elementOf(words, number, parameterNumbered(words, number), at);
  if (part === "value") {
    const size = statedSize(field, known);
    // Its bytes are not a value.
    if (size === undefined) return { ...row, meanings: [element.meaning, ...row.meanings] };
    return readAs(device, row, field, element, isRequest, size);
  }
  if (part === "subindex" && element.index === null) return row;
  return { ...row, meanings: [...row.meanings, element.meaning] };
}

/** How many bytes of a field are the value of a parameter: 0 where what should say so does not; undefined for none. */
function statedSize(field, known) {
  const [, , by, sizes] = field.valueBytes ?? [];
  if (!by) return field.size;
  const stated = known.get(by);
  if (!isWhole(stated ?? "")) return 0;
  return sizes.find(([number]) => BigInt(stated) === BigInt(number))?.[1];
}

/** The row with its first bytes read as the value of a parameter. No codec refuses a frame for what is wrong with that. */
function readAs(device, row, field, element, isRequest, size = field.size) {
  const { fact, parameter, meaning } = element;
  if (!fact || !parameter) return { ...row, meanings: [meaning, ...row.meanings] };
  const again = row.reason ? undefined : field.valueBytes ? parameterBytes(fact, field, row, size) : bytesAgain(fact.value, field, row);
  if (!again) {
    const named = { ...row, meanings: [meaning, ...row.meanings], notes: [...row.notes, ...(fact.notes ?? [])] };
    if (row.reason || !field.valueBytes || parameter.reserved || fact.reserved) return named;
    const stated = fact.value.size;
    // A text may come without the zeros that fill it up.
    if (fact.value.kind === "text" && size < stated) return named;
    return { ...named, verdict: sentence(SENTENCES.SHOULD_BE, { expected: byteCount(stated) }), reason: "out_of_range" };
  }
  const value = { ...(isRequest ? forWriting(fact.value) : fact.value), order: again.order };
  const read = (isRequest ? decodeValue : decodeAnswer)(device, value, again.bytes, fact.reserved, parameter.trigger);
  const errata = [...row.errata, ...device.errataAt(parameter.path), ...device.errataOfWords(read.facts)];
  return {
    ...row,
    fact: fact.path,
    doc: fact.doc || row.doc,
    number: read.number,
    value: read.text,
    meanings: [meaning, ...read.meanings],
    verdict: read.verdict,
    reason: read.reason ? "out_of_range" : "",
    source: element.source || row.source,
    notes: [...row.notes, ...(fact.notes ?? []), ...read.notes],
    errata: [...new Set(errata)],
  };
}

/** The bytes of a parameter's value in a field of bytes, with their order; undefined where they are not as many. */
function parameterBytes({ value, byteOrder }, field, row, size) {
  if (size !== value.size) return undefined;
  const [own, words] = field.valueBytes;
  const order = byteOrder ?? own;
  const hasWords = value.size > 2 && value.size % 2 === 0;
  return { bytes: row.raw.subarray(0, size), order: orderOf(value, order, hasWords && Boolean(words) && words !== order) };
}

const COUNTS = ["integer", "boolean"];

/** The bytes of a row as bytes of another value, with their order; undefined if they cannot be read as it. */
function bytesAgain(value, field, row) {
  const own = field.value;
  const areCounts = COUNTS.includes(own.kind) && COUNTS.includes(value.kind);
  const alike = own.kind === value.kind || areCounts;
  if (!own.digits && value.size === field.size && (alike || (own.kind !== "float" && value.kind !== "float"))) {
    return { bytes: row.raw, order: orderOf(value, ...field.valueOrder) };
  }
  const [low, high] = areCounts && isWhole(row.number) ? typeBounds(value) : [1, 0];
  if (low > row.number || row.number > high) return undefined;
  return { bytes: bytesOfNumber(row.number, value.size, "big", value.signed), order: undefined };
}
