import { SENTENCES } from "./sentences.js";
import { canFrameBytes } from "./links.js";
import { py } from "./python.js";

/** Reads frames from text: bytes in any usual spelling, and lines of a sniffer log. */

const LINES_EACH_ENCLOSED = "(?:\\[[0-9A-Fa-f]{2}\\]\\s*)+|(?:<[0-9A-Fa-f]{2}>\\s*)+";

const LINES_QUOTED = "(?s)b?([\"'])(.*)\\1[,;]?|\\[(.*)\\]|\\{(.*)\\}|\\((.*)\\)";

const LINES_SEPARATOR = "[\\s,;:+_|-]+|(?<=[0-9A-Fa-f])(?=\\\\x)";

const LINES_PIECE = "(?i)(?:0x|\\\\x|16#|&h|\\$)?(?P<digits>[0-9a-f]+)|(?P<suffixed>[0-9a-f]+)h";

const LINES_LAST = "(?i)(?:\\\\x(?P<code>[0-9a-f]{2})|[<\\[]?(?P<name>crlf|cr|lf|\\\\r|\\\\n)[>\\]]?|(?P<real>[\\r\\n]))\\Z";

const LINES_CHARACTERS = py.dict([["\\r", "\r"], ["\\n", "\n"], ["cr", "\r"], ["lf", "\n"], ["crlf", "\r\n"]]);

const LINES_CONTROLS = py.dict([[2, "STX"], [3, "ETX"], [10, "LF"], [13, "CR"]]);

/** A text that is not bytes. The message says why. */
export class Unreadable extends RangeError {
  get name() {
    return "Unreadable";
  }
}

/** Whether a word can be read as bytes. */
export function isHexWord(word) {
  const pieces = [...py.re.split(LINES_SEPARATOR, word)].filter((piece) => py.truth(piece));
  return py.truth(pieces) && [...pieces].every((piece) => py.truth(py.re.fullmatch(LINES_PIECE, piece)));
}

/** Whether every byte has its own brackets. */
export function isEachEnclosed(text) {
  return py.re.fullmatch(LINES_EACH_ENCLOSED, py.strip(text)) != null;
}

/** A text without the quotes, brackets or braces around it. Brackets around each byte stay. */
export function unquoted(text) {
  const match = isEachEnclosed(text) ? null : py.re.fullmatch(LINES_QUOTED, py.strip(text));
  return py.truth(match) ? py.next([...py.slice(py.groups(match), 1)].filter((inner) => inner != null)) : text;
}

/** The bytes of a text. Raises Unreadable. */
export function bytesOf(text) {
  let data;
  if (py.truth((data = linesHexBytes(text)))) {
    return data;
  }
  text = unquoted(text);
  if (isEachEnclosed(text)) {
    text = py.re.sub("[\\[\\]<>]+", " ", text);
  }
  data = Uint8Array.of();
  const pieces = [...py.re.split(LINES_SEPARATOR, text)].filter((piece) => py.truth(piece));
  const isPadded = [...pieces].some((piece) => py.truth(py.re.match("0[0-9A-Fa-f]", piece)));
  for (const piece of pieces) {
    const match = py.re.fullmatch(LINES_PIECE, piece);
    if (match == null) {
      throw new Unreadable(py.format(SENTENCES.NOT_A_BYTE, { piece }));
    }
    const digits = py.either(py.item(match, "digits"), () => py.item(match, "suffixed"));
    if (py.truth(digits.length % 2) && digits.length > 1) {
      throw new Unreadable(py.format(SENTENCES.ODD_DIGITS, { piece }));
    }
    if (piece.length === 1 && isPadded) {
      throw new Unreadable(py.format(SENTENCES.SINGLE_DIGIT, { offset: data.length, piece }));
    }
    data = py.joined(data, py.bytesOfHex(py.zfill(digits, 2)));
  }
  if (!py.truth(data)) {
    throw new Unreadable(SENTENCES.NO_BYTES);
  }
  return data;
}

/** The characters with which frames begin: the link, the direction and the characters of each. */
function linesOpenings(links) {
  return [...links].flatMap((link) => [...link.openings.entries()].map(([direction, mark]) => [link, direction, mark]));
}

/**
 * A frame that the text shows as characters, with a remark on what is missing at its end.
 *
 * None if the text does not begin like a frame.
 */
export function inCharacters(text, openings) {
  text = py.lstrip(unquoted(text));
  for (const [link, direction, mark] of openings) {
    if (py.startswith(text, mark)) {
      let [body, ending] = linesEnded(text);
      if (link.transmission === "hex_ascii") {
        body = py.join("", py.split(body));
      }
      const [, end] = link.marks(direction);
      return linesSplitEnd(py.encode(body, "latin-1", "replace"), py.encode(ending, "latin-1"), end);
    }
  }
  return null;
}

/** The text without the control characters at its end, which may be spelled as words, and these characters. */
function linesEnded(text) {
  let match;
  let end = "";
  while (py.truth((match = py.re.search(LINES_LAST, py.slice(py.rstrip(text, " \t"), -8))))) {
    text = py.rstrip(text, " \t");
    text = py.slice(text, undefined, text.length - match[0].length);
    if (py.truth(py.item(match, "code"))) {
      end = py.chr(py.int(py.item(match, "code"), 16)) + end;
    } else {
      end = py.either(py.item(match, "real"), () => py.item(LINES_CHARACTERS, py.item(match, "name").toLowerCase())) + end;
    }
  }
  return [text, end];
}

/** A frame with its whole end delimiter, and a remark if the text has only a part of the delimiter. */
function linesSplitEnd(body, end, mark) {
  const rest = py.next([...py.range(mark.length, -1, -1)].filter((size) => py.endswith(body, py.slice(mark, undefined, size))).map((size) => py.slice(mark, size)));
  if (py.endswith(end, rest)) {
    return [py.joined(body, rest), []];
  }
  if (!py.equal(py.slice(rest, undefined, end.length), end)) {
    return [py.joined(body, end), []];
  }
  const missing = py.join(" ", [...py.slice(rest, end.length)].map((byte) => (LINES_CONTROLS.get(byte) ?? `${py.hexadecimal(byte, "02X")}`)));
  return [py.joined(body, rest), [py.format(SENTENCES.END_ASSUMED, { characters: missing })]];
}

const LINES_DIRECTIONS = py.dict([...SENTENCES.DIRECTION_WORDS].flatMap(([direction, words]) => [...words].map((word) => [word, direction])));

const LINES_MOST_MARKS = 8;

const LINES_MARK = `(?i)(?<![\\w.])(?P<word>${py.join("|", LINES_DIRECTIONS)})(?![\\w.])(?:\\s*[\\[(][^\\])]{0,40}[\\])])?(?:\\s*[:=](?=\\s|\\w|$))?|(?:^|(?<=[\\s\\]]))(?P<arrow>[-=]{0,2}>{1,3}|<{1,3}[-=]{0,2})(?=[\\s:\\w\\[]|$)(?![0-9A-Fa-f]{2}>)`;

const LINES_COMMENT = "(?s)(?:^|(?<=\\s))(?:#|//).*";

const LINES_CLOCK = "(?:[01]?\\d|2[0-3]):[0-5]\\d:[0-5]\\d(?:[.,]\\d{1,9}|:\\d{3,6})?Z?";

const LINES_DATE = "(?:\\d{4}[-/.]\\d{1,2}[-/.]\\d{1,2}|\\d{1,2}[-/.]\\d{1,2}[-/.]\\d{4})";

const LINES_TIME = `(?:${LINES_DATE}T${LINES_CLOCK}|${LINES_DATE}|${LINES_CLOCK}|[-+]?\\d+\\.\\d+(?:s|ms|us)?)[,;]?(?=\\s)`;

const LINES_NUMBER_OF_LINE = "\\d{4,}[-:](?=[0-9A-Fa-f]{2}\\b)";

const LINES_OFFSET_OF_DUMP = "0000[0-9A-Fa-f]{4}:?\\s+(?=[0-9A-Fa-f]{2}\\b)";

const LINES_ENCLOSED = "\\[[^\\]]{0,80}\\]|\\([^)]{0,80}\\)";

const LINES_LABEL = "[^\\s:]+:";

const LINES_BEFORE = `[\\s,;|=-]+|${LINES_TIME}|${LINES_NUMBER_OF_LINE}|${LINES_OFFSET_OF_DUMP}|(?:${LINES_ENCLOSED}|${LINES_LABEL})(?=\\s)`;

const LINES_CANDUMP = "(?:^|\\s)(?P<identifier>[0-7][0-9A-Fa-f]{2}|[01][0-9A-Fa-f]{7})(?:#(?:(?P<remote>R)(?P<dlc>[0-8])?|(?P<data>(?:[0-9A-Fa-f]{2}){0,8}))(?:\\s+[RT])?|\\s+\\[(?P<count>[0-8])\\](?:(?P<words>\\s+remote request)|(?P<bytes>(?:\\s+[0-9A-Fa-f]{2}){0,8})))\\s*$";

/** A byte with a letter that looks like a digit. */
const LINES_MISTYPED = "[0-9][OoIl]|[OoIl][0-9]";

const LINES_BEHIND = `\\s(?:${LINES_ENCLOSED}|\\|.{0,80}\\|)$`;

/**
 * A line of a log. `frame` is empty if the line only announces the next one.
 *
 * `direction` is that of the mark in the line: `request`, `response`, or empty. `remarks` say what is missing.
 */
export class LogLine {
  constructor({ frame, direction = "", remarks = [] }) {
    this.frame = frame;
    this.direction = direction;
    this.remarks = remarks;
  }
}

/** The frame in a line; None for a blank line or a comment. Raises Unreadable. */
export function logLine(text, links) {
  let data, frame, remarks;
  if (py.truth((data = linesHexBytes(text)))) {
    return new LogLine({ frame: data });
  }
  if ([...links].some((link) => link.isCan) && py.truth((data = linesCanFrame(text)))) {
    return new LogLine({ frame: data });
  }
  if (py.endswith(text, "\n") && !py.endswith(text, "\r\n")) {
    text = py.slice(text, undefined, -1);
  }
  text = py.re.sub(LINES_COMMENT, "", text);
  if (!py.strip(text)) {
    return null;
  }
  const marks = py.list(py.islice(py.re.finditer(LINES_MARK, text), LINES_MOST_MARKS));
  for (const number of py.reversed(py.range(marks.length))) {
    try {
      [frame, remarks] = linesFrame(py.slice(text, py.item(marks, number).end()), links);
    } catch (error) {
      if (!(error instanceof Unreadable)) throw error;
      continue;
    }
    return new LogLine({
      frame,
      direction: linesDirection(text, py.slice(marks, undefined, number + 1), links),
      remarks,
    });
  }
  try {
    let direction;
    [frame, direction, remarks] = linesUnmarked(text, links);
    return new LogLine({ frame, direction, remarks });
  } catch (error) {
    if (!(error instanceof LinesNoBytes)) throw error;
    let direction = linesDirection(text, marks, links);
    if (!direction) {
      throw error;
    }
    return new LogLine({ frame: Uint8Array.of(), direction });
  }
}

/** The bytes of a text of only hexadecimal digits; empty for any other text. */
function linesHexBytes(text) {
  try {
    return py.bytesOfHex(text);
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return Uint8Array.of();
  }
}

/** The frame in a line of candump, `605#4041`, `605#R8`, or `605 [2] 40 41`; empty for any other text. */
function linesCanFrame(text) {
  const match = py.re.search(LINES_CANDUMP, text);
  if (match == null) {
    return Uint8Array.of();
  }
  const data = py.bytesOfHex(py.strip(py.either(py.item(match, "data"), () => py.either(py.item(match, "bytes"), () => ""))));
  const isRemote = py.truth(py.either(py.item(match, "remote"), () => py.item(match, "words")));
  const size = py.int(py.either(py.item(match, "dlc"), () => py.either(py.item(match, "count"), () => data.length)));
  if (!isRemote && !py.equal(size, data.length)) {
    return Uint8Array.of();
  }
  return canFrameBytes(py.int(py.item(match, "identifier"), 16), py.item(match, "identifier").length > 3, isRemote, size, data);
}

/** The text has nothing that can be read as bytes. */
class LinesNoBytes extends Unreadable {
  get name() {
    return "NoBytes";
  }
}

/**
 * The direction that marks tell; empty if they tell none.
 *
 * Words count more than arrows, and an arrow after a name is ignored, because it may point either way. A word that a
 * link uses for the other direction is ignored too: the log may take either side's view.
 */
function linesDirection(text, marks, links) {
  const words = [...marks].filter((mark) => py.truth(py.item(mark, "word"))).map((mark) => py.item(mark, "word").toLowerCase());
  if (py.truth(words)) {
    const direction = py.item(LINES_DIRECTIONS, words.at(-1));
    const other = direction === "request" ? "response" : "request";
    return [...links].some((link) => py.equal(link.directionName(other), words.at(-1))) ? "" : direction;
  }
  if (!py.truth(marks) || py.truth(py.re.search("[A-Za-z]", py.re.sub(LINES_TIME, "", py.slice(text, undefined, marks.at(-1).start()))))) {
    return "";
  }
  return py.has(py.item(marks.at(-1), "arrow"), ">") ? "request" : "response";
}

/** The frame of a line without marks; brackets around each byte tell its direction. */
function linesUnmarked(text, links) {
  const [frame, remarks] = linesFrame(text, links);
  const start = py.strip(text)[0];
  const enclosed = py.equal(py.count(text, start), frame.length);
  return [frame, enclosed ? (py.dict([["[", "request"], ["<", "response"]]).get(start) ?? "") : "", remarks];
}

/** The frame after times, labels and words, and remarks on what the text lacks of it. */
function linesFrame(text, links) {
  text = py.lstrip(text, " \t");
  const openings = linesOpenings(links);
  while (text) {
    const frame = inCharacters(text, openings);
    if (frame != null) {
      return frame;
    }
    if (isEachEnclosed(text) || unquoted(text) !== text) {
      return [bytesOf(text), []];
    }
    const before = py.re.match(LINES_BEFORE, text);
    const word = py.re.match("\\S+", text);
    if (before != null) {
      text = py.slice(text, before.end());
    } else if (word != null && py.truth(py.re.fullmatch(LINES_MISTYPED, word[0]))) {
      throw new Unreadable(py.format(SENTENCES.NOT_A_BYTE, { piece: word[0] }));
    } else if (word != null && !isHexWord(word[0])) {
      text = py.slice(text, word.end());
    } else {
      return [bytesOf(py.re.sub(LINES_BEHIND, "", py.rstrip(text))), []];
    }
  }
  throw new LinesNoBytes(SENTENCES.NO_BYTES);
}
