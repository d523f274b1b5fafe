import { BIT, optionText, packedSize } from "./layouts.js";
import { SENTENCES } from "./sentences.js";
import { boundsText, sizeText } from "./frame_sizes.js";
import { closest, lengths, recognised } from "./recognition.js";
import { examplesOfBytes } from "./device.js";
import { explained } from "./explanation.js";
import { faultOf } from "./values.js";
import { py } from "./python.js";

/** Chooses what a frame is, its link, direction and message, and says how certain that is. */

export const DIRECTIONS = ["request", "response"];

/** The options of the user about frames. `places` are links and directions; an empty option leaves all open. */
export class FrameOptions {
  constructor({ places = [], message = "" }) {
    this.places = places;
    this.message = message;
  }

  /** Whether a reading agrees with the options. */
  allows(reading) {
    const [link, direction, message, ] = reading;
    return this.goes(link, direction) && (!this.message || this.message === message);
  }

  /** Whether the options allow a direction on a link. */
  goes(link, direction) {
    return !py.truth(this.places) || py.has(this.places, [link, direction]);
  }

  /** The directions that the options allow. */
  get directions() {
    return py.truth(this.places) ? py.frozenset([...this.places].map(([, direction]) => direction)) : py.frozenset(DIRECTIONS);
  }
}

/** The request that the next response answers. `sure` if the user has named it. */
export class OpenRequest {
  constructor({ request, sure }) {
    this.request = request;
    this.sure = sure;
  }
}

/**
 * The explanation of a frame under the chosen reading.
 *
 * `readings` are all readings that fit, none if the frame is wrong under all of them. `chosen` says why this reading
 * is explained: it is the `only` one that fits; the `request` before it or a `mark` in the log decided between
 * several; nothing did, and it is the `likeliest`; none fits, and it is the `closest`.
 * `mismatches` say where a response does not fit its request.
 */
export class ChosenReading {
  constructor({ explanation, readings, chosen, mismatches = [] }) {
    this.explanation = explanation;
    this.readings = readings;
    this.chosen = chosen;
    this.mismatches = mismatches;
  }

  /** Whether a codec refuses the frame, or a response does not fit its request. */
  get wrong() {
    return py.truth(py.either(this.explanation.reasons, () => this.mismatches)) || !py.truth(this.readings);
  }

  /** The other readings that fit. */
  get alternatives() {
    const own = readingOf(this.explanation);
    return [...this.readings].filter((reading) => !py.equal(reading, own));
  }
}

/** The explanation of a frame. `mark` is the direction that a log tells, which may be wrong. */
export function readFrame(layout, frame, options, mark = "", openRequest = null) {
  const answer = (openRequest != null && py.has(options.directions, "response")) ? readingsAnswer(layout, frame, openRequest) : null;
  if (openRequest != null && answer != null && (openRequest.sure || (mark !== "request" && !answer.wrong))) {
    return answer;
  }
  const examples = readingsExamples(layout, frame);
  const readings = [...recognised(layout, frame)].map((reading) => readingsNamedByExample(reading, examples));
  const namedReadings = [...readings].map((reading) => readingsNamedByOption(layout, frame, reading, options));
  let fitting = [...namedReadings].filter((reading) => options.allows(reading));
  if (!py.truth(fitting)) {
    const closestReading = readingsClosest(layout, frame, options, mark);
    const isAnswer = mark === "response" && closestReading.explanation.direction !== mark;
    return (answer != null && isAnswer) ? answer : closestReading;
  }
  fitting = py.sorted(fitting, (reading) => readingsDoubts(layout, reading, mark, examples));
  const marked = [...fitting].filter((reading) => reading[1] === mark);
  const chosen = fitting.length === 1 ? "only" : marked.length === 1 ? "mark" : "likeliest";
  const mismatches = (answer != null && chosen !== "likeliest") ? readingsUnrepeated(answer, fitting[0]) : [];
  return new ChosenReading({
    explanation: readingsExplained(layout, frame, fitting[0]),
    readings: py.tuple(fitting),
    chosen,
    mismatches,
  });
}

/**
 * The parts of the request before it that a response does not repeat, unless the response clearly answers another
 * request.
 */
function readingsUnrepeated(answer, reading) {
  if (py.truth(answer.explanation.reasons) || !py.equal(readingOf(answer.explanation), reading)) {
    return [];
  }
  const only = [...answer.mismatches].every((text) => py.has(text, SENTENCES.NOT_REPEATED));
  return only ? answer.mismatches : [];
}

/** The readings of the examples that have exactly these bytes. */
function readingsExamples(layout, frame) {
  return [...examplesOfBytes(layout.device, frame)].filter((example) => py.equal(example.frame, frame)).map((example) => [example.link, example.direction, example.message, example.exceptionResponse]);
}

/** A reading, with the message of an example where it is an exception response to one of several messages. */
function readingsNamedByExample(reading, examples) {
  const [link, direction, message, error] = reading;
  if (py.truth(message) || !py.truth(error)) {
    return reading;
  }
  return py.next([...examples].filter((other) => py.equal(py.slice(other, undefined, 2), [link, direction]) && py.truth(other[3])), reading);
}

/** A reading, with the message of the options if it is an exception response that does not say what it answers. */
function readingsNamedByOption(layout, frame, reading, options) {
  const [link, direction, message, error] = reading;
  if (py.truth(message) || !py.truth(error) || !options.message) {
    return reading;
  }
  const optionReading = readingOf(explained(layout, link, direction, frame, options.message));
  return (optionReading[2] === options.message && py.truth(optionReading[3])) ? optionReading : reading;
}

/** The reading of an explanation. */
export function readingOf(explanation) {
  return [explanation.link, explanation.direction, explanation.message, explanation.error];
}

function readingsExplained(layout, frame, reading) {
  const [link, direction, message, ] = reading;
  return explained(layout, link, direction, frame, message);
}

/**
 * The doubts about a reading, the gravest first.
 *
 * These are the mark in the log, that no example is such a frame, that the message is a guess, and that its length may
 * be any.
 */
function readingsDoubts(layout, reading, mark, examples) {
  const [link, direction, message, error] = reading;
  const guessed = !py.truth(error) && py.item(layout.links, link).isGuessed(direction, message);
  const loose = guessed && py.truth(message) && py.item(layout.messages, message).data(direction).size == null;
  return [py.truth(mark) && direction !== mark, !py.has(examples, reading), guessed, loose];
}

/** The reading with the fewest faults. */
function readingsClosest(layout, frame, options, mark) {
  let reading;
  const namedReadings = [...closest(layout, frame)].map((reading) => readingsNamedByOption(layout, frame, reading, options));
  let candidates = [...namedReadings].filter((reading) => options.allows(reading));
  if (!py.truth(candidates)) {
    const places = [...layout.links].flatMap((link) => [...DIRECTIONS].filter((direction) => options.goes(link, direction)).map((direction) => [link, direction]));
    const carrying = [...places].filter(([link, direction]) => py.has(py.item(layout.links, link).carried(direction), options.message));
    const sending = py.either(carrying, () => [...places].filter(([link, direction]) => py.truth(py.item(layout.links, link).carried(direction))));
    candidates = [...py.either(sending, () => places)].map(([link, direction]) => [link, direction, options.message, false]);
  }
  const examples = readingsExamples(layout, frame);
  reading = py.min(candidates, (own) => readingsFaults(layout, frame, own, readingsDoubts(layout, own, mark, examples)));
  return new ChosenReading({
    explanation: readingsExplained(layout, frame, reading),
    readings: [],
    chosen: "closest",
  });
}

/** What makes a reading of a wrong frame less close than others. */
function readingsFaults(layout, frame, reading, doubts) {
  const reasons = readingsExplained(layout, frame, reading).reasons;
  return [py.sum([...reasons].map((reason) => py.has(["wrong_mark", "not_hex"], reason))), doubts, reasons.length];
}

/** The explanation of a frame as the response to a request. */
function readingsAnswer(layout, frame, openRequest) {
  const request = openRequest.request;
  const response = explained(layout, request.link, "response", frame, request.message, request.frame);
  const mismatches = py.tuple(readingsMismatches(layout, request, response));
  return new ChosenReading({
    explanation: response,
    readings: py.truth(response.reasons) ? [] : [readingOf(response)],
    chosen: py.truth(response.reasons) ? "closest" : "request",
    mismatches,
  });
}

/** The places where a response does not fit its request. */
function* readingsMismatches(layout, request, response) {
  let actual, expected;
  for (const role of ["unit_address", "code"]) {
    const ours = py.item(layout.links, request.link).request.role(role);
    const theirs = py.item(layout.links, request.link).response.role(role);
    expected = py.truth(ours) ? request.values.get(ours.name) : null;
    actual = py.truth(theirs) ? response.values.get(theirs.name) : null;
    if (role === "code" && readingsHasCodeOfItsOwn(layout, response)) {
      continue;
    }
    const announced = layout.messages.get(request.message);
    if (role === "code" && announced != null && announced.message.hasResponseCode) {
      expected = announced.message.codeOf("response");
      if (py.truth(theirs) && py.isWhole(actual) && !py.equal(actual, expected)) {
        yield py.format(SENTENCES.ANOTHER_CODE, {
          name: theirs.name,
          actual: theirs.numberText(actual),
          expected: theirs.numberText(expected),
          message: request.message,
        });
      }
      continue;
    }
    if (py.truth(ours) && py.isWhole(expected) && py.isWhole(actual) && !py.equal(actual, expected)) {
      yield py.format(SENTENCES.ANOTHER_NUMBER, { name: ours.name, actual, expected });
    }
  }
  for (const row of response.rows) {
    if (py.startswith(row.verdict, "wrong") && !row.reason) {
      yield py.format(SENTENCES.PART_NOT_REPEATED, { path: row.path, fault: faultOf(row.verdict) });
    }
  }
  const message = layout.messages.get(response.message);
  const access = (py.truth(message) && !response.error) ? message.message.singleAccess : null;
  if (access != null && access.operation === "read") {
    const unit = layout.device.space(access.space).unit;
    expected = py.truth(access.count) ? request.values.get(access.count) : unit === BIT ? null : 1;
    actual = response.values.get(access.values);
    if (py.isWhole(expected) && py.isList(actual)) {
      const size = unit === BIT ? packedSize(expected) : expected;
      if (actual.length !== size) {
        const sentence = unit === BIT ? SENTENCES.ASKED_BITS : SENTENCES.ASKED_VALUES;
        yield py.format(sentence, { expected, unit, size, actual: actual.length });
      }
    }
  }
}

/** Whether a response is an exception response whose code is not that of its request. */
function readingsHasCodeOfItsOwn(layout, response) {
  const refusal = py.item(layout.links, response.link).link.exceptionResponse;
  return response.error && refusal != null && refusal.code != null;
}

const READINGS_NAMED = 3;

/** The remarks on a frame. `asked_in` is the line of the request before it, 0 if there is none. */
export function* remarksOn(layout, chosen, askedIn, options) {
  if (chosen.chosen === "closest") {
    yield py.format(SENTENCES.CLOSEST, { device: layout.device.id });
    yield* readingsOfOtherLength(layout, chosen, options);
  } else if (askedIn && chosen.explanation.direction === "response" && !readingsIsUnrequested(layout, chosen)) {
    const answers = chosen.chosen === "request" ? SENTENCES.ANSWERS : SENTENCES.DOES_NOT_ANSWER;
    yield py.format(answers, { line: askedIn });
  }
  if (chosen.chosen === "likeliest") {
    yield readingsAmbiguous(layout, chosen);
  }
  yield* chosen.mismatches;
}

/** Whether a frame is one that the device sends of its own accord, so that it answers nothing. */
function readingsIsUnrequested(layout, chosen) {
  const announced = layout.messages.get(chosen.explanation.message);
  return announced != null && !announced.message.isRequested;
}

/** Whether frames of a link carry the code of their message. */
function readingsCoded(layout, link) {
  return [...DIRECTIONS].some((direction) => py.item(layout.links, link).frame(direction).role("code") != null);
}

/** The remark that other readings fit, and which options tell them apart. */
function readingsAmbiguous(layout, chosen) {
  let names;
  const own = chosen.explanation;
  const readings = [readingOf(own), ...(chosen.alternatives ?? [])];
  const options = readingsOptions(layout, own, chosen.alternatives);
  if ([...readings].every(([link, , , ]) => !readingsCoded(layout, link))) {
    const texts = [...readings].map(([link, direction, name, ]) => readingsMessageText(py.item(layout.links, link).link, direction, name));
    names = readingsEnumeration(texts, "or");
    return py.format(SENTENCES.AMBIGUOUS_SIZE, { count: own.frame.length, names, options });
  }
  const namesOf = py.dict([]);
  for (const [link, direction, message, error] of chosen.alternatives) {
    namesOf.setdefault([link, direction, error], []).push(py.either(message, () => SENTENCES.UNKNOWN_MESSAGE));
  }
  const alternativesText = py.join(" or ", [...namesOf.entries()].map(([[link, direction, error], names]) => readingsReadingsText(layout, own, link, direction, error, names)));
  const ownNames = [own.message || SENTENCES.UNKNOWN_MESSAGE];
  const explained = readingsReadingsText(layout, own, own.link, own.direction, own.error, ownNames);
  return py.format(SENTENCES.AMBIGUOUS, { explained, others: alternativesText, options });
}

/** The options that tell the readings apart: those that are each enough, else all that help. */
function readingsOptions(layout, own, alternatives) {
  const links = [own.link, ...[...alternatives].map(([link, , , ]) => link)];
  const words = py.list(py.dict([...links].map((link) => py.item(layout.links, link).link.messageName).map((key) => [key, null])));
  const byMessage = [...alternatives].map(([, , message, ]) => message !== own.message);
  const telling = py.dict([["request", (own.direction === "response" && readingsAsks(layout, own.link)) ? byMessage : [false]], ["link", [...alternatives].map(([link, , , ]) => !py.equal(link, own.link))], ["direction", [...alternatives].map(([, direction, , ]) => direction !== own.direction)], [words.length === 1 ? words[0] : "message", byMessage]]);
  const enough = [...telling.entries()].filter(([option, tells]) => py.all(tells)).map(([option, tells]) => optionText(option));
  if (py.truth(enough)) {
    return py.format(SENTENCES.OPTION_TELLS, { options: py.join(" or ", enough) });
  }
  const helpful = [...telling.entries()].filter(([option, tells]) => py.any(tells)).map(([option, tells]) => optionText(option));
  return py.format(SENTENCES.OPTIONS_TELL, { options: py.join(" and ", helpful) });
}

/** Whether the request identifies the message of a response on a link. */
function readingsAsks(layout, link) {
  return py.item(layout.links, link).request.role("code") != null;
}

/** Readings in words: `the response to stop on rtu`, `a response to one of 28 messages (stop, move, homing, ..)`. */
function readingsReadingsText(layout, own, link, direction, error, messages) {
  const isSingle = messages.length === 1;
  const name = py.item(layout.links, link).link.directionName(direction);
  let sentence = isSingle ? SENTENCES.READING : SENTENCES.READINGS;
  if (!py.has(DIRECTIONS, name) && !error) {
    sentence = isSingle ? SENTENCES.NAMED_MESSAGE : SENTENCES.NAMED_MESSAGES;
  }
  let kind = error ? "exception response" : direction;
  let joint = kind !== "response" ? "of" : "to";
  if (kind === "response" && [...messages].every((message) => !py.item(layout.messages, message).message.isRequested)) {
    [kind, joint] = ["frame", "of"];
  }
  return py.format(sentence, {
    message: messages[0],
    count: messages.length,
    names: py.join(", ", messages.length <= READINGS_NAMED ? messages : [...py.slice(messages, undefined, READINGS_NAMED), ".."]),
    direction: name,
    place: link === own.link ? "" : py.format(SENTENCES.ON_LINK, { link }),
    kind,
    joint,
  });
}

/** A message with its direction, as remarks name it: `telegram_3 sent` */
function readingsMessageText(link, direction, message) {
  return py.format(SENTENCES.NAMED_MESSAGE, { message, direction: link.directionName(direction), place: "" });
}

/** `a, b or c` */
function readingsEnumeration(names, last) {
  return names.length > 1 ? `${py.join(", ", py.slice(names, undefined, -1))} ${last} ${names.at(-1)}` : names[0];
}

/** The lengths of the messages, if only the length could identify the message, and it matches none. */
function* readingsOfOtherLength(layout, chosen, options) {
  const own = chosen.explanation;
  const link = py.item(layout.links, own.link);
  const isOfLength = [...own.reasons].some((reason) => py.has(["wrong_length", "incomplete", "unknown_code"], reason));
  if (readingsCoded(layout, own.link) || !isOfLength) {
    return;
  }
  const known = py.dict([...DIRECTIONS].map((direction) => [direction, link.carried(direction)]));
  const names = py.list(py.dict([...py.item(known, "request"), ...py.item(known, "response")].map((key) => [key, null])));
  const ways = [...DIRECTIONS].filter((direction) => options.goes(own.link, direction));
  const escape = link.link.isCan ? link.link.escape : null;
  const identifier = escape == null ? 0 : escape.fieldsSize;
  const sizes = [...py.has(names, options.message) ? [options.message] : names].flatMap((name) => [...ways].filter((direction) => py.has(py.item(known, direction), name)).map((direction) => py.format(SENTENCES.SIZE_OF_MESSAGE, {
    message: readingsMessageText(link.link, direction, name),
    size: boundsText(...lengths(link, direction, name), identifier),
  })));
  if (py.truth(sizes)) {
    yield py.format(SENTENCES.SIZES, { own: sizeText(link, own), others: py.join(", ", sizes) });
  }
}
