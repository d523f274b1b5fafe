import { bitsText, extentsIn, fits, placeAround } from "../lists.js";
import { extentsOf } from "../widths.js";
import { decimalQuotient, decimalText, isWhole } from "./numbers.js";
import { SENTENCES } from "./sentences.js";
import { missingText, sameValue, sentence, valueText } from "./texts.js";
import { formOfData, formOfField } from "./device.js";
import { runEach } from "./interpreter.js";
import { decodedRow, exponentApplied, judged, meaningOf, repeatedValue } from "./values.js";
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
    return meaningOf(name, label, sentence(SENTENCES.PERCENTAGE, { percent, references }));
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
    this.beside = new Map();
    const { inner, spans } = this.record;
    Object.assign(this, inner ? extentsIn(inner, data.subarray(start, end)) : { extents: [], fault: null });
    // A scale may be after the value that it applies to, so all bytes are read before any row is written.
    const traced = [...(spans ? this.tracedVarying() : this.traced())];
    this.rows = this.explained(traced);
  }

  explained(traced) {
    const known = new Map(this.asked);
    return traced.flatMap((part) => {
      if (part.traced === undefined) return [part];
      const rows = part.traced.map((row) => this.fieldRow(row, known));
      if (this.values.has(part.name)) known.set(part.name, this.values.get(part.name));
      return rows;
    });
  }

  /** The parts of a record in the order of the wire. */
  *traced() {
    const { inner } = this.record;
    const fields = inner ? inner.sent.map((name) => this.record.named.get(name)) : this.record.fields;
    let at = this.start;
    let numberOfList = 0;
    for (const [number, field] of fields.entries()) {
      if (field.cases) {
        yield this.undecidedRow(field, at);
        return;
      }
      if (inner?.lists.some(({ name }) => name === field.name)) {
        if (numberOfList === this.extents.length) {
          yield this.unknownListRow(fields.slice(number), inner.lists[numberOfList], at);
          return;
        }
        const extent = this.extents[numberOfList++];
        yield* this.tracedList(field, extent, at);
        at += extent.size;
        continue;
      }
      const count = this.countOf(field);
      const room = field.size ? Math.max(0, Math.min(count, Math.floor((this.end - at) / field.size))) : 0;
      yield this.tracedField(field, at, new Array(room).fill(field.size));
      at += room * field.size;
      if (room < count) {
        yield this.missingRow(fields.slice(number), at);
        return;
      }
    }
    if (at < this.end) yield surplusRow(this.spot, at, this.data.subarray(at, this.end));
  }

  /** The parts of a list that has other fields after it. */
  *tracedList(field, { size, elements }, start) {
    const [stop, count] = [start + size, this.itemsOf(field)];
    yield this.tracedField(formOfField(this.record, field, this.values), start, elements.length ? elements : new Array(count).fill(field.size));
    const end = elements.length || field.packing ? stop : start + count * field.size;
    if (field.repeat && count < field.repeat[0]) yield this.missingRow([field], end, stop);
    else if (end < stop) yield surplusRow(this.spot, end, this.data.subarray(end, stop));
  }

  /** The row from a list on whose bytes nobody knows. */
  unknownListRow(fields, list, at) {
    const [{ name }] = fields;
    const { decision, packing, parts, presence, countName, more } = list;
    let { reason } = this.fault;
    let text;
    if (this.hasWrongCount(list)) {
      text = sentence(SENTENCES.WRONG_COUNT, { count: countName, name });
    } else if (decision && reason === "unknown_value") {
      text = this.undecidedText(SENTENCES.UNDECIDED, decision.name, name);
    } else if ((decision || more) && reason === "wrong_length") {
      text = sentence(SENTENCES.MORE_FOLLOW, { name, count: this.fault.at - (at - this.start) });
    } else if (parts && !parts.lists.length && reason === "wrong_measure") {
      text = sentence(SENTENCES.MORE_ELEMENTS, { name, count: list.most / list.element });
    } else if (packing && reason === "wrong_length") {
      text = sentence(SENTENCES.MORE_THAN_BITS, { name, bits: packing.bits });
    } else if (parts) {
      text = sentence(SENTENCES.ELEMENTS_WITHOUT_END, { name, place: this.spot.byteText(this.start + this.fault.at) });
    } else if (this.end - this.start < this.record.least) {
      return this.missingRow(fields, at);
    } else if (decision) {
      text = sentence(SENTENCES.DECIDES_MORE, { selector: decision.name, name });
    } else if (presence?.numbers) {
      [reason, text] = ["incomplete", sentence(SENTENCES.SENT_WITHOUT_BYTES, { count: countName, name })];
    } else {
      [reason, text] = ["incomplete", sentence(SENTENCES.COUNTS_MORE, { count: countName, name })];
    }
    return this.wrongRow(fields[0], at, reason, text);
  }

  /** How many elements of a list of a record with fields after a list there are. */
  itemsOf(field) {
    const number = this.record.inner.lists.findIndex(({ name }) => name === field.name);
    const { size, elements, numbers } = this.extents[number];
    if (numbers !== undefined) return numbers;
    return elements.length || this.record.inner.lists[number].parts ? elements.length : Math.min(Math.floor(size / field.size), field.repeat[1]);
  }

  /** Whether the first list whose bytes nobody knows has a count that cannot be right. */
  hasWrongCount(list) {
    if (!list.length || this.fault?.reason !== "wrong_measure") return false;
    return this.fault.at === placeAround(this.record.inner, this.extents, list.at);
  }

  /** The parts of a record whose values vary in width. */
  *tracedVarying() {
    const { fields, spans } = this.record;
    const extents = extentsOf(spans, this.data.subarray(this.start, this.end));
    let at = this.start;
    for (const [number, { start, stop }] of extents.entries()) {
      const field = fields[number];
      const sizes = field.span ? [stop - start] : new Array(field.count ?? 0).fill(field.size);
      yield this.tracedField(field, this.start + start, sizes);
      at = this.start + stop;
    }
    const missing = fields[extents.length];
    if (missing) yield this.wrongRow(missing, at, ...this.endless(spans[extents.length], at));
    else if (at < this.end) yield surplusRow(this.spot, at, this.data.subarray(at, this.end));
  }

  /** Why nobody knows where a field ends that begins at a byte, as a reason and in words. */
  endless(span, at) {
    if (span.count === undefined) return ["incomplete", sentence(SENTENCES.WITHOUT_END, span)];
    const { name } = this.record.spans[span.count];
    const count = Number(this.values.get(name)) - span.plus;
    if (count >= 0 && count <= span.most) {
      return ["incomplete", sentence(SENTENCES.FEWER_FOLLOW, { name: span.name, count, rest: this.end - at })];
    }
    return ["wrong_measure", sentence(SENTENCES.WRONG_SIZE, { count: name, name: span.name })];
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
    return this.wrongRow(fields[0], at, "incomplete", missingText(missing, later), stop);
  }

  /** The row of a field whose type is open, because the field that decides it has a value without a case. */
  undecidedRow(field, at) {
    const size = this.end - this.start;
    const { least, most, selector } = this.record;
    if (size < least) return this.missingRow(this.record.fields.slice(-1), at);
    const isLong = most !== undefined && size > most;
    const fault = isLong ? SENTENCES.UNDECIDED_TOO_LONG : SENTENCES.UNDECIDED;
    const text = this.undecidedText(fault, selector, field.name, { count: size - most });
    return this.wrongRow(field, at, isLong ? "wrong_length" : "unknown_value", text);
  }

  /** That a field whose value has no case does not decide the type of another one. */
  undecidedText(fault, selector, name, more) {
    return sentence(fault, { selector, number: valueText(this.values.get(selector)), name, ...more });
  }

  /** The row of the rest of the body, or of the bytes up to `stop`, where a field is expected. */
  wrongRow(field, at, reason, text, stop = this.end) {
    const row = wrongRow(this.spot, at, this.data.subarray(at, stop), reason, text, field.name, field.path);
    return { ...row, errata: this.device.errataAt(field.path) };
  }

  /** What the elements of one field gave, which have some sizes. Adds their values to `values`. */
  tracedField(field, start, sizes) {
    const traced = [];
    const values = runEach(this.device, field, this.data, start, sizes, "", traced, this.beside);
    if (field.isList) this.values.set(field.name, values);
    else if (values.length) this.values.set(field.name, values[0]);
    return { name: field.name, traced };
  }

  /** The row of what some bytes gave; `known` are the values of the fields before it, and those of the request. */
  fieldRow(traced, known) {
    const { field, path, index, offset, raw, number, beside } = traced;
    const exponent = beside.get(field.exponent);
    const value = exponent ? exponentApplied(field.value, exponent.field.value, exponent.number) : field.value;
    let read = decodedRow(this.device, value, traced);
    if (beside === this.beside) read = this.deciding(field, this.measured(field, this.repeated(field, read)));
    let row = factRow(this.device, "field", path, field, this.spot, offset, raw, read, this.outer);
    row = withParameter(this.device, row, field, index, known, this.outer, this.isRequest);
    return withPercentages(this.device, row, field, number);
  }

  /** The value of a field that measures another one, judged by the size of that field. */
  measured(field, read) {
    const [of, name, plus = 0] = field.measures ?? [];
    const other = this.record.named.get(field.bitsOf ?? name);
    if (!other || other.cases) return read;
    const { inner, spans } = this.record;
    const text = spans?.find((span) => span.name === name && span.count !== undefined);
    const list = inner?.lists.findIndex((own) => own.name === name) ?? -1;
    const room = this.end - this.start - other.offset;
    const numberOf = (items) => (of === "bytes" ? items * other.size : items) + plus;
    let [low, high] = [0, 0];
    if (field.bitsOf) {
      high = 8 * Math.max(0, Math.min(this.countOf(other), room));
      low = Math.max(0, high - 7);
    } else if (text) {
      [low, high] = [plus, text.most + plus];
    } else if (list >= 0) {
      if (list >= this.extents.length) return this.wrongCount(inner.lists[list], field, read);
      low = high = countsSent(inner.lists[list], field) ? this.extents[list].size + plus : numberOf(this.itemsOf(other));
    } else {
      const most = spans ? this.countOf(other) : this.itemsAtEnd(other);
      low = high = numberOf(other.isList ? most : 1);
    }
    return judged(read, isWhole(read.number) && low <= read.number && read.number <= high, low === high ? low : sentence(SENTENCES.BOUNDS, { low, high }), "wrong_measure");
  }

  /** How many elements of a list that ends the body there are. */
  itemsAtEnd(field) {
    return Math.max(0, Math.min(this.countOf(field), Math.floor((this.end - this.start - field.offset) / field.size)));
  }

  /** The value of a field whose bits say how many elements others have, judged by how many they have. */
  deciding(field, read) {
    for (const other of this.record.fields) {
      const { presence, name } = other;
      if ((read.reason && read.reason !== "out_of_range") || presence?.by !== field.name || !isWhole(read.number)) continue;
      const known = this.record.inner?.lists.findIndex((list) => list.name === name) ?? -1;
      if (known === this.extents.length) read = this.wrongCount(this.record.inner.lists[known], field, read);
      if (known >= this.extents.length) continue;
      const items = this.record.inner ? this.itemsOf(other) : this.itemsAtEnd(other);
      if (!fits(presence, read.number, items)) {
        const isSent = sentence(items ? SENTENCES.NUMBER_IF_SENT : SENTENCES.NUMBER_IF_ABSENT, other);
        const count = bitsText(presence, items * presence.unit + presence.plus);
        return judged(read, false, presence.numbers ? isSent : count, "wrong_measure");
      }
    }
    return read;
  }

  /** The value of a field, which is wrong if the bytes of the list are not known because of its number. */
  wrongCount(list, field, read) {
    const { countName, least, most, unit, plus = 0, presence, sentPlus } = list;
    if (countName !== field.name || !this.hasWrongCount(list)) return read;
    const [low, high] = [least, most].map((size) => Math.floor(size / unit) + plus);
    const bounds = sentence(SENTENCES.BOUNDS, { low, high });
    const expected = sentPlus === undefined ? bounds : sentence(SENTENCES.SIZE_OF_LIST, list);
    return judged(read, false, presence ? bitsText(presence, expected) : expected, "wrong_measure");
  }

  /** The value of a field that repeats one of the request, judged by the value there. */
  repeated(field, read) {
    const should = field.sameAs ? this.asked.get(field.sameAs) : undefined;
    return read.reason || should === undefined ? read : repeatedValue(read, should, field.value.kind === "float" ? field.value.size : 0);
  }
}

/** Whether a field counts the sent bytes of a list. */
function countsSent({ sentPlus, countName }, field) {
  return sentPlus !== undefined && countName === field.name;
}
