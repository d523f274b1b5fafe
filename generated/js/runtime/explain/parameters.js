import { Meaning, decodeAnswer, decodeValue } from "./values.js";
import { Message, citations } from "./layouts.js";
import { SENTENCES } from "./sentences.js";
import { byteCount } from "./texts.js";
import { errataAt, errataOfWords } from "./device.js";
import { isText, readAgain } from "./parameter_sets.js";
import { py } from "./python.js";

/** Parameters in a frame. */

/** A parameter of a set, or one of its elements. `parameter` is None for a number that the spec does not list. */
class ParametersElement {
  constructor({ parameterSet, number, parameter, index, subindex }) {
    this.parameterSet = parameterSet;
    this.number = number;
    this.parameter = parameter;
    this.index = index;
    this.subindex = subindex;
  }

  /** Its name, or that of the set if the spec does not list the number, with the number as printed. */
  get meaning() {
    const index = this.index == null ? "" : `[${this.index}]`;
    const text = py.format(SENTENCES.PARAMETER, { number: this.parameterSet.numberText(this.number) + index });
    const fact = this.fact;
    if (fact == null) {
      return new Meaning(this.parameterSet.name, "", text, "");
    }
    const names = py.dict([this.parameter, this.subindex].filter((fact) => fact != null && fact.name).map((fact) => fact.name).map((key) => [key, null]));
    return new Meaning(py.join(".", names), fact.label, text, "");
  }

  /** The subindex or the parameter that describes the element. */
  get fact() {
    return py.either(this.subindex, () => this.parameter);
  }

  /** The places where the manual prints it, as text. */
  get citations() {
    const [fact, parameter] = [this.fact, this.parameter];
    const own = fact != null ? fact.source : [];
    return citations(py.either(own, () => (parameter != null ? parameter.source : [])));
  }
}

/**
 * The row of element `index` of a field, with the name and the meaning that its parameter gives it.
 *
 * `known` are the values of the frame so far and of the request that it answers. `outer` is the message.
 */
export function withParameter(device, row, field, index, known, outer, isRequest) {
  let element, elementNumber, number, parameterSet;
  const part = py.truth(field.value) ? field.value.parameter : null;
  if (part == null) {
    return row;
  }
  if (part.part === "values") {
    parameterSet = device.sets(part.set)[0];
    const placed = parameterSet.atPlace(index);
    if (placed == null) {
      return row;
    }
    let parameter;
    [parameter, number] = placed;
    element = new ParametersElement({ parameterSet, number, parameter, index: null, subindex: null });
    return parametersReadAs(device, row, field, element, isRequest, field.size);
  }
  const parameterNumber = part.part === "number" ? row.number : known.get(part.number);
  const match = py.isWhole(parameterNumber) ? device.parameterAt(part.set, parameterNumber) : null;
  if (match == null) {
    return row;
  }
  [parameterSet, number] = match;
  const knownParameter = parameterSet.numbered(number);
  if (part.part === "number") {
    elementNumber = null;
  } else if (part.part === "subindex") {
    elementNumber = row.number;
  } else {
    const first = (known.get(indexField(outer, part)) ?? 0);
    elementNumber = py.isWhole(first) ? (py.int(first) + index) : null;
  }
  element = parametersElement(parameterSet, number, knownParameter, elementNumber);
  if (part.part === "value") {
    let size = field.size;
    if (part.sizes != null) {
      const stated = known.get(part.sizes.by);
      if (py.isWhole(stated) && !py.has(field.sizes, stated)) {
        return py.replace(row, { meanings: [element.meaning, ...(row.meanings ?? [])] });
      }
      size = py.isWhole(stated) ? (field.sizes.get(stated) ?? 0) : 0;
    }
    return parametersReadAs(device, row, field, element, isRequest, size);
  }
  if (part.part === "subindex" && element.index == null) {
    return row;
  }
  return py.replace(row, { meanings: [...(row.meanings ?? []), element.meaning] });
}

/** The name of the field with the index of the first element that a message carries; empty if it has none. */
export function indexField(outer, part) {
  if (!(outer instanceof Message)) {
    return "";
  }
  for (const field of [...(outer.request.fields ?? []), ...(outer.response.fields ?? [])]) {
    const parameterPart = py.truth(field.value) ? field.value.parameter : null;
    if (parameterPart != null && py.equal([parameterPart.part, parameterPart.number], ["subindex", part.number])) {
      return field.name;
    }
  }
  return "";
}

/** The element of a parameter that has several, else the whole parameter. */
function parametersElement(parameterSet, number, parameter, elementNumber) {
  const hasElements = parameter != null && (parameter.elements != null || parameter.subindices.length > 0);
  if (parameter == null || !hasElements || !py.isWhole(elementNumber)) {
    return new ParametersElement({ parameterSet, number, parameter, index: null, subindex: null });
  }
  return new ParametersElement({
    parameterSet,
    number,
    parameter,
    index: elementNumber,
    subindex: parameter.element(elementNumber),
  });
}

/**
 * The row with its first `size` bytes read as the value of a parameter.
 *
 * No codec refuses a frame for what is wrong with that.
 */
function parametersReadAs(device, row, field, element, isRequest, size) {
  let read;
  const fact = element.fact;
  if (fact == null || element.parameter == null) {
    return py.replace(row, { meanings: [element.meaning, ...(row.meanings ?? [])] });
  }
  const ownValue = isRequest ? fact.value.forWriting() : fact.value;
  const reread = row.reason ? null : readAgain(device, ownValue, field, row.raw, row.number, size);
  if (reread == null) {
    row = py.replace(row, {
      meanings: [element.meaning, ...(row.meanings ?? [])],
      notes: [...(row.notes ?? []), ...(fact.notes ?? [])],
    });
    if (row.reason || !py.truth(field.carriesBytes) || element.parameter.reserved || fact.reserved) {
      return row;
    }
    const stated = fact.value.size;
    if (py.truth(isText(fact.value.encoding)) && size < stated) {
      return row;
    }
    const text = py.format(SENTENCES.SHOULD_BE, { expected: byteCount(stated) });
    return py.replace(row, { verdict: text, reason: "out_of_range" });
  }
  if (isRequest) {
    read = decodeValue(device, ...reread, fact.reserved);
  } else {
    read = decodeAnswer(device, ...reread, fact.reserved, element.parameter.trigger);
  }
  const errata = [...(row.errata ?? []), ...errataAt(device, element.parameter.path)];
  return py.replace(row, {
    fact: fact.path,
    doc: fact.doc || row.doc,
    number: read.number,
    value: read.text,
    meanings: [element.meaning, ...(read.meanings ?? [])],
    verdict: read.verdict,
    reason: read.reason ? "out_of_range" : "",
    source: element.citations || row.source,
    notes: [...(row.notes ?? []), ...(fact.notes ?? []), ...(read.notes ?? [])],
    errata: py.tuple(py.dict([...errata, ...errataOfWords(device, read.facts)].map((key) => [key, null]))),
  });
}
