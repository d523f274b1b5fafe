import { explained } from "./explanation.js";
import { isDamaged } from "./frame_rows.js";
import { unwrapped } from "./row.js";
import { py } from "./python.js";

/** Recognises what a frame may be: its link, direction and message, by the faults that each reading of it has. */

const RECOGNITION_OF_VALUES = ["unknown_value", "wrong_const", "wrong_measure"];

const RECOGNITION_GUESSED = "guessed";

const RECOGNITION_FITTING = [py.frozenset([RECOGNITION_GUESSED]), py.frozenset([...RECOGNITION_OF_VALUES, RECOGNITION_GUESSED])];

const RECOGNITION_CLOSE = [...RECOGNITION_FITTING, py.frozenset([...RECOGNITION_OF_VALUES, "wrong_checksum", RECOGNITION_GUESSED]), py.frozenset([...RECOGNITION_OF_VALUES, "wrong_checksum", "wrong_length", "incomplete"])];

/**
 * The readings of a frame that fit, in the order of the spec.
 *
 * Their delimiters, length, checksum and length of the body are right. Readings with values that a codec refuses
 * are returned only if every reading has some. The message is empty for an exception response to a code that the
 * device does not have.
 */
export function recognised(layout, frame) {
  return recognitionReadings(layout, frame, RECOGNITION_FITTING);
}

/** The readings of a frame without faults, else those with a wrong checksum, else those with a wrong length too. */
export function closest(layout, frame) {
  return recognitionReadings(layout, frame, RECOGNITION_CLOSE);
}

function recognitionReadings(layout, frame, steps) {
  let reasons;
  const reasonsOf = py.dict([]);
  for (const link of layout.links.values()) {
    for (const direction of ["request", "response"]) {
      if (steps === RECOGNITION_FITTING && isDamaged(layout, link.name, direction, frame)) {
        continue;
      }
      let names = steps === RECOGNITION_FITTING ? recognitionOfLength(link, direction, frame) : py.list(link.carried(direction));
      if (link.frame(direction).role("code") != null) {
        const ambiguous = link.ambiguousCodes(direction).values();
        const shared = [...ambiguous].flatMap((messages) => [...messages].map((message) => message.name));
        names = ["", ...[...shared].filter((name) => py.has(names, name))];
      } else if (direction === "response" && link.hasUncodedExceptions) {
        names.push("");
      }
      for (const message of names) {
        const explanation = explained(layout, link.name, direction, frame, message);
        if (py.truth(message) && explanation.error) {
          continue;
        }
        reasons = py.frozenset(py.truth(message) ? [...(explanation.reasons ?? []), RECOGNITION_GUESSED] : explanation.reasons);
        reasonsOf.setdefault([link.name, direction, explanation.message, explanation.error], reasons);
      }
    }
  }
  for (const accepted of steps) {
    const fitting = [...reasonsOf.entries()].filter(([reading, reasons]) => py.issubset(reasons, accepted) && (py.truth(reading[2]) || py.truth(reading[3]))).map(([reading, reasons]) => reading);
    if (py.truth(fitting)) {
      return fitting;
    }
  }
  return [];
}

/** The messages whose body can be as long as that of the frame. */
function recognitionOfLength(link, direction, frame) {
  const length = unwrapped(link.link, direction, frame).data.length;
  const bounds = sentLengths(link, direction);
  return [...bounds].filter(([name, minimum, maximum]) => minimum <= length && (maximum == null || length <= maximum)).map(([name, minimum, maximum]) => name);
}

/** The messages of a direction, with the least and the most bytes between delimiters; None is unbounded. */
export function* sentLengths(link, direction) {
  const escape = link.frame(direction).escape;
  for (const name of link.carried(direction)) {
    let [minimum, maximum] = lengths(link, direction, name);
    if (escape != null) {
      [minimum, maximum] = [0, maximum == null ? null : escape.most(maximum)];
    }
    yield [name, minimum, maximum];
  }
}

/** The least and the greatest size of a message's frames without delimiters, in bytes; None is unbounded. */
export function lengths(link, direction, message) {
  const [shape, body] = [link.frame(direction), py.item(link.messages, message).data(direction)];
  const partsSize = shape.headerSize + shape.trailerSize;
  return [body.least + partsSize, body.most == null ? null : body.most + partsSize];
}
