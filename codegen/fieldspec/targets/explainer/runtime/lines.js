import { canBytes } from "../escapes.js";
import { SENTENCES } from "./sentences.js";
import { bytesOfHex, sentence } from "./texts.js";

// Patterns of bytes in a text, in the spellings of terminals, sniffers and programming languages.
const EACH_ENCLOSED = /^(?:(?:\[[0-9A-Fa-f]{2}\]\s*)+|(?:<[0-9A-Fa-f]{2}>\s*)+)$/;
const QUOTED = /^(?:b?(["'])(.*)\1[,;]?|\[(.*)\]|\{(.*)\}|\((.*)\))$/s;
const SEPARATOR = /[\s,;:+_|-]+|(?<=[0-9A-Fa-f])(?=\\x)/;
const PIECE = /^(?:(?:0x|\\x|16#|&h|\$)?(?<digits>[0-9a-f]+)|(?<suffixed>[0-9a-f]+)h)$/i;
const LAST = /(?:\\x(?<code>[0-9a-f]{2})|[<[]?(?<name>crlf|cr|lf|\\r|\\n)[>\]]?|(?<real>[\r\n]))$/i;
const CHARACTERS = { "\\r": "\r", "\\n": "\n", cr: "\r", lf: "\n", crlf: "\r\n" };
const CONTROLS = { 0x02: "STX", 0x03: "ETX", 0x0a: "LF", 0x0d: "CR" };

// Times, words and marks such as `RX:`, `Tx`, `>` or `<-` may come before the bytes, and a comment after them.
const DIRECTION_OF = new Map(Object.entries(SENTENCES.DIRECTION_WORDS).flatMap(([direction, words]) => words.map((word) => [word, direction])));
const MOST_MARKS = 8;  // each is tried, and a line of a log has few
const LETTER = "[\\p{L}\\p{N}_]";
const MARK = new RegExp(
  `(?<!${LETTER}|\\.)(?<word>${[...DIRECTION_OF.keys()].join("|")})(?!${LETTER}|\\.)(?:\\s*[\\[(][^\\])]{0,40}[\\])])?(?:\\s*[:=](?=\\s|${LETTER}|$))?`
  + `|(?:^|(?<=[\\s\\]]))(?<arrow>[\\-=]{0,2}>{1,3}|<{1,3}[\\-=]{0,2})(?=[\\s:\\[]|${LETTER}|$)(?![0-9A-Fa-f]{2}>)`,
  "giu",
);
const COMMENT = /(?:^|(?<=\s))(?:#|\/\/).*/s;
const CLOCK = "(?:[01]?\\d|2[0-3]):[0-5]\\d:[0-5]\\d(?:[.,]\\d{1,9}|:\\d{3,6})?Z?";
const DATE = "(?:\\d{4}[-/.]\\d{1,2}[-/.]\\d{1,2}|\\d{1,2}[-/.]\\d{1,2}[-/.]\\d{4})";
const TIME = `(?:${DATE}T${CLOCK}|${DATE}|${CLOCK}|[-+]?\\d+\\.\\d+(?:s|ms|us)?)[,;]?(?=\\s)`;
const ENCLOSED = "\\[[^\\]]{0,80}\\]|\\([^)]{0,80}\\)";
const BEFORE = new RegExp(
  `^(?:[\\s,;|=-]+|${TIME}|\\d{4,}[-:](?=[0-9A-Fa-f]{2}\\b)|0000[0-9A-Fa-f]{4}:?\\s+(?=[0-9A-Fa-f]{2}\\b)|(?:${ENCLOSED}|[^\\s:]+:)(?=\\s))`,
);
const CANDUMP = new RegExp(
  "(?:^|\\s)(?<identifier>[0-7][0-9A-Fa-f]{2}|[01][0-9A-Fa-f]{7})"
  + "(?:#(?:(?<remote>R)(?<dlc>[0-8])?|(?<data>(?:[0-9A-Fa-f]{2}){0,8}))(?:\\s+[RT])?"
  + "|\\s+\\[(?<count>[0-8])\\](?:(?<words>\\s+remote request)|(?<bytes>(?:\\s+[0-9A-Fa-f]{2}){0,8})))\\s*$",
);
// A byte with a letter that looks like a digit.
const MISTYPED = /^(?:[0-9][OoIl]|[OoIl][0-9])$/;
const BEHIND = new RegExp(`\\s(?:${ENCLOSED}|\\|.{0,80}\\|)$`);

/** A text that is not bytes. The message says why; `isEmpty` if there is nothing in it that may be bytes. */
export class Unreadable extends Error {
  constructor(message, isEmpty = false) {
    super(message);
    this.name = "Unreadable";
    this.isEmpty = isEmpty;
  }
}

/** Whether every byte has its own brackets. */
function isEachEnclosed(text) {
  return EACH_ENCLOSED.test(text.trim());
}

/** A text without the quotes, brackets or braces around it. Brackets around each byte stay. */
function unquoted(text) {
  const match = isEachEnclosed(text) ? null : QUOTED.exec(text.trim());
  return match ? match.slice(2).find((inner) => inner !== undefined) : text;
}

/** Whether a word can be read as bytes. */
function isHexWord(word) {
  const pieces = word.split(SEPARATOR).filter(Boolean);
  return pieces.length > 0 && pieces.every((piece) => PIECE.test(piece));
}

/** The bytes of a text. Throws Unreadable. */
export function bytesOfText(text) {
  let inner = unquoted(text);
  if (isEachEnclosed(inner)) inner = inner.replace(/[[\]<>]+/g, " ");
  let digits = "";
  const pieces = inner.split(SEPARATOR).filter(Boolean);
  // Programs that print a byte as one digit where they can print no other byte as 0 and a digit.
  const isPadded = pieces.some((piece) => /^0[0-9A-Fa-f]/.test(piece));
  for (const piece of pieces) {
    const match = PIECE.exec(piece);
    if (!match) throw new Unreadable(sentence(SENTENCES.NOT_A_BYTE, { piece }));
    const own = match.groups.digits || match.groups.suffixed;
    if (own.length % 2 && own.length > 1) throw new Unreadable(sentence(SENTENCES.ODD_DIGITS, { piece }));
    if (piece.length === 1 && isPadded) throw new Unreadable(sentence(SENTENCES.SINGLE_DIGIT, { offset: digits.length / 2, piece }));
    digits += own.padStart(2, "0");
  }
  if (!digits) throw new Unreadable(SENTENCES.NO_BYTES);
  return bytesOfHex(digits);
}

/**
 * A frame that the text shows as characters, with a remark on what is missing at its end. Null if the text does not
 * begin like a frame of one of the links that send characters.
 */
function inCharacters(text, links) {
  const inner = unquoted(text).trimStart();
  for (const link of links) {
    for (const [direction, mark] of Object.entries(link.openings ?? {})) {
      if (!inner.startsWith(mark)) continue;
      const [, close] = link.delimiters[direction];
      const [text, end] = ended(inner);
      const body = link.transmission === "hex_ascii" ? text.replace(/\s+/gu, "") : text;
      const bytes = Array.from(body, (char) => (char.codePointAt(0) > 255 ? 0x3f : char.charCodeAt(0)));
      return withEnd(bytes, Array.from(end, (char) => char.charCodeAt(0)), [...close]);
    }
  }
  return null;
}

/** The text without the control characters at its end, which may be spelled as words, and these characters. */
function ended(text) {
  let rest = text;
  let end = "";
  for (;;) {
    const trimmed = rest.replace(/[ \t]+$/, "");
    const match = LAST.exec(trimmed.slice(-8));
    if (!match) return [rest, end];
    const { code, name, real } = match.groups;
    rest = trimmed.slice(0, trimmed.length - match[0].length);
    end = (code ? String.fromCharCode(parseInt(code, 16)) : real || CHARACTERS[name.toLowerCase()]) + end;
  }
}

/** A frame with its whole end delimiter, and a remark if the text has only a part of the delimiter. */
function withEnd(body, end, mark) {
  const endsWith = (bytes, last) => last.every((byte, at) => bytes[bytes.length - last.length + at] === byte);
  let size = mark.length;
  while (!endsWith(body, mark.slice(0, size))) size--;
  const rest = mark.slice(size);
  if (endsWith(end, rest)) return { frame: Uint8Array.from([...body, ...rest]), remarks: [] };
  if (!end.every((byte, at) => rest[at] === byte)) return { frame: Uint8Array.from([...body, ...end]), remarks: [] };
  const lacking = rest.slice(end.length).map((byte) => CONTROLS[byte] ?? byte.toString(16).toUpperCase().padStart(2, "0"));
  const remark = sentence(SENTENCES.END_ASSUMED, { characters: lacking.join(" ") });
  return { frame: Uint8Array.from([...body, ...rest]), remarks: [remark] };
}

/** The frame in a line of candump, `605#4041`, `605#R8`, or `605 [2] 40 41`; null for any other text. */
function canFrameOf(text) {
  const match = CANDUMP.exec(text);
  if (!match) return null;
  const { identifier, count, dlc, remote, words } = match.groups;
  const data = bytesOfHex((match.groups.data ?? match.groups.bytes ?? "").replace(/\s+/g, ""));
  const isRemote = Boolean(remote ?? words);
  const size = Number(dlc ?? count ?? data.length);
  if (!isRemote && size !== data.length) return null;
  return canBytes({ identifier: parseInt(identifier, 16), data, isExtended: identifier.length > 3, isRemote, dlc: size });
}

/**
 * The frame in a line of a log: its bytes, empty if the line only announces the next one; the direction of the mark in
 * the line, or empty; remarks on what is missing. Null for a blank line or a comment. Throws Unreadable.
 */
export function logLine(text, links) {
  if (/^(?:[ \t\n\r\f\v]*[0-9a-f]{2})+[ \t\n\r\f\v]*$/i.test(text)) {
    return { frame: bytesOfHex(text.replace(/\s+/g, "")), direction: "", remarks: [] };
  }
  const frame = links.some(({ request }) => request.escape?.method === "can") ? canFrameOf(text) : null;
  if (frame) return { frame, direction: "", remarks: [] };
  let line = text.endsWith("\n") && !text.endsWith("\r\n") ? text.slice(0, -1) : text;
  line = line.replace(COMMENT, "");
  if (!line.trim()) return null;
  const marks = [];
  for (const match of line.matchAll(MARK)) {
    marks.push(match);
    if (marks.length === MOST_MARKS) break;
  }
  for (let number = marks.length - 1; number >= 0; number--) {
    const mark = marks[number];
    try {
      const read = frameBehind(line.slice(mark.index + mark[0].length), links);
      return { ...read, direction: directionOf(line, marks.slice(0, number + 1), links) };
    } catch (error) {
      if (!(error instanceof Unreadable)) throw error;
    }
  }
  try {
    return unmarked(line, links);
  } catch (error) {
    const direction = error instanceof Unreadable && error.isEmpty ? directionOf(line, marks, links) : "";
    if (!direction) throw error;
    return { frame: new Uint8Array(), direction, remarks: [] };
  }
}

/**
 * The direction that marks tell; empty if they tell none. Words count more than arrows, and an arrow after a name tells
 * nothing, as it may point either way. A word that a link uses for the other direction tells nothing either: the log may
 * take either side's view.
 */
function directionOf(text, marks, links) {
  const words = marks.map(({ groups }) => groups.word?.toLowerCase()).filter(Boolean);
  if (words.length) {
    const word = words.at(-1);
    const direction = DIRECTION_OF.get(word);
    const other = direction === "request" ? "response" : "request";
    return links.some((link) => link.directionNames[other] === word) ? "" : direction;
  }
  const last = marks.at(-1);
  if (!last || /[A-Za-z]/.test(text.slice(0, last.index).replace(new RegExp(TIME, "g"), ""))) return "";
  return last.groups.arrow.includes(">") ? "request" : "response";
}

/** The frame of a line without marks; brackets around each byte tell its direction. */
function unmarked(text, links) {
  const read = frameBehind(text, links);
  const start = text.trim()[0];
  const enclosed = text.split(start).length - 1 === read.frame.length;
  return { ...read, direction: (enclosed && { "[": "request", "<": "response" }[start]) || "" };
}

/** The frame after times, labels and words, and remarks on what the text lacks of it. */
function frameBehind(text, links) {
  let rest = text.replace(/^[ \t]+/, "");
  while (rest) {
    const frame = inCharacters(rest, links);
    if (frame) return frame;
    if (isEachEnclosed(rest) || unquoted(rest) !== rest) return { frame: bytesOfText(rest), remarks: [] };
    const before = BEFORE.exec(rest);
    const word = /^\S+/.exec(rest);
    if (before) rest = rest.slice(before[0].length);
    else if (word && MISTYPED.test(word[0])) throw new Unreadable(sentence(SENTENCES.NOT_A_BYTE, { piece: word[0] }));
    else if (word && !isHexWord(word[0])) rest = rest.slice(word[0].length);
    else return { frame: bytesOfText(rest.trimEnd().replace(BEHIND, "")), remarks: [] };
  }
  throw new Unreadable(SENTENCES.NO_BYTES, true);
}
