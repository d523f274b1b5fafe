import { Unreadable, logLine } from "./lines.js";
import { FrameOptions, isWrong, readFrame, remarksOn } from "./readings.js";
import { reasonsOf } from "./explanation.js";

/** The characters of a line from which on it is too long for a frame. */
export const LONGEST_LINE = 8192;

/** The lines of a text, with their ends. */
export function linesOf(text) {
  return text.match(/[^\n]*\n|[^\n]+$/g) ?? [];
}

/**
 * Explains the lines of a log, one after the other. A response is read as the answer to the request before it; `asked`
 * is a request that the user names, which every line answers.
 */
export class LogReader {
  constructor(device, options = new FrameOptions(), asked = null) {
    Object.assign(this, { device, options, asked, askedIn: 0, mark: "", number: 0 });
    this.links = [...device.links.values()];
  }

  /**
   * The reading of the next line, with its number, its remarks, and the request that it answers; null for a blank line,
   * a comment, and a line that only announces the next one. Throws Unreadable for a line without a frame.
   */
  read(text) {
    this.number += 1;
    if (text.length >= LONGEST_LINE) throw new Unreadable(`it has ${LONGEST_LINE} characters or more`);
    const line = logLine(text.replaceAll("\0", ""), this.links);
    if (!line) return null;
    this.mark = line.direction || this.mark;
    if (!line.frame.length) return null;
    const { asked, askedIn } = this;
    const reading = readFrame(this.device, line.frame, this.options, this.mark, asked);
    const remarks = [...line.remarks, ...remarksOn(this.device, reading, askedIn, this.options)];
    this.mark = "";
    if (!asked?.sure) {
      this.asked = this.requestOf(reading);
      this.askedIn = this.asked ? this.number : 0;
    }
    const request = reading.chosen === "request" || asked?.sure ? asked.request : null;
    return { ...reading, line: this.number, remarks, request, wrong: isWrong(reading) };
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
    if (unitAddress && broadcast !== undefined && request.values.get(unitAddress.name) === broadcast) return null;
    return { request, sure: false };
  }
}
