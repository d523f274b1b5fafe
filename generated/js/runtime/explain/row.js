import { CAN_EXTENDED, CAN_REMOTE } from "./links.js";
import { SENTENCES } from "./sentences.js";
import { WORD, citations } from "./layouts.js";
import { byteCount } from "./texts.js";
import { errataAt, errataOfWords } from "./device.js";
import { py } from "./python.js";

/** The rows of an explanation, the errata that they cite, and a frame without its delimiters and encoding. */

/** Where the parts of the identifier of a CAN frame are, and the number of bytes that a remote request asks for. */
export const [IDENTIFIER, DLC] = ["identifier", "DLC"];

/**
 * Some bytes of a frame and their meaning.
 *
 * `kind` is `mark`, `part` (of the frame), `field` (of the body), `register`, or `unexplained`.
 * `offset` and `length` count bytes of the frame as it is sent, and `raw` are the bytes that they encode. If each byte
 * is sent as two characters, `characters` are these, and `length` counts them.
 * In a CAN frame, `can_place` is `identifier`, the `DLC` of a remote request, or the number of the first byte in the
 * data; otherwise it is empty.
 * `path` is the place in the frame, as in `items[0].size`; `fact` is the path of the fact in the spec.
 * `number` is the raw value, `value` the exact quantity with its unit.
 * `verdict` is empty, `right`, or `wrong: ..`, and `reason` then names the fault as the errors of the codecs do.
 * `source` cites the manual, `errata` are the ids of the errata of the fact.
 * Rows of registers have an `address`, a number of `words`, which are bits where `unit` is `bit`, and `access`,
 * empty if it is not printed.
 */
export class ExplanationRow {
  constructor({ kind, offset, length, raw, characters = "", canPlace = "", path = "", fact = "", printedName = "", label = "", doc = "", number = null, value = "", meanings = [], verdict = "", reason = "", source = "", notes = [], errata = [], address = null, words = 0, unit = WORD, access = "" }) {
    this.kind = kind;
    this.offset = offset;
    this.length = length;
    this.raw = raw;
    this.characters = characters;
    this.canPlace = canPlace;
    this.path = path;
    this.fact = fact;
    this.printedName = printedName;
    this.label = label;
    this.doc = doc;
    this.number = number;
    this.value = value;
    this.meanings = meanings;
    this.verdict = verdict;
    this.reason = reason;
    this.source = source;
    this.notes = notes;
    this.errata = errata;
    this.address = address;
    this.words = words;
    this.unit = unit;
    this.access = access;
  }

  /** Where its bytes begin, as people count: in a CAN frame from the first byte of the data. */
  get at() {
    return this.canPlace || py.str(this.offset);
  }

  /** The characters of the bytes, or the identifier of a CAN frame as tools for CAN buses write it: `123`. */
  get sent() {
    if (this.canPlace !== IDENTIFIER || !this.characters) {
      return this.characters;
    }
    const number = py.int(py.slice(this.characters.replaceAll(" ", ""), undefined, 8), 16);
    const identifier = py.without(py.without(number, CAN_EXTENDED), CAN_REMOTE);
    return py.truth(py.common(number, CAN_EXTENDED)) ? `${py.hexadecimal(identifier, "08X")}` : `${py.hexadecimal(identifier, "03X")}`;
  }

  /** `byte 4`; in a CAN frame `byte 2 of the data`, `the identifier` or `the DLC`. */
  get byteText() {
    if (py.has([IDENTIFIER, DLC], this.canPlace)) {
      return `the ${this.canPlace}`;
    }
    return this.canPlace ? `byte ${this.canPlace} of the data` : `byte ${this.offset}`;
  }
}

/**
 * Where the bytes of the parts are in a frame: from `start` on, `width` bytes or characters for each.
 *
 * `escape` is that of the bytes, if they have one. In a frame with escapes, `originals` are the bytes before they were
 * escaped, and `places` the offsets after `start` of what is sent for them, and of the end. `gap` is the place of the
 * first byte after an escape of nothing, which is sent between that byte and the one before; None without one.
 */
export class Spot {
  constructor({ frame, start, width, places = [], originals = Uint8Array.of(), escape = null, gap = null }) {
    this.frame = frame;
    this.start = start;
    this.width = width;
    this.places = places;
    this.originals = originals;
    this.escape = escape;
    this.gap = gap;
  }

  /** Where the byte at `position` of the parts is in a CAN frame; empty in others, and where it is unreadable. */
  canPlace(position) {
    if (this.escape == null || this.escape.method !== "can" || !py.truth(this.places)) {
      return "";
    }
    if (position < this.escape.fieldsSize) {
      return IDENTIFIER;
    }
    const isRemote = this.escape.isRemote(py.slice(this.frame, this.start));
    return isRemote ? DLC : py.str(position - this.escape.fieldsSize);
  }

  /** `byte 4` of the frame, or `byte 2 of the data` of a CAN frame, for a byte of the parts. */
  byteText(position) {
    if (this.escape != null && this.escape.method === "can") {
      return this.escape.byteText(position);
    }
    return `byte ${this.place(position, 0)[0]}`;
  }

  /**
   * The offset and the length in the frame of `length` bytes of the parts from `position` on; their characters.
   *
   * The characters of bytes that are escaped are the bytes that are sent, as hexadecimal digits.
   */
  place(position, length) {
    let offset;
    if (py.truth(this.places)) {
      const end = this.places.length - 1;
      let [first, stop] = [py.item(this.places, py.min(position, end)), py.item(this.places, py.min(position + length, end))];
      stop = (length && py.equal(position + length, this.gap)) ? this.gap : stop;
      offset = this.start + first;
      const escaped = py.slice(this.frame, offset, offset + stop - first);
      return [offset, escaped.length, !py.equal(escaped, py.slice(this.originals, position, position + length)) ? py.hex(escaped, " ").toUpperCase() : ""];
    }
    [offset, length] = [this.start + (position * this.width), length * this.width];
    const characters = this.width > 1 ? py.decode(py.slice(this.frame, offset, offset + length), "latin-1") : "";
    return [offset, length, characters];
  }
}

/**
 * The row of a fact whose bytes are at `position` in the parts. A fact without sources has the
 * sources of `outer`.
 */
export function factRow(device, kind, path, fact, spot, position, raw, read, outer) {
  const [offset, length, characters] = spot.place(position, raw.length);
  const errata = [...errataAt(device, fact.path), ...errataOfWords(device, read.facts)];
  return new ExplanationRow({
    kind,
    offset,
    length,
    raw,
    characters,
    canPlace: spot.canPlace(position),
    path,
    fact: fact.path,
    printedName: fact.printed,
    label: fact.label,
    doc: fact.doc,
    number: read.number,
    value: read.text,
    meanings: read.meanings,
    verdict: read.verdict,
    reason: read.reason,
    source: citations(py.either(fact.source, () => outer.source)),
    notes: [...(fact.notes ?? []), ...(read.notes ?? [])],
    errata: py.tuple(py.dict([...errata].map((key) => [key, null]))),
  });
}

/** The row of bytes that no fact describes, or of a place where bytes are missing. */
export function wrongRow(spot, position, raw, reason, detail, path = "", fact = "") {
  const [offset, length, characters] = spot.place(position, raw.length);
  return new ExplanationRow({
    kind: "unexplained",
    offset,
    length,
    raw,
    characters,
    canPlace: spot.canPlace(position),
    path,
    fact,
    verdict: py.format(SENTENCES.WRONG, { fault: detail }),
    reason,
  });
}

/** The row of bytes after the end of a frame or of its body. */
export function surplusRow(spot, position, raw) {
  const text = py.format(SENTENCES.TOO_MANY, { bytes: byteCount(raw.length) });
  return wrongRow(spot, position, raw, "wrong_length", text);
}

export const HEX = Uint8Array.of(48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 65, 66, 67, 68, 69, 70, 97, 98, 99, 100, 101, 102);

/**
 * A frame without delimiters and encoding.
 *
 * `marks` are the delimiters, `start` and `end` the bytes in their places, `start` with the `preamble` bytes of the
 * preamble before it, of which a sender may send more or fewer. `data` are the bytes of the parts, and
 * `surplus` is what is left between them and the end. Its `reason` is `wrong_length`, or `not_hex`, in which case the
 * rest of the frame cannot be read.
 */
export class Unwrapped {
  constructor({ link, marks, frame, start, data, surplus, reason, end, preamble = 0 }) {
    this.link = link;
    this.marks = marks;
    this.frame = frame;
    this.start = start;
    this.data = data;
    this.surplus = surplus;
    this.reason = reason;
    this.end = end;
    this.preamble = preamble;
  }

  /** Whether the parts can be read up to the end of the frame. */
  get whole() {
    return this.reason !== "not_hex";
  }
}

/** A frame of a link without its delimiters and its encoding. */
export function unwrapped(link, direction, frame) {
  const marks = link.marks(direction);
  const lead = link.preamble != null ? (link.preamble.least + link.preamble.surplus(frame)) : 0;
  const start = py.joined(py.slice(frame, undefined, lead), rowMark(py.slice(frame, lead), marks[0], link.transmission));
  const end = py.reversed(rowMark(py.reversed(py.slice(frame, start.length)), py.reversed(marks[1]), link.transmission));
  const inner = py.slice(frame, start.length, frame.length - end.length);
  if (link.transmission === "binary") {
    return new Unwrapped({
      link,
      marks,
      frame,
      start,
      data: inner,
      surplus: Uint8Array.of(),
      reason: "",
      end,
      preamble: lead,
    });
  }
  const good = py.next([...py.enumerate(inner)].filter(([index, char]) => !py.has(HEX, char)).map(([index, char]) => index), inner.length);
  const pairs = Math.floor(good / 2) * 2;
  const reason = good < inner.length ? "not_hex" : pairs < good ? "wrong_length" : "";
  const data = py.bytesOfHex(py.decode(py.slice(inner, undefined, pairs), "ascii"));
  return new Unwrapped({ link, marks, frame, start, data, surplus: py.slice(inner, pairs), reason, end });
}

/** The bytes in the place of a delimiter: the delimiter itself, or bytes that can be nothing else. */
function rowMark(frame, mark, encoding) {
  if (py.startswith(frame, mark) || encoding === "binary") {
    return py.slice(frame, undefined, mark.length);
  }
  return py.slice(frame, undefined, py.next([...py.enumerate(py.slice(frame, undefined, mark.length))].filter(([index, char]) => py.has(HEX, char)).map(([index, char]) => index), mark.length));
}

/** The rows of the preamble and of the start delimiter, if the link has them. */
export function* startRows(parts) {
  const preamble = parts.link.preamble;
  const size = parts.preamble;
  if (preamble != null) {
    yield* rowMarkRow(parts, "preamble", 0, py.slice(parts.start, undefined, size), py.bytes(py.repeated([preamble.byte], size)));
  }
  yield* rowMarkRow(parts, "start", size, py.slice(parts.start, size), parts.marks[0]);
}

/** The rows of surplus characters, and of the end delimiter, if the link has one. */
export function* endRows(parts) {
  const offset = parts.frame.length - parts.end.length;
  if (py.truth(parts.surplus)) {
    const text = parts.whole ? SENTENCES.CHARACTER_TOO_MANY : SENTENCES.NOT_PAIRS;
    yield new ExplanationRow({
      kind: "unexplained",
      offset: offset - parts.surplus.length,
      length: parts.surplus.length,
      raw: parts.surplus,
      characters: py.decode(parts.surplus, "latin-1"),
      verdict: py.format(SENTENCES.WRONG, { fault: text }),
      reason: parts.reason,
    });
  }
  yield* rowMarkRow(parts, "end", offset, parts.end, parts.marks[1]);
}

/**
 * The row of bytes of an escape that stand for no bytes, as the code of COBS before no data.
 *
 * They are at `position` in the parts; `raw` are the bytes that are sent.
 */
export function escapeRow(spot, link, position, raw) {
  return new ExplanationRow({
    kind: "mark",
    offset: spot.start + position,
    length: raw.length,
    raw,
    path: "escape",
    fact: link.path,
    verdict: "right",
    source: citations(link.source),
  });
}

function* rowMarkRow(parts, name, offset, data, expected) {
  if (py.truth(expected)) {
    const right = py.equal(data, expected);
    yield new ExplanationRow({
      kind: "mark",
      offset,
      length: data.length,
      raw: data,
      characters: parts.link.transmission === "hex_ascii" ? py.decode(data, "latin-1") : "",
      path: name,
      fact: parts.link.path,
      verdict: right ? "right" : py.format(SENTENCES.SHOULD_BE, { expected: py.hex(expected, " ").toUpperCase() }),
      reason: right ? "" : "wrong_mark",
      source: citations(parts.link.source),
    });
  }
}
