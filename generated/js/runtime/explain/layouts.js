import { bitsText, extentsIn, fits, placeAround } from "../lists.js";
import { extentsOf } from "../widths.js";
import { py } from "./python.js";
import { inOrder, unsignedOf } from "./interpreter.js";
import { bytesOfHex, latinOf } from "./texts.js";
import { forWriting } from "./values.js";

// The layouts of a device by the names that the modules of `codec/explain` have for them. A layout is also the fact
// that it is of: `link.link` is the link.

export const [BIT, BYTE, WORD] = ["bit", "byte", "word"];

/** What decides whether a field is sent; `numbers` are true where bits of a number do, and do not count elements. */
const presenceLayout = (presence) => ({
  unit: 1,
  plus: 0,
  ...presence,
  numbers: Boolean(presence.numbers),
  fits: (number, items) => fits(presence, number, items),
  bitsText: (content) => bitsText(presence, content),
});

/** A field; `field` has what its spec states. */
function fieldLayout(field, inner) {
  const { repeat, measures, presence, count, valueBytes = [] } = field;
  const [set, part, number] = field.value?.parameter ?? [];
  const parameter = set && { set, part, number, sizes: valueBytes[2] ? { by: valueBytes[2] } : null };
  const [low, high] = repeat ?? [count || 1, count || 1];
  const [kind, name, plus = 0] = measures ?? [];
  const measure = { of: kind, field: name, plus, number: (items, size) => (kind === "bytes" ? items * size : items) + plus };
  return {
    ...field,
    field: { ...field, repeat: repeat ? { low, high } : null, measures: measures ? measure : null },
    value: field.value && { ...field.value, parameter },
    sizes: py.dict(valueBytes[3] ?? []),
    carriesBytes: valueBytes.length > 0,
    bounds: [low, high],
    end: count === undefined ? undefined : field.offset + field.size * count,
    splitsRecord: field.cases,
    varies: Boolean(inner?.lists.some((list) => list.name === field.name)),
    countsSent: Boolean(inner?.lists.some((list) => list.sentPlus !== undefined && list.countName === field.name)),
    presence: presence && presenceLayout(presence),
  };
}

/** The lists of a record that has fields after them. */
class InnerLists {
  constructor(data) {
    this.data = data;
    this.lists = data.lists.map((list) => ({
      ...list,
      count: list.countName,
      countAt: list.at,
      plus: list.plus ?? 0,
      continuation: list.more,
      packing: list.packing && { number: list.packing },
      presence: list.presence && presenceLayout(list.presence),
    }));
  }

  extentsIn(data) {
    const { extents, fault } = extentsIn(this.data, data);
    return [extents, fault];
  }

  placeInData(extents, offset) {
    return placeAround(this.data, extents, offset);
  }
}

/** The fields of a record. */
export class RecordLayout {
  constructor(data) {
    Object.assign(this, { ...data, record: this });
    this.fields = data.fields.map((own, number) => {
      const field = fieldLayout(own, data.inner);
      const span = data.spans?.[number];
      if (own.forms) field.forms = new Map(own.forms.flatMap(([numbers, form]) => numbers.map((number) => [BigInt(number), fieldLayout(form, data.inner)])));
      return span?.most === undefined ? field : { ...field, span };
    });
    this.byName = new Map(this.fields.map((field) => [field.name, field]));
    this.selector = this.byName.get(data.selector) ?? null;
    this.innerLists = data.inner ? new InnerLists(data.inner) : null;
    this.sentFields = data.inner ? data.inner.sent.map((name) => this.byName.get(name)) : this.fields;
    this.spans = data.spans?.map((span) => ({ plus: 0, ...span, value: span.most === undefined ? null : { width: span.most } })) ?? [];
    this.forms = new Map();
    for (const [numbers, form] of data.chosen ?? []) {
      const inner = new RecordLayout(form);
      for (const number of numbers) this.forms.set(BigInt(number), inner);
    }
  }

  named(name) {
    return this.byName.get(name);
  }

  /** The record for some data: itself, or what its selector decides; undefined where that decides none. */
  ofData(data) {
    if (!this.selector) return this;
    const { offset, size, value } = this.selector;
    if (data.length < offset + size) return undefined;
    return this.forms.get(unsignedOf(inOrder(value, data.subarray(offset, offset + size)), "big"));
  }

  decidedBy(values) {
    return { named: (name) => formOfField(this, this.byName.get(name), values) };
  }
}

/** A field as the raw values of its record decide it; undefined where they decide nothing. */
export function formOfField(record, field, values) {
  if (!field.forms) return field;
  const number = values.get(field.by) ?? record.byName.get(field.by).value.const;
  return number === undefined ? undefined : formOfNumber(field, number);
}

/** The form of a field that a number, or some bits of it, decides; undefined if it decides none. */
export function formOfNumber({ forms, mask }, number) {
  return forms.get(mask === undefined ? BigInt(number) : BigInt(number) & BigInt(mask));
}

const spaced = (access) => ({ ...access, space: access.space ?? "" });

/** A message, and the data of its request and of its response. */
export class Message {
  constructor(data) {
    Object.assign(this, { ...data, message: this, isRequested: !data.unrequested, hasResponseCode: data.responseCode !== undefined });
    [this.request, this.response] = [new RecordLayout(data.request), new RecordLayout(data.response)];
    this.singleAccess = data.access && spaced(data.access);
    this.accesses = (data.steps ?? (data.access ? [data.access] : [])).map(spaced);
  }

  data(direction) {
    return this[direction];
  }

  codeOf(direction) {
    return direction === "response" ? this.responseCode ?? this.code : this.code;
  }
}

/** A value of a device, which knows the places of its bytes. */
function placedValue(value) {
  let written;
  return { ...value, forWriting: () => (written ??= forWriting(value)), writeSwapped: (isSwapped) => isSwapped };
}

/** Registers that are alike. */
export class RegisterLayout {
  constructor(data) {
    Object.assign(this, { space: "", access: "", elementSources: [], swapped: false, ...data, register: this, indexFrom: data.first });
    this.value = placedValue(data.value);
  }
}

/** A table of records in registers; its record has the fields with their places. */
export class Table {
  constructor(data, records) {
    Object.assign(this, { space: "", countBy: "", baseBy: "", ...data, table: this, indexFrom: data.first });
    this.record = data.fields.map(({ path, record, field, offset, words, access = "", atomic = false, exponent }) => {
      const fieldNamed = (name) => {
        const own = records.get(record).named(name);
        return { ...own, field: { ...own.field, atomic }, value: placedValue(own.value), swapped: false };
      };
      const beside = () => exponent && { path, field: fieldNamed(exponent[1]), offset: exponent[0], words: 0, access: () => access };
      return { path, field: fieldNamed(field), offset, words, access: () => access, beside };
    });
  }
}

export const nestedFields = (record) => record;

/** The registers with the addresses of the first elements of tables, by the names of these. */
export function movingTables({ tables, registers }) {
  const moving = tables.values().filter(({ baseBy }) => baseBy);
  return py.dict(moving.map(({ name, baseBy }) => [name, registers.find((register) => register.name === baseBy)]));
}

/** What is computed once for an object. */
export class ByIdentity {
  constructor() {
    this.results = new WeakMap();
  }

  getOrCompute(key, compute) {
    if (!this.results.has(key)) this.results.set(key, compute(key));
    return this.results.get(key);
  }
}

export const extents = extentsOf;
export const packedSize = (count) => Math.ceil(Number(count) / 8);

export const citations = (source) => (Array.isArray(source) ? source.join("; ") : source ?? "");

export const hasWordDigits = ({ value }) => Boolean(value?.digits);

/** The bytes of words that are sent as hexadecimal digits, up to the first word with other characters. */
export function wordBytes(field, digits) {
  if (!hasWordDigits(field)) return digits;
  const letters = field.value.digits === "upper_hex" ? /^[0-9A-F]*/ : /^[0-9a-f]*/;
  const { length } = letters.exec(latinOf(digits))[0];
  return bytesOfHex(latinOf(digits.subarray(0, length - length % field.size)));
}

export const unpackedBits = (bytes) => [...bytes].flatMap((byte) => Array.from({ length: 8 }, (_, bit) => (byte >> bit) & 1));

export const optionText = (name) => name.replaceAll("_", "-");
