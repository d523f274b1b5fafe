import { codeIn, isAmbiguous, partNumberText } from "./device.js";
import { isWhole } from "./numbers.js";
import { SENTENCES } from "./sentences.js";
import { byteCount, enumeration, hexOf, sentence } from "./texts.js";
import { explained, namesOfLength, reasonsOf } from "./explanation.js";
import { faultOf } from "./values.js";

export const DIRECTIONS = ["request", "response"];

const OF_VALUES = ["unknown_value", "wrong_const", "wrong_measure"];
// The frame carries no code, so its message is a guess. That is not a fault, but a broken frame needs better evidence.
const GUESSED = "guessed";
// The faults that a reading may have. The readings of the first step that any of them passes are the result.
const FITTING = [[GUESSED], [...OF_VALUES, GUESSED]].map((reasons) => new Set(reasons));
const CLOSE = [
  ...FITTING,
  new Set([...OF_VALUES, "wrong_checksum", GUESSED]),
  new Set([...OF_VALUES, "wrong_checksum", "wrong_length", "incomplete"]),
];

/**
 * The readings of a frame that fit, in the order of the spec: link, direction, message, and whether it is an exception
 * response. With `close`, else those with a wrong checksum, else those with a wrong length too.
 */
export function readingsOf(device, frame, close = false) {
  const faults = new Map();
  for (const link of device.links.values()) {
    for (const direction of DIRECTIONS) {
      for (const message of candidatesOf(link, direction, frame, close)) {
        const explanation = explained(device, link.name, direction, frame, message);
        const reading = readingOf(explanation);
        const key = JSON.stringify(reading);
        if (faults.has(key) || (message && explanation.error)) continue;
        faults.set(key, { reading, reasons: [...reasonsOf(explanation), ...(message ? [GUESSED] : [])] });
      }
    }
  }
  for (const accepted of close ? CLOSE : FITTING) {
    const fitting = [...faults.values()]
      .filter(({ reading, reasons }) => reasons.every((reason) => accepted.has(reason)) && (reading[2] || reading[3]));
    if (fitting.length) return fitting.map(({ reading }) => reading);
  }
  return [];
}

/** The names of the messages that a frame may be; the empty one leaves it to the code in the frame. */
function candidatesOf(link, direction, frame, close) {
  const coded = Boolean(link[direction].code);
  if (coded && (direction === "request" || !link.ambiguous)) return [""];
  const names = close ? [...link.carriedMessages[direction].keys()] : namesOfLength(link, direction, frame);
  // An exception response says what it is, and not which message it answers.
  if (!coded) return direction === "response" && link.exception ? [...names, ""] : names;
  const several = link.ambiguous.flatMap((code) => link.messagesByCode[direction].get(code).map(({ name }) => name));
  return ["", ...several.filter((name) => names.includes(name))];
}

/** Whether a frame does not tell that it is one of a message: it carries no code, or an ambiguous one. */
function isGuessed(device, link, direction, message) {
  return !link[direction].code || isAmbiguous(link, direction, codeIn(direction, device.messages.get(message)));
}

/** The reading of an explanation. */
export function readingOf({ link, direction, message, error }) {
  return [link, direction, message, error];
}

function explainedReading(device, frame, [link, direction, message]) {
  return explained(device, link, direction, frame, message);
}

/** What the user says about the frames: `places` are links and directions; what is empty is open. */
export class FrameOptions {
  constructor(places = [], message = "") {
    Object.assign(this, { places, message });
  }

  allows([link, direction, message]) {
    return this.goes(link, direction) && (!this.message || this.message === message);
  }

  goes(link, direction) {
    return !this.places.length || this.places.some(([other, way]) => other === link && way === direction);
  }

  allowsDirection(direction) {
    return !this.places.length || this.places.some(([, way]) => way === direction);
  }
}

/**
 * The explanation of a frame under the reading that is chosen, and all readings that fit. `mark` is the direction that
 * a log tells, which may be wrong. `asked` has the explanation of the request that a response answers, and is `sure` if
 * the user has named it. `chosen` says why: it is the `only` one that fits; the `request` before it or a `mark` decided
 * between several; nothing did, and it is the `likeliest`; none fits, and it is the `closest`.
 */
export function readFrame(device, frame, options, mark = "", asked = null) {
  const answer = asked && options.allowsDirection("response") ? answerOf(device, frame, asked.request) : null;
  if (answer) {
    if (asked.sure || (mark !== "request" && !isWrong(answer))) return answer;
  }
  const fitting = readingsOf(device, frame)
    .map((reading) => namedByExample(reading, exampleReadings(device, frame)))
    .map((reading) => namedByOption(device, frame, reading, options))
    .filter((reading) => options.allows(reading));
  if (!fitting.length) {
    const near = closestReading(device, frame, options, mark);
    // What a log marks as a response, and what is near a request only, is a wrong answer to the request before it.
    return answer && mark === "response" && near.explanation.direction !== mark ? answer : near;
  }
  const examples = exampleKeys(device, frame);
  const doubts = new Map(fitting.map((reading) => [reading, doubtsOf(device, reading, mark, examples)]));
  fitting.sort((left, right) => comparedLists(doubts.get(left), doubts.get(right)));
  const marked = fitting.filter(([, direction]) => direction === mark);
  const chosen = fitting.length === 1 ? "only" : marked.length === 1 ? "mark" : "likeliest";
  const mismatches = answer && chosen !== "likeliest" ? unrepeated(answer, fitting[0]) : [];
  return { explanation: explainedReading(device, frame, fitting[0]), readings: fitting, chosen, mismatches };
}

/** What a response does not repeat of the request before it, where nothing else shows that it answers another. */
function unrepeated({ explanation, mismatches }, reading) {
  const own = readingOf(explanation);
  if (reasonsOf(explanation).length || reading.some((value, at) => value !== own[at])) return [];
  return mismatches.every((text) => text.includes(SENTENCES.NOT_REPEATED)) ? mismatches : [];
}

/** Whether a codec refuses the frame, or a response does not fit its request. */
export function isWrong({ explanation, readings, mismatches }) {
  return Boolean(reasonsOf(explanation).length || mismatches.length || !readings.length);
}

/** The readings of the examples that have exactly these bytes. */
function exampleReadings(device, frame) {
  return device.readingsOf.get(hexOf(frame)) ?? [];
}

function exampleKeys(device, frame) {
  return new Set(exampleReadings(device, frame).map((reading) => JSON.stringify(reading)));
}

/** A reading, with the message of an example where it is an exception response to one of several messages. */
function namedByExample(reading, examples) {
  const [link, direction, message, error] = reading;
  if (message || !error) return reading;
  const example = examples.find(([ownLink, way, , isError]) => ownLink === link && way === direction && isError);
  return example ?? reading;
}

/** A reading, with the message of the options where it is an exception response that does not say what it answers. */
function namedByOption(device, frame, reading, options) {
  const [link, direction, message, error] = reading;
  if (message || !error || !options.message) return reading;
  const named = readingOf(explained(device, link, direction, frame, options.message));
  return named[2] === options.message && named[3] ? named : reading;
}

/**
 * What speaks against a reading, the gravest first: the mark in the log, that no example is such a frame, that the
 * message is a guess, and that its length may be any.
 */
function doubtsOf(device, reading, mark, examples) {
  const [link, direction, message, error] = reading;
  const guessed = !error && isGuessed(device, device.links.get(link), direction, message);
  const loose = guessed && Boolean(message) && device.messages.get(message)[direction].size === undefined;
  return [mark !== "" && direction !== mark, !examples.has(JSON.stringify(reading)), guessed, loose].map(Number);
}

function comparedLists(left, right) {
  const at = left.findIndex((number, place) => number !== right[place]);
  return at < 0 ? 0 : left[at] - right[at];
}

/** The reading with the fewest faults. */
function closestReading(device, frame, options, mark) {
  let near = readingsOf(device, frame, true)
    .map((reading) => namedByOption(device, frame, reading, options))
    .filter((reading) => options.allows(reading));
  if (!near.length) {
    const places = [...device.links.keys()].flatMap((link) => DIRECTIONS.map((direction) => [link, direction]))
      .filter(([link, direction]) => options.goes(link, direction));
    const carrying = places.filter(([link, direction]) => device.links.get(link).carriedMessages[direction].has(options.message));
    // Nobody sends a request on a link whose messages come from the device alone.
    const sending = places.filter(([link, direction]) => device.links.get(link).carriedMessages[direction].size);
    near = [carrying, sending, places].find((some) => some.length).map((place) => [...place, options.message, false]);
  }
  const examples = exampleKeys(device, frame);
  const faultsOf = (reading) => {
    const reasons = reasonsOf(explainedReading(device, frame, reading));
    const marks = reasons.filter((reason) => reason === "wrong_mark" || reason === "not_hex").length;
    return [marks, ...doubtsOf(device, reading, mark, examples), reasons.length];
  };
  const ranked = near.map((reading) => ({ reading, faults: faultsOf(reading) }));
  ranked.sort((left, right) => comparedLists(left.faults, right.faults));
  return { explanation: explainedReading(device, frame, ranked[0].reading), readings: [], chosen: "closest", mismatches: [] };
}

/** The explanation of a frame as the response to a request. */
function answerOf(device, frame, request) {
  const response = explained(device, request.link, "response", frame, request.message, request);
  const fits = !reasonsOf(response).length;
  return {
    explanation: response,
    readings: fits ? [readingOf(response)] : [],
    chosen: fits ? "request" : "closest",
    mismatches: mismatchesOf(device, request, response),
  };
}

/** The places where a response does not fit its request. */
function mismatchesOf(device, request, response) {
  const link = device.links.get(request.link);
  const texts = [];
  for (const role of ["unitAddress", "code"]) {
    const [ours, theirs] = [link.request[role], link.response[role]];
    const want = ours && request.values.get(ours.name);
    const have = theirs && response.values.get(theirs.name);
    // A code of its own marks the exception responses to all requests.
    if (role === "code" && response.error && link.exception?.code !== undefined) continue;
    const { responseCode } = device.messages.get(request.message) ?? {};
    if (role === "code" && responseCode !== undefined) {
      if (isWhole(have ?? "") && have != responseCode) {
        const [actual, expected] = [have, responseCode].map((number) => partNumberText(theirs, number));
        texts.push(sentence(SENTENCES.ANOTHER_CODE, { name: theirs.name, actual, expected, message: request.message }));
      }
    } else if (isWhole(want ?? "") && isWhole(have ?? "") && have != want) {
      texts.push(sentence(SENTENCES.ANOTHER_NUMBER, { name: ours.name, actual: have, expected: want }));
    }
  }
  for (const row of response.rows) {
    if (row.verdict.startsWith("wrong") && !row.reason) {
      texts.push(sentence(SENTENCES.PART_NOT_REPEATED, { path: row.path, fault: faultOf(row.verdict) }));
    }
  }
  const message = response.error ? undefined : device.messages.get(response.message);
  const { operation, count, values, unit = "word" } = message?.access ?? {};
  if (operation === "read" && (count || unit !== "bit")) {
    const want = count ? request.values.get(count) : 1;
    const have = response.values.get(values);
    const size = unit === "bit" && isWhole(want ?? "") ? Math.ceil(Number(want) / 8) : want;
    if (isWhole(want ?? "") && Array.isArray(have) && have.length != size) {
      const fault = unit === "bit" ? SENTENCES.ASKED_BITS : SENTENCES.ASKED_VALUES;
      texts.push(sentence(fault, { expected: want, unit, size, actual: have.length }));
    }
  }
  return texts;
}

const NAMED = 3;

/** The remarks on a frame. `askedIn` is the line of the request before it, 0 if there is none. */
export function remarksOn(device, chosen, askedIn, options) {
  const texts = [];
  if (chosen.chosen === "closest") {
    texts.push(sentence(SENTENCES.CLOSEST, device.data));
    texts.push(...otherLengths(device, chosen, options));
  } else if (askedIn && chosen.explanation.direction === "response" && !isUnrequested(device, chosen)) {
    texts.push(sentence(chosen.chosen === "request" ? SENTENCES.ANSWERS : SENTENCES.DOES_NOT_ANSWER, { line: askedIn }));
  }
  if (chosen.chosen === "likeliest") texts.push(ambiguityText(device, chosen));
  return [...texts, ...chosen.mismatches];
}

/** Whether a frame is one that the device sends of its own accord, so that it answers nothing. */
function isUnrequested(device, chosen) {
  return Boolean(device.messages.get(chosen.explanation.message)?.unrequested);
}

/** Whether frames of a link carry the code of their message. */
function isCoded(link) {
  return DIRECTIONS.some((direction) => link[direction].code);
}

/** The remark that other readings fit, and what tells them apart. */
function ambiguityText(device, chosen) {
  const own = chosen.explanation;
  const ownKey = JSON.stringify(readingOf(own));
  const alternatives = chosen.readings.filter((reading) => JSON.stringify(reading) !== ownKey);
  const readings = [readingOf(own), ...alternatives];
  const options = optionsText(device, own, alternatives);
  if (readings.every(([link]) => !isCoded(device.links.get(link)))) {
    const names = readings.map(([link, direction, message]) => messageText(device.links.get(link), direction, message));
    return sentence(SENTENCES.AMBIGUOUS_SIZE, { count: own.frame.length, names: enumeration(names, "or"), options });
  }
  const groups = new Map();
  for (const [link, direction, message, error] of alternatives) {
    const key = JSON.stringify([link, direction, error]);
    if (!groups.has(key)) groups.set(key, { link, direction, error, names: [] });
    groups.get(key).names.push(message || SENTENCES.UNKNOWN_MESSAGE);
  }
  const others = [...groups.values()].map(({ link, direction, error, names }) => namedReading(device, own, link, direction, error, names));
  const explained = namedReading(device, own, own.link, own.direction, own.error, [own.message || SENTENCES.UNKNOWN_MESSAGE]);
  return sentence(SENTENCES.AMBIGUOUS, { explained, others: others.join(" or "), options });
}

/** The options that tell the readings apart: those that are each enough, else all that help. */
function optionsText(device, own, alternatives) {
  const words = new Set([own.link, ...alternatives.map(([link]) => link)].map((link) => device.links.get(link).messageName));
  const word = words.size === 1 ? [...words][0].replaceAll("_", "-") : "message";
  const link = device.links.get(own.link);
  let telling = [
    ["link", alternatives.map(([other]) => other !== own.link)],
    ["direction", alternatives.map(([, direction]) => direction !== own.direction)],
    [word, alternatives.map(([, , message]) => message !== own.message)],
  ];
  const byMessage = telling[2][1];
  if (own.direction === "response" && link.request.code && byMessage.some(Boolean)) telling = [["request", byMessage], ...telling];
  const enough = telling.filter(([, tells]) => tells.every(Boolean)).map(([option]) => option);
  if (enough.length) return sentence(SENTENCES.OPTION_TELLS, { options: enough.join(" or ") });
  const helpful = telling.filter(([, tells]) => tells.some(Boolean)).map(([option]) => option);
  return sentence(SENTENCES.OPTIONS_TELL, { options: helpful.join(" and ") });
}

/** Readings in words: `the response to stop on rtu`, `a response to one of 28 messages (stop, move, homing, ..)`. */
function namedReading(device, own, link, direction, error, messages) {
  const isSingle = messages.length === 1;
  const name = device.links.get(link).directionNames[direction];
  const parts = {
    message: messages[0],
    count: messages.length,
    names: (messages.length <= NAMED ? messages : [...messages.slice(0, NAMED), ".."]).join(", "),
    direction: name,
    place: link === own.link ? "" : sentence(SENTENCES.ON_LINK, { link }),
  };
  if (!DIRECTIONS.includes(name) && !error) return sentence(isSingle ? SENTENCES.NAMED_MESSAGE : SENTENCES.NAMED_MESSAGES, parts);
  // What the device sends of its own accord answers nothing.
  const isAnswer = !error && direction === "response" && messages.some((message) => !device.messages.get(message).unrequested);
  const kind = error ? "exception response" : isAnswer || direction === "request" ? direction : "frame";
  const joint = isAnswer ? "to" : "of";
  return sentence(isSingle ? SENTENCES.READING : SENTENCES.READINGS, { kind, joint, ...parts });
}

/** `telegram_3 sent` */
function messageText(link, direction, message) {
  return sentence(SENTENCES.NAMED_MESSAGE, { message, direction: link.directionNames[direction], place: "" });
}

/** The lengths of the messages, if only the length could tell which one the frame is, and it tells none. */
function otherLengths(device, chosen, options) {
  const own = chosen.explanation;
  const link = device.links.get(own.link);
  const ofLength = ["wrong_length", "incomplete", "unknown_code"];
  if (isCoded(link) || !reasonsOf(own).some((reason) => ofLength.includes(reason))) return [];
  const known = link.carriedMessages;
  const all = new Set([...known.request.keys(), ...known.response.keys()]);
  const names = all.has(options.message) ? [options.message] : [...all];
  const ways = DIRECTIONS.filter((direction) => options.goes(own.link, direction));
  const sizes = names.flatMap((name) => ways.filter((direction) => known[direction].has(name)).map((direction) => {
    const [, , , size] = link.lengths[direction].find(([other]) => other === name);
    return sentence(SENTENCES.SIZE_OF_MESSAGE, { message: messageText(link, direction, name), size });
  }));
  return sizes.length ? [sentence(SENTENCES.SIZES, { own: ownSize(link, own), others: sizes.join(", ") })] : [];
}

/** The size of a frame, counted as those of messages are: `without its delimiters, the frame has 4 bytes`. */
function ownSize(link, { direction, frame, rows }) {
  const { escape } = link[direction];
  if (escape?.method === "can") return sentence(SENTENCES.SIZE_OF_DATA, { bytes: byteCount(frame.length - 8) });
  const inner = rows.filter(({ kind }) => kind !== "mark");
  const isHex = link.transmission === "hex_ascii";
  const size = inner.reduce((sum, { length, raw }) => sum + (isHex ? length : raw.length), 0);
  const preamble = link.preamble ? ["preamble"] : [];
  const without = [...preamble, ...(link.delimiters[direction].some((mark) => mark.length) ? ["delimiters"] : []), ...(escape ? ["escapes"] : [])];
  const bytes = byteCount(isHex ? Math.trunc(size / 2) : size);
  return sentence(without.length ? SENTENCES.SIZE_WITHOUT : SENTENCES.SIZE_OF_FRAME, { names: without.join(" and "), bytes });
}
