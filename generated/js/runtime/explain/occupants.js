import { ByIdentity, Table, movingTables, nestedFields } from "./layouts.js";
import { SENTENCES } from "./sentences.js";
import { Span } from "./spans.js";
import { hasInRanges } from "./values.js";
import { numberOf } from "./interpreter.js";
import { py } from "./python.js";

/** The occupants of addresses: registers, and fields in elements of tables. */

/** Why an access forbids an operation; empty if it does not. */
export function forbiddenText(operation, access) {
  if (operation === "write" && access === "ro") {
    return SENTENCES.READ_ONLY;
  }
  return (operation === "read" && access === "wo") ? SENTENCES.WRITE_ONLY : "";
}

/**
 * The occupant of an address: a register, or a field in an element of a table. Its bytes begin after `skip` bytes.
 *
 * `nested` is the field in the record of its table, or in a record in that one; None for a register.
 */
export class Occupant {
  constructor({ address, words, path, fact, outer, value, order, swapped, access, reserved, atomic = false, trigger = false, skip = 0, nested = null }) {
    this.address = address;
    this.words = words;
    this.path = path;
    this.fact = fact;
    this.outer = outer;
    this.value = value;
    this.order = order;
    this.swapped = swapped;
    this.access = access;
    this.reserved = reserved;
    this.atomic = atomic;
    this.trigger = trigger;
    this.skip = skip;
    this.nested = nested;
  }

  /** The value in a `read` or a `write`, which has a range of its own. */
  valueFor(operation) {
    return operation === "write" ? this.value.forWriting() : this.value;
  }

  /** Whether the words of a value are swapped in a `read` or a `write`. */
  isSwapped(operation) {
    return operation === "write" ? this.value.writeSwapped(this.swapped) : this.swapped;
  }
}

/**
 * Why the words of a span cannot be read or written; empty if all of them can, as far as the spec says.
 *
 * A part of an atomic value can be neither read nor written.
 */
export function forbidden(layout, span, operation) {
  for (const occupant of py.sorted(occupants(layout, span), (occupant) => occupant.address)) {
    let reason = forbiddenText(operation, occupant.access);
    if (!reason && occupant.atomic && !isWithinSpan(occupant, span)) {
      reason = `has ${occupant.words} ${span.unit}s, all of which must be accessed in one request`;
    }
    if (reason) {
      return `${occupant.path} at 0x${py.hexadecimal(occupant.address, "04X")} ${reason}`;
    }
  }
  return "";
}

/** Whether a span has all words of an occupant. */
export function isWithinSpan(occupant, span) {
  return span.address <= occupant.address && (occupant.address + occupant.words) <= span.end;
}

/** The register or the field of a table's element that begins at an address of a space; None if there is none. */
export function occupantAt(layout, space, address) {
  const neighbours = occupants(layout, new Span({ space, address, words: 1, at: 0, data: Uint8Array.of() }));
  return py.next([...neighbours].filter((occupant) => py.equal(occupant.address, address)), null);
}

/**
 * The registers, and the fields of tables, that share words with a span, in the order of the spec.
 *
 * In a table with a variable base, only a span with the value of the base register has fields.
 */
export function* occupants(layout, span) {
  const device = layout.device;
  const own = device.spaceName(span.space);
  const blocks = (OCCUPANTS_INDEXES.getOrCompute(layout, occupantsIndex).get(own) ?? py.dict([]));
  const nearBlocks = py.range(Math.floor(span.address / OCCUPANTS_BLOCK), Math.floor(py.max(span.address, span.end - 1) / OCCUPANTS_BLOCK) + 1);
  const numbers = py.dict([...nearBlocks].flatMap((block) => [...(blocks.get(block) ?? [])]).map((key) => [key, null]));
  for (const number of py.sorted(numbers)) {
    yield* occupantsElements(py.item(layout.registers, number), span);
  }
  for (const table of layout.tables.values()) {
    const located = locatedTable(layout, table, span);
    if (located != null && py.equal(device.spaceName(table.table.space), own)) {
      yield* occupantsFields(located, span);
    }
  }
}

const OCCUPANTS_BLOCK = 64;

/** By space and block of addresses: the numbers of the registers with words there. */
const OCCUPANTS_INDEXES = new ByIdentity(8);

function occupantsIndex(layout) {
  const result = py.dict([]);
  for (const [number, register] of py.enumerate(layout.registers)) {
    const blocks = result.setdefault(layout.device.spaceName(register.register.space), py.dict([]));
    const last = register.address + ((register.count - 1) * register.stride) + register.words - 1;
    for (const block of py.range(Math.floor(register.address / OCCUPANTS_BLOCK), Math.floor(last / OCCUPANTS_BLOCK) + 1)) {
      blocks.setdefault(block, []).push(number);
    }
  }
  return result;
}

/** The register with the address of the first element of a table that moves. */
export function baseOfTable(layout, name) {
  return occupantsFirst(py.item(movingTables(layout), name));
}

/** The first register of a layout, as what is at its address. */
function occupantsFirst(register) {
  return py.next(occupantsElements(register, new Span({
    space: register.register.space,
    address: register.address,
    words: 1,
    at: 0,
    data: Uint8Array.of(),
  })));
}

/** A table where it begins; None if only a register says where, and the span does not have it. */
export function locatedTable(layout, table, span) {
  if (!py.truth(table.table.baseBy)) {
    return table;
  }
  const register = baseOfTable(layout, table.name);
  const space = py.item(movingTables(layout), table.name).register.space;
  if (!py.equal(layout.device.spaceName(space), layout.device.spaceName(span.space))) {
    return null;
  }
  const piece = span.piece(register.address, register.value.size);
  const number = piece != null ? numberOf(register.value, piece.content, register.order, register.swapped) : null;
  if (!py.isWhole(number) || !py.truth(hasInRanges(register.value, number))) {
    return null;
  }
  return py.replace(table, { table: py.replace(table.table, { base: py.int(number) }) });
}

function* occupantsElements(registerLayout, span) {
  const register = registerLayout.register;
  for (const number of occupantsElementNumbers(registerLayout.address, registerLayout.stride, registerLayout.words, registerLayout.count, span)) {
    const address = registerLayout.address + (number * registerLayout.stride);
    const path = py.equal(registerLayout.count, 1) ? registerLayout.name : `${registerLayout.name}[${register.indexFrom + number}]`;
    let fact = register;
    if (number < register.elementSources.length) {
      fact = py.replace(register, { source: [py.item(register.elementSources, number)] });
    }
    yield new Occupant({
      address,
      words: registerLayout.words,
      path,
      fact,
      outer: register,
      value: register.value,
      order: registerLayout.order,
      swapped: registerLayout.swapped,
      access: register.access,
      reserved: false,
      atomic: register.atomic,
      trigger: register.trigger,
    });
  }
}

function* occupantsFields(tableLayout, span) {
  const table = tableLayout.table;
  const numbers = occupantsElementNumbers(table.base, table.stride, tableLayout.words, table.count, span);
  const nested = py.truth(numbers) ? py.tuple(nestedFields(tableLayout.record)) : [];
  for (const number of numbers) {
    const base = table.base + (number * table.stride);
    for (const field of nested) {
      const first = base + Math.floor(field.offset / 2);
      if (first < span.end && span.address < (first + field.words)) {
        yield occupantsField(table, field, number);
      }
    }
  }
}

/** A field in the element with a number, counted from 0. */
function occupantsField(table, nested, number) {
  const field = nested.field;
  return new Occupant({
    address: table.base + (number * table.stride) + Math.floor(nested.offset / 2),
    words: nested.words,
    path: `${table.name}[${table.indexFrom + number}].${nested.path}`,
    fact: field.field,
    outer: table,
    value: field.value,
    order: field.order,
    swapped: field.swapped,
    access: nested.access(table.access),
    reserved: field.field.reserved,
    atomic: field.field.atomic,
    skip: nested.offset % 2,
    nested,
  });
}

/** The numbers of the elements that may share words with a span. */
function occupantsElementNumbers(base, stride, words, count, span) {
  const first = py.max(0, Math.floor((span.address - base - words) / stride) + 1);
  const last = py.min(count, -Math.floor(-(span.end - base) / stride));
  return py.range(first, py.max(first, last));
}

/** The fact with the exponent of a value's scale: a field of the same record, or a register; None without one. */
export function exponentOfOccupant(layout, occupant) {
  const name = occupant.value.scaleBy;
  if (!py.truth(name)) {
    return null;
  }
  const table = occupant.outer;
  const nestedExponent = occupant.nested != null ? occupant.nested.beside(name) : null;
  if (nestedExponent != null && table instanceof Table) {
    return occupantsField(table, nestedExponent, elementNumber(occupant));
  }
  return occupantsFirst(py.next([...layout.registers].filter((row) => row.name === name)));
}

/** How many elements of its table are before that of a field; 0 for a register. */
export function elementNumber(occupant) {
  const table = occupant.outer;
  return table instanceof Table ? Math.floor((occupant.address - table.base) / table.stride) : 0;
}

/** The register with the number of elements that the table of a field has; None where all are there. */
export function countOfOccupant(layout, occupant) {
  const table = occupant.outer;
  if (!(table instanceof Table) || !py.truth(table.countBy)) {
    return null;
  }
  return occupantsFirst(py.next([...layout.registers].filter((row) => row.name === table.countBy)));
}

/** Why a device has not got an element: what its register of the count says. */
export function absentText(count, number) {
  return py.format(SENTENCES.ABSENT_ELEMENT, { count: count.path, number });
}
