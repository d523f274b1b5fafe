import { avoiding, crc16, crcOf, fletcherOf, followedBy, lrc, sum8, swapping, totalOf } from "../checksums.js";
import { adding, canIdentifier, cobs, inserting, replacing } from "../escapes.js";
import { exactWhole, onBits } from "../number_bits.js";
import { inOrder, unsignedOf } from "./interpreter.js";
import { bytesOfHex } from "./texts.js";

/** What the data of devices call for checksums and escapes. */
const WIRE = {
  adding, avoiding, canIdentifier, cobs, crc16, crcOf, fletcherOf, followedBy, inserting, lrc, replacing, sum8, swapping, totalOf,
};

/**
 * The data of a device, indexed for the explainer. Everything that is looked up by a name or a number which a user or
 * the bytes of a frame decide is in a Map.
 */
export class ExplainedDevice {
  constructor(dataOf) {
    const data = dataOf(WIRE);
    this.data = data;
    this.enums = new Map(Object.entries(data.enums).map(([name, listing]) => [name, indexedEnum(listing)]));
    this.flags = new Map(Object.entries(data.flags));
    this.records = new Map(Object.entries(data.records).map(([name, record]) => [name, indexedRecord(record)]));
    this.messages = new Map(Object.entries(data.messages).map(([name, message]) => [
      name,
      { ...message, request: indexedRecord(message.request), response: indexedRecord(message.response) },
    ]));
    this.links = new Map(Object.entries(data.links).map(([name, link]) => [name, this.indexedLink(link)]));
    this.sets = new Map(Object.entries(data.sets));
    this.errataWithin = new Map();
    this.errataOf = new Map();
    this.readingsOf = new Map();
    for (const [number, { id, fact }] of data.errata.entries()) {
      for (let end = fact.length; end > 0; end = fact.lastIndexOf("/", end - 1)) this.add(this.errataWithin, fact.slice(0, end), id);
      for (const path of new Set([fact, fact.split("/restated/")[0]])) this.add(this.errataOf, path, [number, id]);
    }
    for (const example of data.examples) {
      this.add(this.readingsOf, example.frame, [example.link, example.direction, example.message ?? "", Boolean(example.error)]);
    }
  }

  add(index, key, entry) {
    if (!index.has(key)) index.set(key, []);
    index.get(key).push(entry);
  }

  indexedLink(link) {
    const [carried, coded, subcodes, delimiters] = [{}, {}, {}, {}];
    for (const direction of ["request", "response"]) {
      const messages = link.carried[direction].map((name) => [name, this.messages.get(name)]);
      carried[direction] = new Map(messages);
      coded[direction] = new Map();
      for (const [, message] of messages) this.add(coded[direction], codeIn(direction, message), message);
      subcodes[direction] = new Map(link.subcodes[direction].map((shared) => [
        shared.code, { ...shared, named: new Map(shared.messages.map(([number, name]) => [number, this.messages.get(name)])) },
      ]));
      delimiters[direction] = link.delimiters[direction].map(bytesOfHex);
    }
    const refused = new Map();
    for (const [, message] of carried.request) this.add(refused, codeIn("response", message), message);
    return {
      ...link,
      carriedMessages: carried,
      refusedByCode: refused,
      messagesByCode: coded,
      subcodes,
      delimiters,
      request: indexedFrame(link.request),
      response: indexedFrame(link.response),
    };
  }

  /** The ids of the errata of a fact and of the facts below it. */
  errataAt(path) {
    return this.errataWithin.get(path) ?? [];
  }

  /** The ids of the errata of enums, members and words that gave a value its meaning, not those of other members. */
  errataOfWords(facts) {
    const rows = new Map(facts.flatMap((path) => this.errataOf.get(path) ?? []));
    return [...rows].sort(([left], [right]) => left - right).map(([, id]) => id);
  }

  /** The parameter set with a name, or all sets of the space with that name. */
  setsNamed(name) {
    const named = this.sets.get(name);
    return named ? [named] : [...this.sets.values()].filter((words) => words.space === name);
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

function indexedRecord(record) {
  const fields = record.fields.map((field, number) => {
    const span = record.spans?.[number];
    const forms = field.forms && new Map(field.forms.flatMap(([numbers, form]) => numbers.map((own) => [BigInt(own), form])));
    const indexed = forms ? { ...field, forms } : field;
    return span?.most === undefined ? indexed : { ...indexed, span };
  });
  const indexed = { ...record, fields, named: new Map(fields.map((field) => [field.name, field])), forms: new Map() };
  for (const [numbers, form] of record.chosen ?? []) {
    const inner = indexedRecord(form);
    for (const number of numbers) indexed.forms.set(BigInt(number), inner);
  }
  return indexed;
}

function indexedFrame(frame) {
  const parts = [...frame.header, ...frame.trailer];
  return {
    ...frame,
    parts,
    checks: frame.checksums.map((name) => parts.find((part) => part.name === name)),
    lengths: parts.filter((part) => part.role === "length"),
    code: parts.find((part) => part.role === "code"),
    unitAddress: parts.find((part) => part.role === "unit_address"),
  };
}

/** The code of a message in one direction; undefined where there is none. */
export function codeIn(direction, message) {
  return direction === "response" ? message?.responseCode ?? message?.code : message?.code;
}

/** Whether several messages have a code and nothing in their data tells them apart, so that only the request does. */
export function isAmbiguous({ ambiguous = [] }, direction, code) {
  return direction === "response" && ambiguous.includes(code);
}

/**
 * The message with a code in one direction, and with some data where several have the code; `asked` names the message
 * of the request, which decides where nothing in the data does. Undefined if there is none, and where all of this leaves
 * open which one it is.
 */
export function messageWithCode(link, direction, code, data, asked) {
  const messages = link.messagesByCode[direction].get(code) ?? [];
  if (messages.length < 2) return messages[0];
  if (isAmbiguous(link, direction, code)) return messages.find(({ name }) => name === asked);
  const shared = link.subcodes[direction].get(code);
  if (!shared || !data) return undefined;
  // Data that are too short count as those of the first message.
  if (data.length < shared.offset + shared.size) return shared.named.values().next().value;
  return shared.named.get(exactWhole(unsignedOf(data.subarray(shared.offset, shared.offset + shared.size), shared.order)));
}

/**
 * The message that an exception response with a code refuses. It carries no subcode: of several messages with the code,
 * only the request tells which one it answers.
 */
export function refusedMessage(link, code, asked) {
  const messages = link.refusedByCode.get(code) ?? [];
  return messages.length === 1 ? messages[0] : messages.find(({ name }) => name === asked);
}

/** A number as manuals print a code: `0x03`, `0x1F` of two hexadecimal digits, `007` of three decimal digits. */
export function partNumberText({ size, value, numberSize = size }, number) {
  if (value.digits === "decimal") return String(number).padStart(size, "0");
  return `0x${number.toString(16).toUpperCase().padStart(value.digits ? size : 2 * numberSize, "0")}`;
}

/** Whether a response with a code and other parts before the body is an exception response; `number` returns a part's. */
export function isException({ code: own, flag, part, normal }, code, number) {
  if (part) return number(part) !== undefined && !normal.some(([low, high]) => low <= number(part) && number(part) <= high);
  return own === undefined ? onBits(code, flag, (bits, mask) => bits & mask) !== 0 : code === own;
}

/** The member of an enum with a value. */
export function memberOf(listing, number) {
  return typeof number === "number" && !Number.isInteger(number) ? undefined : listing.numbers.get(BigInt(number));
}

/** A field as the raw values of its record decide it; undefined where they decide nothing. */
export function formOfField(record, field, values) {
  if (!field.forms) return field;
  const number = values.get(field.by) ?? record.named.get(field.by).value.const;
  return number === undefined ? undefined : formOfNumber(field, number);
}

/** The form of a field that a number, or some bits of it, decides; undefined if it decides none. */
export function formOfNumber({ forms, mask }, number) {
  return forms.get(mask === undefined ? BigInt(number) : BigInt(number) & BigInt(mask));
}

/** The form of a record for some data: the record itself, or what its selector decides; undefined if it decides none. */
export function formOfData(record, data) {
  if (record.selector === undefined) return record;
  const { offset, size, value } = record.named.get(record.selector);
  if (data.length < offset + size) return undefined;
  return record.forms.get(unsignedOf(inOrder(value, data.subarray(offset, offset + size)), "big"));
}
