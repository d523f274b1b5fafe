import { OpenRequest } from "./readings.js";
import { repeatedParts } from "./links.js";
import { py } from "./python.js";

/** The requests of a log that may still be answered. */

/** The requests without an answer that are remembered. */
const OPEN_REQUESTS_MOST_OPEN = 64;

/**
 * Reads each frame of a log as the answer to a request before it, if it is one.
 *
 * `asked` is the request that the user names for all responses. `open` are the requests that may still be answered,
 * each with its line, the newest last: one for each of the values that responses repeat. `read` reads a frame as the
 * answer to a request.
 */
export class OpenRequests {
  constructor(layout, namedRequest, read) {
    [this.layout, this.asked, this.read] = [layout, namedRequest, read];
    this.open = [];
    this.repeated = py.dict([...layout.links.entries()].map(([name, link]) => [name, repeatedParts(link)]));
  }

  /** The reading of a frame, and the line of the request before it that counts; 0 where there is none. */
  reading(frame) {
    if (this.asked != null || !py.truth(this.open)) {
      return [this.read(frame, this.asked), 0];
    }
    let nearest = null;
    for (const [openRequest, line] of py.reversed(this.open)) {
      const own = [this.read(frame, openRequest), line];
      if (own[0].chosen === "request") {
        return own;
      }
      if (nearest == null || (py.truth(own[0].mismatches) && !py.truth(nearest[0].mismatches))) {
        nearest = own;
      }
    }
    return nearest;
  }

  /** Keeps the requests that may still be answered after a frame of a line. */
  remember(reading, line) {
    if (this.asked == null) {
      this._close(reading.explanation);
      const request = this._request(reading);
      this.open = request != null ? [...py.slice(this.open, 1 - OPEN_REQUESTS_MOST_OPEN), [request, line]] : this.open;
    }
  }

  /** Closes the requests that a frame answers, or leaves without an answer. */
  _close(frame) {
    const message = this.layout.messages.get(frame.message);
    if (message != null && !message.message.isRequested) {
      return;
    }
    const own = this._numbers(frame);
    this.open = [...this.open].filter((other) => !py.has(own, null) && py.equal(other[0].request.link, frame.link) && !py.equal(this._numbers(other[0].request), own));
  }

  /** What responses repeat of their requests, in a request or in a response; None where a frame lacks it. */
  _numbers(frame) {
    const pairs = py.item(this.repeated, frame.link);
    return [...pairs].map(([requestPart, answer]) => frame.values.get((frame.direction === "request" ? requestPart : answer).name));
  }

  /** The frame as the request that the next response answers; None for messages without a response. */
  _request(reading) {
    const request = reading.explanation;
    const isUnknown = request.reasons.length === 1 && request.reasons[0] === "unknown_code";
    if (request.direction !== "request" || (reading.wrong && !isUnknown)) {
      return null;
    }
    const link = py.item(this.layout.links, request.link);
    if (py.has(link.messages, request.message) && !py.has(link.carried("response"), request.message)) {
      return null;
    }
    if (reading.chosen === "likeliest" && link.response.role("code") == null && link.request.role("code") == null) {
      return null;
    }
    const [unitAddress, addresses] = [link.request.role("unit_address"), link.link.unitAddresses];
    if (py.truth(unitAddress) && py.truth(addresses) && py.equal(request.values.get(unitAddress.name), addresses.broadcast)) {
      return null;
    }
    return new OpenRequest({ request, sure: false });
  }
}
