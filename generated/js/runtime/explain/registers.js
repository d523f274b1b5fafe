import { isWhole } from "./numbers.js";
import { contentOf } from "./interpreter.js";
import { decodeAnswer, decoded, decodeValue, exponentApplied, forWriting } from "./values.js";
import { factRow, rowOf } from "./rows.js";
import { SENTENCES } from "./sentences.js";
import { sentence } from "./texts.js";

/** The values of no request. */
export const NOTHING = new Map();

/** Why an access forbids an operation; empty if it does not. */
export function forbiddenText(operation, access) {
  if (operation === "write" && access === "ro") return SENTENCES.READ_ONLY;
  return operation === "read" && access === "wo" ? SENTENCES.WRITE_ONLY : "";
}

/**
 * `words` from `address` on in a space. `data` are their bytes in the frame, at `at` in its parts, or empty. In a space
 * of bits, `words` counts these, and `bits` has those that the frame carries; in other spaces it is null. In a space of bytes, `words` counts
 * these, and an address has a `unitSize` of 1. `digits` are the hexadecimal digits that the frame has for `data`, two for each byte; null if
 * it has the bytes themselves.
 */
export class AddressSpan {
  constructor(space, address, words, at, data, bits = null, unitSize = 2, digits = null) {
    Object.assign(this, { space: space ?? "", address, words, at, data, bits, unitSize, digits, end: address + words });
  }

  get unit() {
    if (this.bits !== null) return "bit";
    return this.unitSize === 2 ? "word" : "byte";
  }

  /**
   * The bytes in the parts that are `skip` bytes after an address, and those of the value that they carry; undefined
   * unless all are there.
   */
  piece(address, size, skip = 0) {
    if (this.bits !== null) return this.bitPiece(address - this.address);
    const start = this.unitSize * (address - this.address) + skip;
    if (start < 0 || start + size > this.data.length) return undefined;
    const content = this.data.subarray(start, start + size);
    if (this.digits) return { at: this.at + 2 * start, raw: this.digits.subarray(2 * start, 2 * (start + size)), content };
    return { at: this.at + start, raw: content, content };
  }

  bitPiece(index) {
    const bit = this.bits[index];
    if (bit === undefined || bit === null) return undefined;
    const [at, end] = this.bits.length === 1 ? [0, this.data.length] : [index >> 3, (index >> 3) + 1];
    return { at: this.at + at, raw: this.data.subarray(at, end), content: Uint8Array.of(bit) };
  }
}

/**
 * The words or bits that a message accesses, by its own values or those of the request that it answers; null if
 * unknown. `data` are the bytes of the words, at `at` in the parts.
 */
function accessedSpan(access, values, asked, at, data, digits) {
  const value = (name) => (values.has(name) ? values.get(name) : asked.get(name));
  const start = value(access.start);
  if (!isWhole(start ?? "")) return null;
  const spanOf = (...more) => new AddressSpan(access.space, Number(start), ...more);
  if (access.set !== undefined) {
    const number = data.length ? values.get(access.values) : undefined;
    return spanOf(1, at, data, [number == access.clear ? 0 : number == access.set ? 1 : null]);
  }
  const [isBits, size] = [access.unit === "bit", access.unit === "byte" ? 1 : 2];
  const carried = isBits ? 8 * data.length : Math.floor(data.length / size);
  const count = access.count ? value(access.count) : isBits ? 1 : Math.max(carried, 1);
  const words = isWhole(count ?? "") ? Number(count) : carried;
  if (!isBits) return spanOf(words, at, data.subarray(0, carried * size), null, size, digits);
  return spanOf(words, at, data, Array.from({ length: Math.min(words, carried) }, (_, index) => (data[index >> 3] >> (index & 7)) & 1));
}

/** The bytes of words that are sent as hexadecimal digits, up to the first word with other characters. */
function wordBytes({ value, size }, digits) {
  const letters = value.digits === "upper_hex" ? "0123456789ABCDEF" : "0123456789abcdef";
  const numbers = Array.from(digits, (byte) => letters.indexOf(String.fromCharCode(byte)));
  const wrong = numbers.indexOf(-1);
  const length = wrong < 0 ? digits.length : wrong;
  return Uint8Array.from({ length: (Math.floor(length / size) * size) / 2 }, (_, index) => 16 * numbers[2 * index] + numbers[2 * index + 1]);
}

/**
 * The accesses of a message with what they access. Of several accesses, a response has those that read. The data of the
 * frame begin at `start` in its parts; `asked` are the values of the request that a response answers, null for a request.
 */
export function accessedSpans({ access: single, steps }, record, start, data, values, asked) {
  return (steps ?? [single]).flatMap((access) => {
    if (!access || (asked && !single && access.operation === "write")) return [];
    const field = single || (access.operation === "read") === Boolean(asked) ? record.named.get(access.values) : undefined;
    const { offset = 0, size = 0, count } = field ?? { count: 0 };
    const sent = data.subarray(offset, count === undefined ? data.length : offset + size * count);
    const digits = field?.value?.digits ? sent : null;
    const carried = digits ? wordBytes(field, digits) : sent;
    const span = accessedSpan(access, single || !asked ? values : NOTHING, asked ?? NOTHING, start + offset, carried, digits);
    return span ? [[access, span]] : [];
  });
}

/** The rows of all registers that share words with a span, by address, and of words that no register has. */
export function registerRows(device, span, spot, operation) {
  const present = occupantsOf(device, span).sort((left, right) => left.address - right.address);
  const rows = [];
  let at = span.address;
  for (const occupant of present) {
    if (occupant.address > at) rows.push(unlistedRow(device, span, at, occupant.address, spot));
    at = Math.max(at, occupant.address + occupant.words);
    const row = registerRow(device, span, occupant, spot, operation);
    const why = forbiddenText(operation, occupant.access);
    rows.push(why ? { ...row, notes: [...row.notes, sentence(SENTENCES.IT, { statement: why })] } : row);
  }
  if (at < span.end) rows.push(unlistedRow(device, span, at, span.end, spot));
  return rows;
}

/** The register or the field of a table's element that begins at an address of a space; undefined if there is none. */
export function occupantAt(device, space, address) {
  const occupants = occupantsOf(device, new AddressSpan(space, address, 1, 0, new Uint8Array()));
  return occupants.find((occupant) => occupant.address === address);
}

/** The registers, and the fields of tables, that share words with a span, in the order of the spec. */
export function occupantsOf(device, span) {
  const occupants = [];
  for (const register of device.data.registers) {
    if ((register.space ?? "") !== span.space) continue;
    const end = register.address + (register.count - 1) * register.stride + register.words;
    if (register.address < span.end && span.address < end) addElements(occupants, register, span);
  }
  for (const table of device.data.tables) {
    const base = baseOf(device, table, span);
    if (base !== null && (table.space ?? "") === span.space) addFields(occupants, device, { ...table, base }, span);
  }
  return occupants;
}

/** Where a table begins; null if only a register says where, and the span does not have it. */
function baseOf(device, table, span) {
  if (!table.baseBy) return table.base;
  const register = device.data.registers.find(({ name }) => name === table.baseBy);
  if ((register.space ?? "") !== span.space) return null;
  const { address, value } = register;
  const piece = span.piece(address, value.size);
  const number = piece && contentOf(value, piece.content);
  return isWhole(number ?? "") && value.ranges.some(([low, high]) => low <= number && number <= high) ? Number(number) : null;
}

/** What may be at addresses: elements of tables of which the frame does not say where they begin. */
function unknownBases(device, span, first, end) {
  return device.data.tables.flatMap((table) => {
    if (!table.baseBy || (table.space ?? "") !== span.space || baseOf(device, table, span) !== null) return [];
    const after = (table.count - 1) * table.stride + table.words;
    const { ranges } = device.data.registers.find(({ name }) => name === table.baseBy).value;
    const isNear = ranges.some(([low, high]) => low < end && first < high + after);
    return isNear ? [sentence(SENTENCES.ELEMENTS_OF_TABLE, { table: table.name, register: table.baseBy })] : [];
  });
}

function addElements(occupants, register, span) {
  const [first, last] = nearElements(register.address, register, span);
  for (let number = first; number < last; number++) {
    const source = register.elementSources?.[number];
    occupants.push({
      address: register.address + number * register.stride,
      words: register.words,
      path: register.count === 1 ? register.name : `${register.name}[${register.first + number}]`,
      fact: source === undefined ? register : { ...register, source },
      outer: register,
      value: register.value,
      access: register.access ?? "",
      reserved: false,
      atomic: Boolean(register.atomic),
      trigger: Boolean(register.trigger),
    });
  }
}

function addFields(occupants, device, table, span) {
  const [start, last] = nearElements(table.base, table, span);
  if (start === last) return;
  for (let number = start; number < last; number++) {
    const base = table.base + number * table.stride;
    for (const { path, record, field: name, offset, words, access = "", atomic = false, exponent } of table.fields) {
      const address = base + (offset >> 1);
      if (address >= span.end || span.address >= address + words) continue;
      const { named } = device.records.get(record);
      const field = named.get(name);
      occupants.push({
        address,
        words,
        path: `${table.name}[${table.first + number}].${path}`,
        fact: field,
        outer: table,
        value: field.value,
        skip: offset & 1,
        exponent: exponent && { address: base + (exponent[0] >> 1), skip: exponent[0] & 1, value: named.get(exponent[1]).value },
        element: number,
        access,
        reserved: Boolean(field.reserved),
        atomic,
        trigger: false,
      });
    }
  }
}

/** The numbers of the first element that may share words with a span, and of the one after the last. */
function nearElements(base, { stride, words, count }, span) {
  const first = Math.max(0, Math.floor((span.address - base - words) / stride) + 1);
  return [first, Math.max(first, Math.min(count, Math.ceil((span.end - base) / stride)))];
}

function registerRow(device, span, occupant, spot, operation) {
  const piece = span.piece(occupant.address, occupant.value.size, occupant.skip);
  let read;
  if (piece) {
    const own = operation === "write" ? forWriting(occupant.value) : occupant.value;
    const value = byExponent(device, span, occupant, own);
    const decode = operation === "write" ? decodeValue : decodeAnswer;
    read = decode(device, value, piece.content, occupant.reserved, occupant.trigger);
  } else {
    const inside = span.address <= occupant.address && occupant.address + occupant.words <= span.end;
    const partial = occupant.atomic ? SENTENCES.PARTIAL_ATOMIC : SENTENCES.PARTIAL;
    read = decoded(null, { notes: inside ? [] : [sentence(partial, span)] });
  }
  const { at, raw } = piece ?? { at: 0, raw: new Uint8Array() };
  const row = factRow(device, "register", occupant.path, occupant.fact, spot, at, raw, read, occupant.outer);
  const place = { address: occupant.address, words: occupant.words, unit: span.unit, access: occupant.access };
  const notes = [...row.notes, ...absence(device, span, occupant)];
  return { ...row, ...place, notes, ...(piece ? {} : { offset: 0, canPlace: "" }) };
}

/** The note of a field in an element that the device has not got, where the span has the count, too. */
function absence(device, span, { outer, element }) {
  const count = outer.countBy && device.data.registers.find(({ name }) => name === outer.countBy);
  const piece = count && span.piece(count.address, count.value.size);
  if (!piece) return [];
  const number = contentOf(count.value, piece.content);
  return isWhole(number) && element >= number ? [sentence(SENTENCES.ABSENT_ELEMENT, { count: count.name, number })] : [];
}

/** A value with its scale, where a field of the same element or a register has the exponent, and the span has that one, too. */
function byExponent(device, span, occupant, value) {
  if (!value.scaleBy) return value;
  const exponent = occupant.exponent ?? { skip: 0, ...device.data.registers.find(({ name }) => name === value.scaleBy) };
  const piece = span.piece(exponent.address, exponent.value.size, exponent.skip);
  return piece ? exponentApplied(value, exponent.value, contentOf(exponent.value, piece.content)) : value;
}

/** The row of words that no register has, with the reasons of the gaps there. */
function unlistedRow(device, span, first, end, spot) {
  const gaps = device.data.gaps.filter(({ space, addresses }) =>
    space === span.space && addresses.some(([low, high]) => low < end && first <= high));
  // Bits share bytes with others, so that theirs are not printed.
  const piece = span.bits === null ? span.piece(first, span.unitSize * (end - first)) : undefined;
  return rowOf({
    kind: "register",
    ...(piece?.raw.length ? { raw: piece.raw, ...spot.place(piece.at, piece.raw.length) } : {}),
    doc: SENTENCES.UNLISTED_REGISTER,
    notes: [...gaps.map(({ reason }) => reason), ...unknownBases(device, span, first, end)],
    address: first,
    words: end - first,
    unit: span.unit,
  });
}
