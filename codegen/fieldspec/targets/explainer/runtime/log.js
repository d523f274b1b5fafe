import { Unreadable, logLine } from "./lines.js";
import { FrameOptions, isWrong, readFrame, remarksOn } from "./readings.js";
import { reasonsOf } from "./explanation.js";
import { SENTENCES } from "./sentences.js";
import { sentence } from "./texts.js";

/** The characters of a line from which on it is too long for a frame. */
export const LONGEST_LINE = 8192;

/** The lines of a text, with their ends. */
export function linesOf(text) {
  return text.match(/[^\n]*\n|[^\n]+$/g) ?? [];
}

/** The requests without an answer that are remembered. */
const MOST_OPEN = 64;

/**
 * Explains the lines of a log, one after the other. A response is read as the answer to a request before it; `asked` is
 * a request that the user names, which every line answers. `open` are the requests that may still be answered, the
 * newest last: one for each of the values that responses repeat. `mark` is the direction that a line without bytes
 * announces for the next one.
 */
export class LogReader {
  constructor(device, options = new FrameOptions(), asked = null) {
    Object.assign(this, { device, options, asked, open: [], mark: "", number: 0 });
    this.links = [...device.links.values()];
  }

  /**
   * The reading of the next line, with its number, its remarks, and the request that it answers; null for a blank line,
   * a comment, and a line that only announces the next one. Throws Unreadable for a line without a frame.
   */
  read(text) {
    this.number += 1;
    if (text.length >= LONGEST_LINE) throw new Unreadable(sentence(SENTENCES.TOO_LONG, { count: LONGEST_LINE }));
    const line = logLine(text.replaceAll("\0", ""), this.links);
    if (!line) return null;
    this.mark = line.direction || this.mark;
    if (!line.frame.length) return null;
    const { reading, asked } = this.readingOf(line.frame);
    const remarks = [...line.remarks, ...remarksOn(this.device, reading, asked?.line ?? 0, this.options)];
    this.mark = "";
    if (!this.asked) {
      this.close(reading.explanation);
      const request = this.requestOf(reading);
      if (request) this.open = [...this.open.slice(1 - MOST_OPEN), { request, sure: false, line: this.number }];
    }
    const request = asked && (reading.chosen === "request" || asked.sure) ? asked.request : null;
    return { ...reading, line: this.number, remarks, request, wrong: isWrong(reading) };
  }

  /** The reading of a frame, and the request before it that counts; null where there is none. */
  readingOf(frame) {
    const readAs = (asked) => ({ reading: readFrame(this.device, frame, this.options, this.mark, asked), asked });
    if (this.asked || !this.open.length) return readAs(this.asked);
    let nearest = null;
    for (const asked of this.open.toReversed()) {
      const own = readAs(asked);
      if (own.reading.chosen === "request") return own;
      if (!nearest || (own.reading.mismatches.length && !nearest.reading.mismatches.length)) nearest = own;
    }
    return nearest;
  }

  /** Closes the requests that a frame answers, or leaves without an answer. */
  close(frame) {
    if (this.device.messages.get(frame.message)?.unrequested) return; // the device sends it of its own accord
    const own = this.numbersOf(frame);
    const differs = (numbers) => numbers.some((number, at) => number !== own[at]);
    this.open = this.open.filter(
      ({ request }) => !own.includes(undefined) && request.link === frame.link && differs(this.numbersOf(request)),
    );
  }

  /** What responses repeat of their requests, in a request or in a response; undefined where a frame lacks it. */
  numbersOf({ link, direction, values }) {
    return this.device.links.get(link).repeated.map(([asked, answer]) => values.get(direction === "request" ? asked : answer));
  }

  /** The frame as the request that the next response answers; null for what nobody answers. */
  requestOf(reading) {
    const request = reading.explanation;
    const faults = reasonsOf(request);
    const isUnknown = faults.length === 1 && faults[0] === "unknown_code";
    if (request.direction !== "request" || (isWrong(reading) && !isUnknown)) return null;
    const link = this.device.links.get(request.link);
    if (link.carriedMessages.request.has(request.message) && !link.carriedMessages.response.has(request.message)) return null;
    // Without codes, nothing shows that it is a request.
    if (reading.chosen === "likeliest" && !link.response.code && !link.request.code) return null;
    const { unitAddress } = link.request;
    const { broadcast } = link.addresses ?? {};
    if (unitAddress && broadcast !== undefined && request.values.get(unitAddress.name) == broadcast) return null;
    return request;
  }
}
