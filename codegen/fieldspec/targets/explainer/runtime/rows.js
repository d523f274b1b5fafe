import { isRemoteRequest } from "../escapes.js";
import { identifierSize } from "./frames.js";
import { SENTENCES } from "./sentences.js";
import { byteCount, hexOf, latinOf, portableValue, sameBytes, sentence } from "./texts.js";

/**
 * Where the bytes of the parts are in a frame: from `start` on, `width` bytes or characters for each. `escape` is that
 * of the bytes, if they have one. In a frame with escapes, `originals` are the bytes before they were escaped, and `places` the offsets after `start` of what is sent
 * for them, and of the end. `gap` is the place of the first byte after an escape of nothing, which is sent between that
 * byte and the one before.
 */
export class Spot {
  constructor(frame, start, width, places = null, originals = null, escape = null, gap = null) {
    Object.assign(this, { frame, start, width, places, originals, escape, gap });
  }

  /** Where the byte `at` of the parts is in a CAN frame; empty in any other frame, and where it cannot be read. */
  canPlace(at) {
    if (this.escape?.method !== "can" || !this.places) return "";
    const size = identifierSize(this.escape);
    if (at < size) return "identifier";
    return isRemoteRequest(this.frame.subarray(this.start), this.escape.remote ?? -1) ? "DLC" : String(at - size);
  }

  /** `byte 4` of the frame, or `byte 2 of the data` of a CAN frame, for a byte of the parts. */
  byteText(at) {
    if (this.escape?.method !== "can") return `byte ${this.place(at, 0).offset}`;
    return `byte ${at - identifierSize(this.escape)} of the data`;
  }

  /**
   * The offset and the length in the frame of `length` bytes of the parts from `at` on, their characters, and where they
   * are in a CAN frame.
   */
  place(at, length) {
    if (this.places) {
      const end = this.places.length - 1;
      const first = this.places[Math.min(at, end)];
      const after = length && at + length === this.gap ? this.gap : this.places[Math.min(at + length, end)];
      const offset = this.start + first;
      const sent = this.frame.subarray(offset, offset + after - first);
      const isSame = sameBytes(sent, this.originals.subarray(at, at + length));
      return { offset, length: sent.length, characters: isSame ? "" : hexOf(sent, " "), canPlace: this.canPlace(at) };
    }
    const offset = this.start + at * this.width;
    const size = length * this.width;
    const characters = this.width > 1 ? latinOf(this.frame.subarray(offset, offset + size)) : "";
    return { offset, length: size, characters };
  }
}

/** The characters of the bytes of a row, or the identifier of a CAN frame as tools for CAN buses write it: `123`. */
export function sentText({ canPlace, characters }) {
  if (canPlace !== "identifier" || !characters) return characters;
  const number = parseInt(characters.replaceAll(" ", "").slice(0, 8), 16);
  const isLong = number >= 2 ** 31;
  return (number % 2 ** 30).toString(16).toUpperCase().padStart(isLong ? 8 : 3, "0");
}

/** Where the bytes of a row begin, as people count: in a CAN frame from the first byte of the data. */
export function placeOf({ canPlace, offset }) {
  return canPlace || String(offset);
}

/** `speed at byte 4`; in a CAN frame `speed at byte 2 of the data` or `node in the identifier`; without its path elsewhere. */
export function placeText({ canPlace, offset, path }) {
  const byte = ["identifier", "DLC"].includes(canPlace) ? `the ${canPlace}` : canPlace ? `byte ${canPlace} of the data` : `byte ${offset}`;
  return path ? `${path} ${canPlace === "identifier" ? "in" : "at"} ${byte}` : byte;
}

/** A row of an explanation: some bytes of a frame and their meaning. */
export function rowOf(more) {
  return {
    kind: "", offset: 0, length: 0, raw: new Uint8Array(), characters: "", canPlace: "", path: "", fact: "",
    printedName: "", label: "", doc: "", number: null, value: "", meanings: [], verdict: "", reason: "", source: "", notes: [], errata: [],
    address: null, words: 0, unit: "word", access: "", ...more,
  };
}

/** The row of a fact whose bytes are at `at` in the parts. A fact without sources has those of `outer`. */
export function factRow(device, kind, path, fact, spot, at, raw, read, outer) {
  return rowOf({
    kind,
    ...spot.place(at, raw.length),
    raw,
    path,
    fact: fact.path,
    printedName: fact.printed ?? "",
    label: fact.label ?? "",
    doc: fact.doc ?? "",
    number: read.number,
    value: read.text,
    meanings: read.meanings,
    verdict: read.verdict,
    reason: read.reason,
    source: fact.source || outer.source || "",
    notes: [...(fact.notes ?? []), ...read.notes],
    errata: [...new Set([...device.errataAt(fact.path), ...device.errataOfWords(read.facts)])],
  });
}

/** The row of bytes that no fact describes, or of a place where bytes are missing. */
export function wrongRow(spot, at, raw, reason, detail, path = "", fact = "") {
  return rowOf({ kind: "unexplained", ...spot.place(at, raw.length), raw, path, fact, verdict: sentence(SENTENCES.WRONG, { fault: detail }), reason });
}

/** The row of bytes after the end. */
export function surplusRow(spot, at, raw) {
  return wrongRow(spot, at, raw, "wrong_length", sentence(SENTENCES.TOO_MANY, { bytes: byteCount(raw.length) }));
}

/** The rows of the preamble and of the start delimiter, if the link has them. */
export function startRows(parts) {
  const { link: { preamble }, lead, start } = parts;
  const rows = preamble ? markRows(parts, "preamble", 0, start.subarray(0, lead), new Uint8Array(lead).fill(preamble.byte)) : [];
  return [...rows, ...markRows(parts, "start", lead, start.subarray(lead), parts.marks[0])];
}

/** The rows of surplus characters, and of the end delimiter, if the link has one. */
export function endRows(parts) {
  const at = parts.frame.length - parts.end.length;
  const rows = markRows(parts, "end", at, parts.end, parts.marks[1]);
  if (!parts.surplus.length) return rows;
  const text = parts.reason === "not_hex" ? SENTENCES.NOT_PAIRS : SENTENCES.CHARACTER_TOO_MANY;
  const surplus = {
    kind: "unexplained",
    offset: at - parts.surplus.length,
    length: parts.surplus.length,
    raw: parts.surplus,
    characters: latinOf(parts.surplus),
    verdict: sentence(SENTENCES.WRONG, { fault: text }),
    reason: parts.reason,
  };
  return [rowOf(surplus), ...rows];
}

/**
 * The row of bytes of an escape that stand for no bytes, as the code of COBS before no data, at `at` in the parts.
 * `raw` are the bytes that are sent.
 */
export function escapeRow(spot, { path, source = "" }, at, raw) {
  return rowOf({
    kind: "mark", offset: spot.start + at, length: raw.length, raw, path: "escape", fact: path, verdict: "right", source,
  });
}

function markRows({ link }, name, offset, raw, should) {
  if (!should.length) return [];
  const right = sameBytes(raw, should);
  return [rowOf({
    kind: "mark",
    offset,
    length: raw.length,
    raw,
    characters: link.transmission === "hex_ascii" ? latinOf(raw) : "",
    path: name,
    fact: link.path,
    verdict: right ? "right" : sentence(SENTENCES.SHOULD_BE, { expected: hexOf(should, " ") }),
    reason: right ? "" : "wrong_mark",
    source: link.source ?? "",
  })];
}

/** Data with null for empty texts. */
const emptied = (data) => Object.fromEntries(Object.entries(data).map(([key, value]) => [key, value === "" ? null : value]));

/** A row as data: what is empty is null, bytes are hexadecimal digits. */
export function rowData({ raw, number, meanings, canPlace, printedName, words, unit, ...row }) {
  return {
    ...emptied({ ...row, can_place: canPlace, printed_name: printedName }),
    raw: hexOf(raw),
    number: portableValue(number),
    meanings: meanings.map(emptied),
    [unit === "byte" ? "size" : `${unit || "word"}s`]: words || null,
  };
}
