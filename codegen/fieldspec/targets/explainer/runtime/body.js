import { extentsIn, placeAround } from "../lists.js";
import { extentsOf, widenedBytes } from "../widths.js";
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
    const percent = decimalText(decimalQuotient(100n * count, BigInt(full), 200), `100/${full}`);
    return meaningOf(name, label, `${percent} % of ${references}`);
  });
  return meanings.length ? { ...row, meanings: [...row.meanings, ...meanings] } : row;
}

/** The fields of a record with fields behind a list, in the order of the wire. */
function sentFields({ fields, inner, named }) {
  const others = fields.filter(({ repeat }) => !repeat);
  const sent = [];
  for (const { name, first } of inner.lists) {
    while (others.length && others[0].offset < first) sent.push(others.shift());
    sent.push(named.get(name));
  }
  return [...sent, ...others];
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
    const { inner } = this.record;
    Object.assign(this, inner ? extentsIn(inner, data.subarray(start, end)) : { extents: [], fault: null });
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
    const sent = sentFields(this.record);
    let at = this.start;
    let numberOfList = 0;
    for (const [number, field] of sent.entries()) {
      if (!field.repeat) {
        const room = Math.max(0, Math.min(field.count, Math.floor((this.end - at) / field.size)));
        this.explainField(field, at, room);
        at += room * field.size;
        if (room < field.count) {
          this.rows.push(this.missingRow(sent.slice(number), at));
          return;
        }
        continue;
      }
      if (numberOfList === this.extents.length) {
        this.rows.push(this.unknownListRow(sent.slice(number), this.record.inner.lists[numberOfList], at));
        return;
      }
      const { size, elements } = this.extents[numberOfList++];
      const stop = at + size;
      const count = this.itemsOf(field);
      this.explainField(field, at, count, elements);
      at = elements.length ? stop : at + count * field.size;
      if (count < field.repeat[0]) this.rows.push(this.missingRow([field], at, stop));
      else if (at < stop) this.rows.push(surplusRow(this.spot, at, this.data.subarray(at, stop)));
      at = stop;
    }
  }

  /** The row from a list on whose bytes nobody knows. */
  unknownListRow(fields, list, at) {
    const [{ name }] = fields;
    if (this.hasWrongCount(list)) {
      const text = `${list.countName} is no number of ${name}, so nobody knows where they end`;
      return this.wrongRow(fields[0], at, "wrong_measure", text);
    }
    if (list.tail) {
      const text = `the elements of ${name} do not end with their bytes: see ${this.spot.byteText(this.start + this.fault.at)}`;
      return this.wrongRow(fields[0], at, this.fault.reason, text);
    }
    if (this.end - this.start < this.record.least) return this.missingRow(fields, at);
    return this.wrongRow(fields[0], at, "incomplete", `${list.countName} counts more ${name} than there are`);
  }

  /** How many elements of a list of a record with fields behind a list there are. */
  itemsOf(field) {
    const number = this.record.inner.lists.findIndex(({ name }) => name === field.name);
    const { size, elements } = this.extents[number];
    return this.record.inner.lists[number].tail ? elements.length : Math.min(Math.floor(size / field.size), field.repeat[1]);
  }

  /** Whether the first list whose bytes nobody knows has a count that cannot be right. */
  hasWrongCount(list) {
    if (!list.length || this.fault?.reason !== "wrong_measure") return false;
    return this.fault.at === placeAround(this.record.inner, this.extents, list.at);
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
    if (missing) this.rows.push(this.wrongRow(missing, at, ...this.endless(spans[extents.length], at)));
    else if (at < this.end) this.rows.push(surplusRow(this.spot, at, this.data.subarray(at, this.end)));
  }

  /** Why nobody knows where a field ends that begins at a byte, as a reason and in words. */
  endless(span, at) {
    if (span.count === undefined) return ["incomplete", `${span.name} has no end`];
    const { name } = this.record.spans[span.count];
    const number = Number(this.values.get(name)) - span.plus;
    if (number >= 0 && number <= span.most) {
      return ["incomplete", `${span.name} has ${number} bytes, but only ${this.end - at} follow`];
    }
    return ["wrong_measure", `${name} is no number of bytes of ${span.name}`];
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

  /** Adds the rows of the elements of a field; `sizes` are those that differ. */
  explainField(field, at, count, sizes = []) {
    const values = [];
    let place = at;
    for (let index = 0; index < count; index++) {
      const path = field.isList ? `${field.name}[${index}]` : field.name;
      const size = sizes[index] ?? field.size;
      values.push(this.explainElement(field, path, place, index, size));
      place += size;
    }
    if (field.isList) this.values.set(field.name, values);
    else if (values.length) this.values.set(field.name, values[0]);
  }

  explainElement(field, path, at, index, size) {
    if (field.record) return this.explainRecord(this.device.records.get(field.record), path, at, size);
    return this.explainValue(field, this.byExponent(field, this.record, this.start), path, at, index, true);
  }

  /** Adds the rows of a record within the body, of which all bytes are there. */
  explainRecord(record, path, at, size) {
    const values = new Map();
    for (const [number, field] of record.fields.entries()) {
      const span = record.spans?.[number];
      if (span?.most !== undefined) {
        const raw = this.data.subarray(at + field.offset, at + size);
        const varying = { raw, image: widenedBytes(span, raw), form: span.formText };
        values.set(field.name, this.explainValue(field, field.value, `${path}.${field.name}`, at + field.offset, 0, false, varying));
        continue;
      }
      const elements = [];
      const count = field.count ?? Math.floor((size - field.offset) / field.size);
      for (let index = 0; index < count; index++) {
        const inner = `${path}.${field.name}${field.isList ? `[${index}]` : ""}`;
        const place = at + field.offset + index * field.size;
        elements.push(field.record
          ? this.explainRecord(this.device.records.get(field.record), inner, place, field.size)
          : this.explainValue(field, this.byExponent(field, record, at), inner, place, index, false));
      }
      values.set(field.name, field.isList ? elements : elements[0]);
    }
    return values;
  }

  /** The value of a field of a record, with its scale where another field beside it has the exponent. */
  byExponent({ value }, record, start) {
    const exponent = value.scaleBy && !record.spans && record.named.get(value.scaleBy);
    const { inner } = record;
    const place = exponent?.offset ?? 0;
    if (inner && this.fault && place >= inner.lists[this.extents.length].first) return value;
    const at = start + (inner ? placeAround(inner, this.extents, place) : place);
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
    if (field.bitsOf) return this.bitCount(field, read);
    const [of, name, plus = 0] = field.measures ?? [];
    const other = this.record.named.get(name);
    if (!other || other.cases) return read;
    const text = this.record.spans?.find((span) => span.name === name && span.count !== undefined);
    if (text) {
      const isRight = read.number >= plus && read.number <= text.most + plus;
      return judged(read, isRight, isRight ? read.number : `${plus} to ${text.most + plus}`, "wrong_measure");
    }
    if (this.record.inner && other.repeat) return this.measuredList(field, other, read);
    const room = Math.floor((this.end - this.start - other.offset) / other.size);
    const most = this.record.spans ? this.countOf(other) : Math.max(0, Math.min(this.countOf(other), room));
    const items = other.isList ? most : 1;
    const should = (of === "bytes" ? items * other.size : items) + plus;
    return judged(read, sameValue(read.number, should), should, "wrong_measure");
  }

  /** The number of bits in a list of bytes, judged by how many there are. */
  bitCount(field, read) {
    const packed = this.record.named.get(field.bitsOf);
    const size = Math.max(0, Math.min(this.countOf(packed), this.end - this.start - packed.offset));
    const should = size ? `${8 * size - 7} to ${8 * size}` : 0;
    return judged(read, Math.ceil(Number(read.number) / 8) === size, should, "wrong_measure");
  }

  /** The value of a field that measures a list of a record with fields behind a list. */
  measuredList(field, other, read) {
    const number = this.record.inner.lists.findIndex(({ name }) => name === other.name);
    if (number < this.extents.length) {
      const [of, , plus = 0] = field.measures;
      const should = this.itemsOf(other) * (of === "bytes" ? other.size : 1) + plus;
      return judged(read, sameValue(read.number, should), should, "wrong_measure");
    }
    const list = this.record.inner.lists[number];
    const { countName, least, most, unit, plus = 0 } = list;
    if (number !== this.extents.length || countName !== field.name || !this.hasWrongCount(list)) return read;
    return judged(read, false, `${Math.floor(least / unit) + plus} to ${Math.floor(most / unit) + plus}`, "wrong_measure");
  }

  /** The value of a field that repeats one of the request, judged by the value there. */
  repeated(field, read) {
    const should = field.sameAs ? this.asked.get(field.sameAs) : undefined;
    return read.reason || should === undefined ? read : repeatedValue(read, should, field.value.kind === "float" ? field.value.size : 0);
  }
}
