import { avoiding, crc16, crcOf, fletcherOf, followedBy, lrc, sum8, swapping, totalOf } from "../checksums.js";
import { adding, canIdentifier, cobs, inserting, replacing } from "../escapes.js";
import { py } from "./python.js";
import { BYTE, Message, RecordLayout, RegisterLayout, Table, WORD } from "./layouts.js";
import { LinkLayout } from "./links.js";
import { ParameterSet } from "./parameter_sets.js";
import { bytesOfHex, hexOf } from "./texts.js";

/** What the data of devices call for checksums and escapes. */
const WIRE = {
  adding, avoiding, canIdentifier, cobs, crc16, crcOf, fletcherOf, followedBy, inserting, lrc, replacing, sum8, swapping, totalOf,
};

/**
 * The data of a device, indexed for the explainer. Everything that is looked up by a name or a number which a user or
 * the bytes of a frame decide is in a Map or in a dictionary.
 */
export class ExplainedDevice {
  constructor(dataOf) {
    const data = dataOf(WIRE);
    const indexed = (entries, make) => py.dict(Object.entries(entries).map(([name, entry]) => [name, make(entry)]));
    Object.assign(this, { data, device: this, id: data.device });
    this.enums = new Map(Object.entries(data.enums).map(([name, listing]) => [name, indexedEnum(listing)]));
    this.flags = new Map(Object.entries(data.flags));
    this.records = indexed(data.records, (record) => new RecordLayout(record));
    this.messages = indexed(data.messages, (message) => new Message(message));
    this.links = indexed(data.links, (link) => new LinkLayout(link, this.messages));
    this.units = new Map(this.messages.values().flatMap(({ accesses }) => accesses.map(({ space, unit }) => [space, unit])));
    this.registers = data.registers.map((register) => new RegisterLayout(register));
    this.tables = py.dict(data.tables.map((table) => [table.name, new Table(table, this.records)]));
    this.groups = data.gaps.map(({ space, addresses, reason }) => ({ space, gaps: [{ reason, addresses: { intervals: addresses } }] }));
    this.parameterSets = indexed(data.sets, (listing) => new ParameterSet(listing));
    this.errataWithin = new Map();
    this.errataOf = new Map();
    this.examplesOf = new Map();
    for (const [number, { id, fact }] of data.errata.entries()) {
      for (let end = fact.length; end > 0; end = fact.lastIndexOf("/", end - 1)) this.add(this.errataWithin, fact.slice(0, end), id);
      for (const path of new Set([fact, fact.split("/restated/")[0]])) this.add(this.errataOf, path, [number, id]);
    }
    for (const example of data.examples) {
      const { link, direction, message = "", error = false } = example;
      this.add(this.examplesOf, example.frame, { link, direction, message, exceptionResponse: error, frame: bytesOfHex(example.frame) });
    }
  }

  add(index, key, entry) {
    if (!index.has(key)) index.set(key, []);
    index.get(key).push(entry);
  }

  /** A space by its name, and the bytes of its unit. */
  space(name) {
    const unit = this.units.get(name) ?? WORD;
    return { unit, unitSize: unit === BYTE ? 1 : 2 };
  }

  spaceName(name) {
    return name ?? "";
  }

  /** The parameter set with a name, or all sets of the space with that name. */
  sets(name) {
    const named = this.parameterSets.get(name);
    return named ? [named] : this.parameterSets.values().filter((own) => own.space === name);
  }

  /** The set, named or in a space, that has a number on the wire, and the number in it; null if none has it. */
  parameterAt(name, number) {
    const own = this.sets(name).find((listing) => listing.holds(Number(number) - listing.base));
    return own ? [own, Number(number) - own.base] : null;
  }
}

function indexedEnum(listing) {
  const numbers = new Map();
  const names = new Map();
  for (const member of listing.members) {
    if (!numbers.has(BigInt(member.value))) numbers.set(BigInt(member.value), member);
    for (const name of [member.name, ...(member.aliases ?? [])]) if (!names.has(name)) names.set(name, member);
  }
  return { ...listing, numbers, names };
}

/** The ids of the errata of a fact and of the facts below it. */
export function errataAt(device, path) {
  return device.errataWithin.get(path) ?? [];
}

/** The ids of the errata of enums, members and words that gave a value its meaning, not those of other members. */
export function errataOfWords(device, facts) {
  const rows = new Map(facts.flatMap((path) => device.errataOf.get(path) ?? []));
  return [...rows].sort(([left], [right]) => left - right).map(([, id]) => id);
}

/** The ids of the errata of a message, without the errata of its fields. */
export function errataOfMessage(device, { errata = [] }) {
  return errata;
}

/** The examples that have exactly these bytes. */
export function examplesOfBytes(device, frame) {
  return device.examplesOf.get(hexOf(frame)) ?? [];
}

/** The member of an enum with a value. */
export function memberOf(listing, number) {
  return typeof number === "number" && !Number.isInteger(number) ? undefined : listing.numbers.get(BigInt(number));
}
