import { isWhole } from "./numbers.js";
import { typeBounds } from "./frames.js";
import { bytesOfNumber, orderOf } from "./interpreter.js";
import { isWithin } from "./texts.js";
import { forWriting } from "./values.js";

/** A value that may be read again from the bytes of a field. */
const parameterValue = (value, byteOrder) => ({ ...value, byteOrder, encoding: value.kind, forWriting: () => ({ ...forWriting(value), byteOrder }) });

/** A parameter of a set. */
class Parameter {
  constructor(data) {
    Object.assign(this, { count: 1, ...data, value: parameterValue(data.value, data.byteOrder) });
    this.subindices = data.subindices?.map((own) => ({ ...own, value: parameterValue(own.value, own.byteOrder) })) ?? [];
  }

  element(index) {
    return this.subindices.find(({ indices }) => isWithin(indices, index));
  }
}

/** A set of parameters. */
export class ParameterSet {
  constructor(data) {
    Object.assign(this, data, { parameters: data.parameters.map((parameter) => new Parameter(parameter)) });
  }

  /** The parameter and its number at a place among the values of all numbers; nothing after the last. */
  atPlace(place) {
    let rest = place;
    for (const parameter of this.parameters) {
      if (rest < parameter.count) return [parameter, parameter.number + rest];
      rest -= parameter.count;
    }
    return null;
  }

  numbered(number) {
    return this.parameters.find((own) => own.number <= number && number < own.number + own.count);
  }

  holds(number) {
    return Boolean(this.numbered(number)) || isWithin(this.numbers ?? [], number);
  }

  numberText(number) {
    if (!this.digits) return String(number);
    const [least, base, upper, after] = this.digits;
    const digits = BigInt(number).toString(base).padStart(least, "0");
    return `${this.printedAs ?? ""}${upper ? digits.toUpperCase() : digits}${after}`;
  }
}

export const isText = (encoding) => encoding === "text";

const COUNTS = ["integer", "boolean"];

/** Another value with the bytes of a field as its own; null if they cannot be read as it. */
export function readAgain(device, value, field, raw, number, size) {
  const withOrder = (bytes, order) => [{ ...value, order }, bytes, "", false];
  if (field.valueBytes) {
    if (size !== value.size) return null;
    const [own, words] = field.valueBytes;
    const order = value.byteOrder ?? own;
    const hasWords = value.size > 2 && value.size % 2 === 0;
    return withOrder(raw.subarray(0, size), orderOf(value, order, hasWords && Boolean(words) && words !== order));
  }
  const { kind, digits } = field.value;
  const areCounts = COUNTS.includes(kind) && COUNTS.includes(value.kind);
  if (!digits && value.size === field.size && (areCounts || kind === value.kind || (kind !== "float" && value.kind !== "float"))) {
    return withOrder(raw, orderOf(value, ...field.valueOrder));
  }
  const [low, high] = areCounts && isWhole(number) ? typeBounds(value) : [1, 0];
  return low > number || number > high ? null : withOrder(bytesOfNumber(number, value.size, "big", value.signed));
}
