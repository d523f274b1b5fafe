import { ExplainedDevice } from "./device.js";
import { explanationData } from "./explanation.js";
import { DIRECTIONS, FrameOptions, readFrame, remarksOn } from "./readings.js";
import { logLine, Unreadable } from "./lines.js";
import { linesOf, LogReader } from "./log.js";
import { SENTENCES } from "./sentences.js";

/** The options of frames by the names that a device uses. Throws RangeError for names that it does not have. */
export function frameOptions(device, { link, direction, message } = {}) {
  if (!link && !direction && !message) return new FrameOptions({});
  let links = [...device.links.values()];
  if (link) links = links.filter(({ name }) => name === link);
  if (!links.length) throw new RangeError(`${link} is not a link of ${device.data.device}: ${[...device.links.keys()].join(", ")}`);
  if (message) {
    const others = links;
    links = links.filter(({ carriedMessages }) => DIRECTIONS.some((way) => carriedMessages[way].has(message)));
    if (!links.length) throw new RangeError(`${message} is not sent on ${others.map(({ name }) => name).join(" or ")}`);
  }
  const places = links.flatMap(({ name, directionNames }) => DIRECTIONS
    .filter((way) => !direction || directionNames[way] === direction || (way === direction && !isName(directionNames, direction)))
    .map((way) => [name, way]));
  if (!places.length) throw new RangeError(`${direction} is not a direction of ${links.map(({ name }) => name).join(" or ")}`);
  return new FrameOptions({ places, message: message ?? "" });
}

function isName(directionNames, direction) {
  return Object.values(directionNames).includes(direction);
}

/** The frame of bytes or of a text. Throws Unreadable. */
function inputFrame(device, input) {
  if (input instanceof Uint8Array) return { frame: input, direction: "", remarks: [] };
  const line = logLine(String(input), device.links.values());
  if (!line?.frame.length) throw new Unreadable(SENTENCES.NO_BYTES);
  return line;
}

/**
 * The request that a user names, null without one. Throws Unreadable for a text that is not a frame, and RangeError for a
 * frame that is not a request.
 */
export function namedRequest(device, input, options) {
  if (!input) return null;
  const places = [...device.links.keys()].map((link) => [link, "request"]).filter(([link]) => options.goes(link, "response"));
  const request = readFrame(device, inputFrame(device, input).frame, new FrameOptions({ places, message: options.message }));
  const faults = request.explanation.reasons;
  if (request.wrong && (faults.length !== 1 || faults[0] !== "unknown_code")) {
    throw new RangeError(`request is not a valid request of ${device.data.device}: ${faults.join(", ")}`);
  }
  return { request: request.explanation, sure: true };
}

/** The functions that explain frames of a device, whose data they take. */
export function explainer(data) {
  const device = new ExplainedDevice(data);

  /**
   * The explanation of a frame: bytes, or a text with its bytes in any usual spelling. Throws Unreadable for a text that
   * is not a frame, and RangeError for options that the device does not have; no bytes make it throw.
   */
  function explain(input, options = {}) {
    const allowed = frameOptions(device, options);
    const asked = namedRequest(device, options.request, allowed);
    const line = inputFrame(device, input);
    const reading = readFrame(device, line.frame, allowed, line.direction, asked);
    const remarks = [...line.remarks, ...remarksOn(device, reading, 0, allowed)];
    return explanationData(device, reading.explanation, reading.readings, reading.chosen, remarks, reading.wrong);
  }

  /** The explanations of the lines of a log; `error` says why a line is not a frame. Throws like `explain` for options. */
  function* explainLog(text, options = {}) {
    const allowed = frameOptions(device, options);
    const reader = new LogReader(device, allowed, namedRequest(device, options.request, allowed));
    for (const line of linesOf(text.replace(/^\ufeff/, ""))) {
      try {
        const reading = reader.read(line);
        if (reading) {
          const { explanation, readings, chosen, remarks, wrong } = reading;
          yield { line: reader.number, ...explanationData(device, explanation, readings, chosen, remarks, wrong) };
        }
      } catch (error) {
        if (!(error instanceof Unreadable)) throw error;
        yield { line: reader.number, error: error.message };
      }
    }
  }

  return Object.freeze({ explain, explainLog });
}
