import { CAN_HEADER } from "./links.js";
import { SENTENCES } from "./sentences.js";
import { byteCount } from "./texts.js";
import { py } from "./python.js";

/** The sizes of frames as people count them: without delimiters, and of a CAN bus only the data. */

/** The size of a frame, counted like the size of a message: `without its delimiters, the frame has 4 bytes`. */
export function sizeText(link, own) {
  if (link.link.isCan) {
    return py.format(SENTENCES.SIZE_OF_DATA, { bytes: byteCount(own.frame.length - CAN_HEADER) });
  }
  const rows = [...own.rows].filter((row) => row.kind !== "mark");
  const isHex = link.link.transmission === "hex_ascii";
  const size = isHex ? Math.floor(py.sum([...rows].map((row) => row.length)) / 2) : py.sum([...rows].map((row) => row.raw.length));
  const names = py.dict([["preamble", link.link.preamble != null], ["delimiters", py.any(link.link.marks(own.direction))], ["escapes", link.frame(own.direction).escape != null]]);
  const without = [...names.entries()].filter(([name, isPresent]) => isPresent).map(([name, isPresent]) => name);
  const sentence = py.truth(without) ? SENTENCES.SIZE_WITHOUT : SENTENCES.SIZE_OF_FRAME;
  return py.format(sentence, { names: py.join(" and ", without), bytes: byteCount(size) });
}

/** `8`, `8 or more` or `8 to 12`: sizes without the bytes of the parts of an identifier. */
export function boundsText(minimum, maximum, identifier) {
  const lowest = minimum - identifier;
  if (maximum == null || py.equal(maximum, minimum)) {
    return maximum == null ? py.format(SENTENCES.OR_MORE, { low: lowest }) : py.str(lowest);
  }
  return py.format(SENTENCES.BOUNDS, { low: lowest, high: maximum - identifier });
}
