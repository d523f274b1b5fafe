import { ACCEPTED, decodedRow, exponentApplied, repeatedValue } from "./values.js";
import { ExplanationRow, factRow, surplusRow, wrongRow } from "./row.js";
import { Message, extents } from "./layouts.js";
import { Place, fieldProgram, runEach } from "./interpreter.js";
import { SENTENCES } from "./sentences.js";
import { errataAt } from "./device.js";
import { missingText } from "./texts.js";
import { withParameter } from "./parameters.js";
import { withPercentages } from "./percentages.js";
import { py } from "./python.js";

/** The body of a frame, field by field. */

/** The result of reading the bytes of a field. */
class BodyTracedField {
  constructor({ name, rows }) {
    this.name = name;
    this.rows = rows;
  }
}

/**
 * The body of a frame: the bytes of `data` from `start` to `end`, which `record` describes.
 *
 * `rows` and `values` go as far as the bytes do. `request_values` are the values of the request that the frame
 * answers. `outer` is the message or the record; its sources stand in for fields without their own.
 */
export class Body {
  constructor(layout, record, outer, data, start, end, spot, requestValues) {
    [this.layout, this.outer, this.spot, this.asked] = [layout, outer, spot, requestValues];
    [this.data, this.start, this.end] = [data, start, end];
    this.record = py.either(record.ofData(py.slice(data, start, end)), () => record);
    this.isRequest = outer instanceof Message && record.record === outer.request;
    this.values = py.dict([]);
    const inner = this.record.innerLists;
    [this.extents, this.fault] = inner == null ? [[], null] : inner.extentsIn(py.slice(data, start, end));
    this._rowsByName = py.dict([]);
    const traced = py.truth(this.record.spans) ? this._tracedVarying() : this._traced();
    this.rows = py.list(this._explained(py.list(traced)));
  }

  *_explained(traced) {
    const known = py.dict(this.asked);
    for (const part of traced) {
      if (part instanceof ExplanationRow) {
        yield part;
        continue;
      }
      for (const row of part.rows) {
        yield this._row(row, known);
      }
      if (py.has(this.values, part.name)) {
        py.put(known, part.name, py.item(this.values, part.name));
      }
    }
  }

  /** The parts of a record in the order of the wire. */
  *_traced() {
    const [inner, fields] = [this.record.innerLists, this.record.sentFields];
    let [offset, listNumber] = [this.start, 0];
    for (const [number, field] of py.enumerate(fields)) {
      if (py.truth(field.splitsRecord)) {
        yield this._undecided(field, offset);
        return;
      }
      if (inner != null && py.truth(field.varies)) {
        if (py.equal(listNumber, this.extents.length)) {
          yield this._unknownList(py.slice(fields, number), py.item(inner.lists, listNumber), offset);
          return;
        }
        const extent = py.item(this.extents, listNumber);
        listNumber += 1;
        yield* this._list(field, extent, offset);
        offset += extent.size;
        continue;
      }
      const count = this._count(field);
      const room = py.truth(field.size) ? py.max(0, py.min(count, Math.floor((this.end - offset) / field.size))) : 0;
      yield this._field(field, offset, py.repeated([field.size], room));
      offset += room * field.size;
      if (room < count) {
        yield this._missing(py.slice(fields, number), offset);
        return;
      }
    }
    if (offset < this.end) {
      yield surplusRow(this.spot, offset, py.slice(this.data, offset, this.end));
    }
  }

  /** The parts of a list that has other fields after it. */
  *_list(field, extent, offset) {
    const [stop, count] = [offset + extent.size, this._items(field)];
    const sizes = py.either(extent.elements, () => py.repeated([field.size], count));
    const form = this.record.decidedBy(this.values).named(field.name);
    yield this._field(form, offset, sizes);
    const end = field.packing != null ? stop : offset + py.sum(sizes);
    if (field.field.repeat != null && count < field.field.repeat.low) {
      yield this._missing([field], end, stop);
    } else if (end < stop) {
      yield surplusRow(this.spot, end, py.slice(this.data, end, stop));
    }
  }

  /** The row from the first list on whose bytes are not known. */
  _unknownList(fields, inner, offset) {
    let text;
    let [name, reason] = [fields[0].name, this.fault.reason];
    if (this._hasWrongCount(inner)) {
      text = py.format(SENTENCES.WRONG_COUNT, { count: inner.count, name });
    } else if (inner.decision != null && reason === "unknown_value") {
      text = this._undecidedText(inner.decision.name, name);
    } else if ((inner.decision != null || inner.continuation != null) && reason === "wrong_length") {
      text = py.format(SENTENCES.MORE_FOLLOW, { name: inner.name, count: this.fault.at - (offset - this.start) });
    } else if (inner.parts != null && !py.truth(inner.parts.lists) && reason === "wrong_measure") {
      text = py.format(SENTENCES.MORE_ELEMENTS, { name: inner.name, count: Math.floor(inner.most / inner.element) });
    } else if (inner.packing != null && reason === "wrong_length") {
      text = py.format(SENTENCES.MORE_THAN_BITS, { name: inner.name, bits: inner.packing.number.bits });
    } else if (inner.parts != null) {
      const place = this.spot.byteText(this.start + this.fault.at);
      text = py.format(SENTENCES.ELEMENTS_WITHOUT_END, { name, place });
    } else if ((this.end - this.start) < this.record.least) {
      return this._missing(fields, offset);
    } else if (inner.decision != null) {
      text = py.format(SENTENCES.DECIDES_MORE, { selector: inner.decision.name, name });
    } else if (inner.presence != null && py.truth(inner.presence.numbers)) {
      [reason, text] = ["incomplete", py.format(SENTENCES.SENT_WITHOUT_BYTES, { count: inner.count, name })];
    } else {
      [reason, text] = ["incomplete", py.format(SENTENCES.COUNTS_MORE, { count: inner.count, name })];
    }
    return this._wrong(fields[0], offset, reason, text);
  }

  /** Whether the first list whose bytes are not known has an impossible count. */
  _hasWrongCount(inner) {
    const place = py.truth(this.record.innerLists) ? this.record.innerLists.placeInData(this.extents, inner.countAt) : 0;
    const fault = this.fault;
    return py.truth(inner.count) && fault != null && fault.reason === "wrong_measure" && py.equal(fault.at, place);
  }

  /** How many elements of a list of a record with fields after a list there are. */
  _items(field) {
    const inner = this.record.innerLists;
    const number = py.next([...py.enumerate(inner.lists)].filter(([number, innerList]) => innerList.name === field.name).map(([number, innerList]) => number));
    const extent = py.item(this.extents, number);
    if (py.item(inner.lists, number).packing != null) {
      return extent.numbers;
    }
    return (py.truth(extent.elements) || py.item(inner.lists, number).parts != null) ? extent.elements.length : py.min(Math.floor(extent.size / field.size), field.bounds[1]);
  }

  /** The parts of a record whose values vary in width. */
  *_tracedVarying() {
    const fields = this.record.fields;
    let offset = this.start;
    const known = extents(this.record.spans, py.slice(this.data, this.start, this.end));
    for (const [field, span, extent] of py.zip(fields, this.record.spans, known)) {
      const sizes = span.value == null ? py.repeated([field.size], py.either(field.count, () => 0)) : [extent.stop - extent.start];
      yield this._field(field, this.start + extent.start, sizes);
      offset = this.start + extent.stop;
    }
    if (known.length < fields.length) {
      const [reason, text] = this._endless(known.length, offset);
      yield this._wrong(py.item(fields, known.length), offset, reason, text);
    } else if (offset < this.end) {
      yield surplusRow(this.spot, offset, py.slice(this.data, offset, this.end));
    }
  }

  /** The reason why the end of a field is not known, as the reason of a codec and in words. */
  _endless(number, offset) {
    const span = py.item(this.record.spans, number);
    if (span.count == null || span.value == null) {
      return ["incomplete", py.format(SENTENCES.WITHOUT_END, { name: span.name })];
    }
    const count = py.item(this.values, py.item(this.record.spans, span.count).name);
    if (py.isWhole(count) && 0 <= (count - span.plus) && (count - span.plus) <= span.value.width) {
      const rest = this.end - offset;
      return ["incomplete", py.format(SENTENCES.FEWER_FOLLOW, { name: span.name, count: count - span.plus, rest })];
    }
    const text = py.format(SENTENCES.WRONG_SIZE, { count: py.item(this.record.spans, span.count).name, name: span.name });
    return ["wrong_measure", text];
  }

  /** The number of elements that the field should have: all that fit if their number is free. */
  _count(field) {
    const repeat = field.field.repeat;
    if (repeat == null) {
      return py.either(field.count, () => 0);
    }
    const room = Math.floor((this.end - this.start - field.offset) / field.size);
    return py.min(py.max(room, repeat.low), repeat.high);
  }

  /** The row of the place where the body, or the bytes up to `stop`, are not enough for fields. */
  _missing(fields, offset, stop = null) {
    const missing = this.record.least - (this.end - this.start);
    const later = py.join(", ", [...fields].map((other) => other.name));
    return this._wrong(fields[0], offset, "incomplete", missingText(missing, later), stop);
  }

  /** The row of a field whose type is open, because the field that decides it has a value without a case. */
  _undecided(field, offset) {
    const [size, selector] = [this.end - this.start, this.record.selector];
    if (size < this.record.least) {
      return this._missing(py.slice(this.record.fields, -1), offset);
    }
    if (this.record.most == null || size <= this.record.most) {
      return this._wrong(field, offset, "unknown_value", this._undecidedText(selector.name, field.name));
    }
    const text = py.format(SENTENCES.UNDECIDED_TOO_LONG, {
      selector: selector.name,
      number: py.repr(py.item(this.values, selector.name)),
      name: field.name,
      count: size - this.record.most,
    });
    return this._wrong(field, offset, "wrong_length", text);
  }

  /** That a field whose value has no case does not decide the type of another one. */
  _undecidedText(selector, name) {
    return py.format(SENTENCES.UNDECIDED, { selector, number: py.repr(py.item(this.values, selector)), name });
  }

  /** The row of the rest of the body, or of the bytes up to `stop`, where a field is expected. */
  _wrong(field, start, reason, text, stop = null) {
    const path = field.field.path;
    const data = py.slice(this.data, start, stop == null ? this.end : stop);
    const row = wrongRow(this.spot, start, data, reason, text, field.name, path);
    return py.replace(row, { errata: errataAt(this.layout.device, path) });
  }

  /**
   * The result of reading the elements of one field, which have the given sizes. Adds their values
   * to `values`.
   */
  _field(field, start, sizes) {
    const rows = [];
    const program = fieldProgram(this.layout.device, this.record, field);
    const values = runEach(program, new Place(this.data, start, this.end), sizes, rows, this._rowsByName);
    if (field.isList) {
      py.put(this.values, field.name, values);
    } else if (py.truth(values)) {
      py.put(this.values, field.name, values[0]);
    }
    return new BodyTracedField({ name: field.name, rows });
  }

  /** The row of what some bytes gave; `known` are the values of the fields before it and of the request. */
  _row(row, known) {
    let [device, field, value] = [this.layout.device, row.variable.field, row.variable.value];
    const exponent = row.rowsBeside.get(row.variable.exponent);
    if (exponent != null) {
      value = exponentApplied(value, exponent.variable.value, exponent.number);
    }
    let read = decodedRow(device, row, value);
    if (row.rowsBeside === this._rowsByName) {
      read = this._deciding(field, this._measured(field, this._repeated(field, read)));
    }
    let explained = factRow(device, "field", row.path, field.field, this.spot, row.offset, row.raw, read, this.outer);
    explained = withParameter(device, explained, field, row.index, known, this.outer, this.isRequest);
    return withPercentages(device, explained, field, row.number);
  }

  /** The value of a field that measures another one, judged by the size of that field. */
  _measured(field, read) {
    let high, low;
    const measure = field.field.measures;
    const other = this.record.named(py.either(field.bitsOf, () => (measure != null ? measure.field : "")));
    if (other == null || py.truth(other.splitsRecord)) {
      return read;
    }
    const inner = this.record.innerLists;
    const span = py.next([...this.record.spans].filter((span) => span.name === other.name && span.count != null), null);
    const room = this.end - this.start - other.offset;
    if (py.truth(field.bitsOf)) {
      let size = py.max(0, py.min(this._count(other), room));
      [low, high] = size ? [8 * size - 7, 8 * size] : [0, 0];
    } else if (measure == null) {
      return read;
    } else if (span != null && span.value != null) {
      [low, high] = [span.plus, span.value.width + span.plus];
    } else if (inner != null && py.truth(other.varies)) {
      const number = py.next([...py.enumerate(inner.lists)].filter(([number, innerList]) => innerList.name === other.name).map(([number, innerList]) => number));
      if (number >= this.extents.length) {
        return this._wrongCount(py.item(inner.lists, number), field, read);
      }
      let size = py.truth(field.countsSent) ? py.item(this.extents, number).size : this._items(other) * other.size;
      low = measure.of === "bytes" ? (size + measure.plus) : measure.number(this._items(other), 1);
      high = low;
    } else {
      let items = other.isList ? this._itemsAtEnd(other) : 1;
      items = py.truth(this.record.spans) ? py.either(other.count, () => 0) : items;
      low = measure.number(items, other.size);
      high = low;
    }
    const isRight = py.isWhole(read.number) && low <= read.number && read.number <= high;
    const expected = py.equal(low, high) ? low : py.format(SENTENCES.BOUNDS, { low, high });
    return read.judged(isRight, expected, "wrong_measure");
  }

  /** How many elements of a list that ends the body there are. */
  _itemsAtEnd(field) {
    return py.max(0, py.min(this._count(field), Math.floor((this.end - this.start - field.offset) / field.size)));
  }

  /** The value of a field whose bits say how many elements others have, or bytes of a text, judged by these. */
  _deciding(field, read) {
    if (this.record.innerLists != null && this.fault != null) {
      const inner = py.item(this.record.innerLists.lists, this.extents.length);
      if (inner.presence != null && inner.sentPlus != null) {
        read = this._wrongCount(inner, field, read);
      }
    }
    for (const other of this.record.fields) {
      const [presence, number] = [other.presence, read.number];
      if (presence == null || presence.by !== field.name) {
        continue;
      }
      if (!py.has(ACCEPTED, read.reason) || !py.isWhole(number)) {
        continue;
      }
      const items = this.record.innerLists == null ? this._itemsAtEnd(other) : this._itemsIfKnown(other);
      if (items == null && this.record.innerLists != null) {
        const unknown = py.item(this.record.innerLists.lists, this.extents.length);
        read = unknown.name === other.name ? this._wrongCount(unknown, field, read) : read;
      } else if (items != null && !py.truth(presence.fits(number, items))) {
        let expected = presence.bitsText(items * presence.unit + presence.plus);
        if (py.truth(presence.numbers)) {
          const isSent = py.truth(items) ? SENTENCES.NUMBER_IF_SENT : SENTENCES.NUMBER_IF_ABSENT;
          expected = py.format(isSent, { name: other.name });
        }
        return read.judged(false, expected, "wrong_measure");
      }
    }
    return read;
  }

  /** How many elements a list with fields after it has, None where its end is not known. */
  _itemsIfKnown(field) {
    const names = [...py.slice(this.record.innerLists.lists, undefined, this.extents.length)].map((inner) => inner.name);
    return py.has(names, field.name) ? this._items(field) : null;
  }

  /** The value of a field, which is wrong if the bytes of the list are not known because of its number. */
  _wrongCount(inner, field, read) {
    if (inner.count !== field.name || !this._hasWrongCount(inner)) {
      return read;
    }
    const [low, high] = [Math.floor(inner.least / inner.unit) + inner.plus, Math.floor(inner.most / inner.unit) + inner.plus];
    let expected = py.format(SENTENCES.BOUNDS, { low, high });
    if (inner.sentPlus != null) {
      expected = py.format(SENTENCES.SIZE_OF_LIST, { name: inner.name });
    }
    expected = inner.presence == null ? expected : inner.presence.bitsText(expected);
    return read.judged(false, expected, "wrong_measure");
  }

  /** The value of a field that repeats one of the request, judged by the value there. */
  _repeated(field, read) {
    const expected = this.asked.get(field.field.sameAs);
    if (read.reason || expected == null) {
      return read;
    }
    return repeatedValue(read, expected, field.value);
  }
}
