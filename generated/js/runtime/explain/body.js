import { placeAround } from "../lists.js";
import { extentsOf } from "../widths.js";
import { decimalQuotient, decimalText, isWhole } from "./numbers.js";
import { sameValue, valueText } from "./texts.js";
import { formOfData } from "./device.js";
import { decodeValue, decoded, exponentApplied, judged, meaningOf, repeatedValue } from "./values.js";
import { factRow, surplusRow, wrongRow } from "./rows.js";
import { withParameter } from "./parameters.js";

/** The row of a field that carries a signal, with the percentages that its conversions give. */
function withPercentages(device, row, field, number) {
  if (!field.signal || field.value.kind === "float" || !isWhole(number)) return row;
  const conversions = device.data.conversions.filter(({ signals }) => signals.includes(field.signal));
  const meanings = conversions.map((conversion) => {
    const { name, label, complement, full, references } = conversion;
    const count = complement ? BigInt(full) - BigInt(number) : BigInt(number);
    const percent = decimalText(decimalQuotient(100n * count, BigInt(full), 200));
    return meaningOf(name, label, `${percent} % of ${references}`);
  });
  return meanings.length ? { ...row, meanings: [...row.meanings, ...meanings] } : row;
}

/**
 * The body of a frame: the bytes of `data` from `start` to `end`, which `record` describes. `rows` and `values` go as
 * far as the bytes do. `asked` are the values of the request that the frame answers. `outer` is the message or the
 * record; its sources stand in for fields without their own.
 */
export class ExplainedBody {
  constructor(device, record, outer, isRequest, data, start, end, spot, asked) {
    Object.assign(this, { device, outer, isRequest, data, start, end, spot, asked });
    this.record = formOfData(record, data.subarray(start, end)) ?? record;
    this.values = new Map();
    this.rows = [];
    this.explainFields();
  }

  explainFields() {
    let at = this.start;
    if (this.record.spans) {
      this.explainVarying();
      return;
    }
    if (this.record.inner) {
      this.explainAround();
      return;
    }
    for (const [number, field] of this.record.fields.entries()) {
      if (field.cases) {
        this.rows.push(this.undecidedRow(field, at));
        return;
      }
      const count = this.countOf(field);
      const room = field.size ? Math.max(0, Math.min(count, Math.floor((this.end - at) / field.size))) : 0;
      this.explainField(field, at, room);
      at += room * field.size;
      if (room < count) {
        this.rows.push(this.missingRow(this.record.fields.slice(number), at));
        return;
      }
    }
    if (at < this.end) this.rows.push(surplusRow(this.spot, at, this.data.subarray(at, this.end)));
  }

  /** Adds the rows of a record with fields behind a list, in the order of the wire. */
  explainAround() {
    const { fields, inner } = this.record;
    const list = fields.at(-1);
    const before = fields.slice(0, -1).filter(({ offset }) => offset < inner.first);
    const sent = [...before, list, ...fields.slice(before.length, -1)];
    const isWhole = this.end - this.start >= inner.first + inner.behind;
    let at = this.start;
    for (const [number, field] of sent.entries()) {
      const isInner = field === list;
      const count = this.countOf(field);
      const stop = isInner && isWhole ? this.end - inner.behind : this.end;
      const room = isInner && !isWhole ? 0 : Math.max(0, Math.min(count, Math.floor((stop - at) / field.size)));
      this.explainField(field, at, room);
      at += room * field.size;
      if (room < count || (isInner && !isWhole)) {
        this.rows.push(this.missingRow(isWhole ? [field] : sent.slice(number), at, stop));
        if (!isWhole) return;
      } else if (isInner && at < stop) this.rows.push(surplusRow(this.spot, at, this.data.subarray(at, stop)));
      if (isInner) at = stop;
    }
  }

  /** Adds the rows of a record whose values vary in width. */
  explainVarying() {
    const { fields, spans } = this.record;
    const extents = extentsOf(spans, this.data.subarray(this.start, this.end));
    let at = this.start;
    for (const [number, { start, stop, image }] of extents.entries()) {
      const field = fields[number];
      at = this.start + start;
      if (spans[number].most === undefined) this.explainField(field, at, field.count ?? 0);
      else {
        const varying = { raw: this.data.subarray(at, this.start + stop), image, form: spans[number].formText };
        this.values.set(field.name, this.explainValue(field, field.value, field.name, at, 0, true, varying));
      }
      at = this.start + stop;
    }
    const missing = fields[extents.length];
    if (missing) this.rows.push(this.wrongRow(missing, at, "incomplete", `${missing.name} has no end`));
    else if (at < this.end) this.rows.push(surplusRow(this.spot, at, this.data.subarray(at, this.end)));
  }

  /** How many elements a field should have: as many as fit if their number is free. */
  countOf(field) {
    if (!field.repeat) return field.count ?? 0;
    const [low, high] = field.repeat;
    return Math.min(Math.max(Math.floor((this.end - this.start - field.offset) / field.size), low), high);
  }

  /** The row of the place where the body, or the bytes up to `stop`, are not enough for fields. */
  missingRow(fields, at, stop = this.end) {
    const missing = this.record.least - (this.end - this.start);
    const later = fields.map(({ name }) => name).join(", ");
    const text = `${missing} ${missing === 1 ? "byte is" : "bytes are"} missing for ${later}`;
    return this.wrongRow(fields[0], at, "incomplete", text, stop);
  }

  /** The row of a field whose type is open, because the field that decides it has a value without a case. */
  undecidedRow(field, at) {
    const size = this.end - this.start;
    const { least, most, selector } = this.record;
    if (size < least) return this.missingRow(this.record.fields.slice(-1), at);
    const text = `${selector} ${valueText(this.values.get(selector))} does not decide the type of ${field.name}`;
    if (most === undefined || size <= most) return this.wrongRow(field, at, "unknown_value", text);
    return this.wrongRow(field, at, "wrong_length", `${text}, which is ${size - most} bytes too long`);
  }

  /** The row of the rest of the body, or of the bytes up to `stop`, where a field is expected. */
  wrongRow(field, at, reason, text, stop = this.end) {
    const row = wrongRow(this.spot, at, this.data.subarray(at, stop), reason, text, field.name, field.path);
    return { ...row, errata: this.device.errataAt(field.path) };
  }

  explainField(field, at, count) {
    const values = [];
    for (let index = 0; index < count; index++) {
      const path = field.isList ? `${field.name}[${index}]` : field.name;
      values.push(this.explainElement(field, path, at + index * field.size, index));
    }
    if (field.isList) this.values.set(field.name, values);
    else if (values.length) this.values.set(field.name, values[0]);
  }

  explainElement(field, path, at, index) {
    if (field.record) return this.explainRecord(this.device.records.get(field.record), path, at);
    return this.explainValue(field, this.byExponent(field, this.record, this.start), path, at, index, true);
  }

  /** Adds the rows of a record within the body, of which all bytes are there. */
  explainRecord(record, path, at) {
    const values = new Map();
    for (const field of record.fields) {
      const elements = [];
      for (let index = 0; index < (field.count ?? 0); index++) {
        const inner = `${path}.${field.name}${field.isList ? `[${index}]` : ""}`;
        const place = at + field.offset + index * field.size;
        elements.push(field.record
          ? this.explainRecord(this.device.records.get(field.record), inner, place)
          : this.explainValue(field, this.byExponent(field, record, at), inner, place, index, false));
      }
      values.set(field.name, field.isList ? elements : elements[0]);
    }
    return values;
  }

  /** The value of a field of a record, with its scale where another field beside it has the exponent. */
  byExponent({ value }, record, start) {
    const exponent = value.scaleBy && !record.spans && record.named.get(value.scaleBy);
    const place = exponent?.offset ?? 0;
    const at = start + (record.inner ? placeAround(record.inner, this.end - this.start, place) : place);
    if (!exponent || at + exponent.size > this.end) return value;
    return exponentApplied(value, exponent.value, this.data.subarray(at, at + exponent.size));
  }

  /**
   * Adds the row of a field, whose `value` has its scale. Of one that varies in width, `varying` has the bytes, those in
   * the image, and its form.
   */
  explainValue(field, value, path, at, index, isTop, varying) {
    const raw = varying?.raw ?? this.data.subarray(at, at + field.size);
    const image = varying ? varying.image : raw;
    let read = image === null
      ? judged(decoded(raw), false, varying.form, "unknown_value")
      : decodeValue(this.device, value, image, value.order ?? "big", value.swapped, field.reserved);
    const { number } = read;
    if (isTop) read = this.measured(field, this.repeated(field, read));
    const known = (name) => (this.values.has(name) ? this.values.get(name) : this.asked.get(name));
    let row = factRow(this.device, "field", path, field, this.spot, at, raw, read, this.outer);
    row = withParameter(this.device, row, field, index, known, this.outer, this.isRequest);
    this.rows.push(withPercentages(this.device, row, field, number));
    return number;
  }

  /** The value of a field that measures another one, judged by the size of that field. */
  measured(field, read) {
    const [of, name] = field.measures ?? [];
    const other = this.record.named.get(name);
    if (!other || other.cases) return read;
    const room = Math.floor((this.end - this.start - other.offset) / other.size);
    const most = this.record.spans ? this.countOf(other) : Math.max(0, Math.min(this.countOf(other), room));
    const items = other.isList ? most : 1;
    const should = of === "bytes" ? items * other.size : items;
    return judged(read, sameValue(read.number, should), should, "wrong_measure");
  }

  /** The value of a field that repeats one of the request, judged by the value there. */
  repeated(field, read) {
    const should = field.sameAs ? this.asked.get(field.sameAs) : undefined;
    return read.reason || should === undefined ? read : repeatedValue(read, should, field.value.kind === "float" ? field.value.size : 0);
  }
}
