import { DecodedValue, decodeAnswer, decodeValue, exponentApplied, intervalsOf } from "./values.js";
import { ExplanationRow, factRow } from "./row.js";
import { SENTENCES } from "./sentences.js";
import { absentText, countOfOccupant, elementNumber, exponentOfOccupant, forbiddenText, isWithinSpan, locatedTable, occupants } from "./occupants.js";
import { movingTables } from "./layouts.js";
import { numberOf } from "./interpreter.js";
import { py } from "./python.js";

/** The registers that a frame reads or writes. */

/** The rows of some spans, each with its operation; they are made once, on demand. */
export class RegisterRows {
  constructor(layout, spot, spans) {
    [this._layout, this._spot, this._spans] = [layout, spot, spans];
    this._rows = null;
  }

  /** The rows, in the order of the spans. */
  get rows() {
    if (this._rows == null) {
      const [layout, spot] = [this._layout, this._spot];
      this._rows = (layout == null || spot == null) ? [] : [...this._spans].flatMap(([operation, span]) => [...registerRows(layout, span, spot, operation)]);
    }
    return this._rows;
  }
}

export const NO_REGISTERS = new RegisterRows(null, null, []);

/**
 * The rows of all registers that share words with a span, by address, and of words that no register has.
 *
 * `operation` is `read` or `write`. Registers that do not allow it have a note.
 */
export function* registerRows(layout, span, spot, operation) {
  const present = py.sorted(occupants(layout, span), (occupant) => occupant.address);
  let address = span.address;
  for (const occupant of present) {
    if (occupant.address > address) {
      yield registersUnlisted(layout, span, address, occupant.address, spot);
    }
    address = py.max(address, occupant.address + occupant.words);
    const row = registersOccupantRow(layout, span, occupant, spot, operation);
    const reason = forbiddenText(operation, occupant.access);
    yield reason ? py.replace(row, { notes: [...(row.notes ?? []), py.format(SENTENCES.IT, { statement: reason })] }) : row;
  }
  if (address < span.end) {
    yield registersUnlisted(layout, span, address, span.end, spot);
  }
}

function registersOccupantRow(layout, span, occupant, spot, operation) {
  let read;
  const piece = span.piece(occupant.address, occupant.value.size, occupant.skip);
  const [offset, raw] = py.truth(piece) ? [piece.at, piece.raw] : [0, Uint8Array.of()];
  if (py.truth(piece)) {
    const value = registersByExponent(layout, span, occupant, occupant.valueFor(operation));
    const arguments_ = [piece.content, occupant.order, occupant.isSwapped(operation), occupant.reserved];
    if (operation === "write") {
      read = decodeValue(layout.device, value, ...arguments_);
    } else {
      read = decodeAnswer(layout.device, value, ...arguments_, occupant.trigger);
    }
  } else {
    const isInside = isWithinSpan(occupant, span);
    const partial = occupant.atomic ? SENTENCES.PARTIAL_ATOMIC : SENTENCES.PARTIAL;
    const notes = isInside ? [] : [py.format(partial, { unit: span.unit })];
    read = py.replace(new DecodedValue(null), { notes });
  }
  let row = factRow(layout.device, "register", occupant.path, occupant.fact, spot, offset, raw, read, occupant.outer);
  if (!py.truth(piece)) {
    row = py.replace(row, { offset: 0, canPlace: "" });
  }
  row = py.replace(row, { notes: [...(row.notes ?? []), ...registersAbsence(layout, span, occupant)] });
  return py.replace(row, {
    address: occupant.address,
    words: occupant.words,
    unit: span.unit,
    access: occupant.access,
  });
}

/** The note of a field in an element that the device has not got, where the span has the count, too. */
function registersAbsence(layout, span, occupant) {
  const count = countOfOccupant(layout, occupant);
  const piece = count != null ? span.piece(count.address, count.value.size) : null;
  if (count == null || piece == null) {
    return [];
  }
  const number = numberOf(count.value, piece.content, count.order, count.swapped);
  return (py.isWhole(number) && elementNumber(occupant) >= number) ? [absentText(count, number)] : [];
}

/** A value with its scale, where the exponent is elsewhere, and the span has it, too. */
function registersByExponent(layout, span, occupant, value) {
  const exponent = exponentOfOccupant(layout, occupant);
  const piece = exponent != null ? span.piece(exponent.address, exponent.value.size, exponent.skip) : null;
  if (exponent == null || piece == null) {
    return value;
  }
  const number = numberOf(exponent.value, piece.content, exponent.order, exponent.swapped);
  return exponentApplied(value, exponent.value, number);
}

/** The row of words that no register has, with the reasons of the gaps there. */
function registersUnlisted(layout, span, first, end, spot) {
  const reasons = [...layout.device.groups].filter((group) => py.equal(layout.device.spaceName(group.space), layout.device.spaceName(span.space))).flatMap((group) => [...group.gaps].filter((gap) => [...gap.addresses.intervals].some(([low, high]) => low < end && first <= high)).map((gap) => gap.reason));
  const [start, raw] = span.unlisted(first, end);
  const [offset, length, characters] = py.truth(raw) ? spot.place(start, raw.length) : [0, 0, ""];
  return new ExplanationRow({
    kind: "register",
    offset,
    length,
    raw,
    characters,
    canPlace: py.truth(raw) ? spot.canPlace(start) : "",
    doc: SENTENCES.UNLISTED_REGISTER,
    notes: [...reasons, ...registersUnknownBases(layout, span, first, end)],
    address: first,
    words: end - first,
    unit: span.unit,
  });
}

/** What may be at addresses: elements of tables of which the frame does not say where they begin. */
function* registersUnknownBases(layout, span, first, end) {
  const own = layout.device.spaceName(span.space);
  for (const [name, register] of movingTables(layout).entries()) {
    const table = py.item(layout.tables, name);
    const reach = (table.table.count - 1) * table.table.stride + table.words;
    if (!py.equal(layout.device.spaceName(table.table.space), own) || locatedTable(layout, table, span) != null) {
      continue;
    }
    const intervals = intervalsOf(register.register.value);
    if ([...intervals].some(([low, high]) => low < end && first < (high + reach))) {
      yield py.format(SENTENCES.ELEMENTS_OF_TABLE, { table: name, register: register.name });
    }
  }
}
