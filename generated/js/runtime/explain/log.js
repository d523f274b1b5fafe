import { Unreadable, logLine } from "./lines.js";
import { FrameOptions, readFrame, remarksOn } from "./readings.js";
import { OpenRequests } from "./open_requests.js";
import { SENTENCES } from "./sentences.js";
import { sentence } from "./texts.js";

/** The characters of a line from which on it is too long for a frame. */
export const LONGEST_LINE = 8192;

/** The lines of a text, with their ends. */
export function linesOf(text) {
  return text.match(/[^\n]*\n|[^\n]+$/g) ?? [];
}

/**
 * Explains the lines of a log, one after the other; `asked` is a request that the user names, which every line answers.
 * `mark` is the direction that a line without bytes announces for the next one.
 */
export class LogReader {
  constructor(device, options = new FrameOptions({}), asked = null) {
    Object.assign(this, { device, options, asked, mark: "", number: 0 });
    this.links = device.links.values();
    this.requests = new OpenRequests(device, asked, (frame, request) => readFrame(device, frame, options, this.mark, request));
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
    const [reading, askedIn] = this.requests.reading(line.frame);
    const remarks = [...line.remarks, ...remarksOn(this.device, reading, askedIn, this.options)];
    const open = this.requests.open.find(([, own]) => own === askedIn)?.[0];
    const request = this.asked?.request ?? (reading.chosen === "request" ? open.request : null);
    this.mark = "";
    this.requests.remember(reading, this.number);
    return { explanation: reading.explanation, readings: reading.readings, chosen: reading.chosen, remarks, request, wrong: reading.wrong };
  }
}
