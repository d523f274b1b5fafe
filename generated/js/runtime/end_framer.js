import { begins, find } from "./escapes.js";
import { withoutDelimiters } from "./delimiters.js";
import { CodecError } from "./error.js";
import { Framer, foreign, joined } from "./framer.js";
import { wrongParts } from "./link.js";

/**
 * The framer of frames with an end delimiter which may also occur within them, and whose length nothing else determines.
 * A frame ends with the first end delimiter with which the link decodes it. `decode` is the decoder of the link, and
 * `messages` those to try. `begins` are the possible values of the first bytes after the start delimiter, by their
 * place. A frame whose data the link refuses is a frame too, if all other parts are right. It comes when the line is
 * silent, or when no frame from there on can be longer.
 */
export function endFramer(shape) {
  return new EndFramer(shape);
}

class EndFramer extends Framer {
  constructor(shape) {
    super(shape, null);
    this.examined = 0;
  }

  feed(piece) {
    this.bytes = joined(this.bytes, piece);
    return this.cut(false);
  }

  /** The frames up to the last end delimiter; it drops the other bytes up to there. A frame that has begun may pause. */
  idle() {
    return this.cut(true);
  }

  reset() {
    super.reset();
    this.examined = 0;
  }

  cut(isSilent) {
    const { bytes } = this;
    const { longest, parts } = this.shape;
    const frames = [];
    let at = 0;
    let examined = this.examined;
    this.examined = 0;
    while (at < bytes.length) {
      let stop = 0;
      if (this.mayBegin(at)) {
        stop = this.stop(at, examined, (frame) => this.accepts(frame));
        const isOver = isSilent && find(bytes, at + parts.start.length, parts.end) >= 0;
        if (stop === 0 && bytes.length - at <= longest && !isOver) {
          this.examined = bytes.length - at;
          break;
        }
        stop ||= this.refused(at);
      }
      if (stop > 0) frames.push(bytes.slice(at, stop));
      else this.dropped++;
      at = stop || at + 1;
      examined = 0;
    }
    this.bytes = bytes.slice(at);
    return frames;
  }

  /** Whether a frame may begin at a byte, as far as the bytes are there. */
  mayBegin(at) {
    const { bytes } = this;
    const { start } = this.shape.parts;
    const here = start.slice(0, bytes.length - at);
    const inner = at + start.length;
    return (
      begins(bytes, at, here) &&
      this.shape.begins.every(([place, values]) => inner + place >= bytes.length || values.includes(bytes[inner + place]))
    );
  }

  /**
   * The end of the shortest frame that begins at a byte and fits; 0 for none. No end among `examined` bytes fits, and none
   * after the place `last` counts.
   */
  stop(at, examined, fits, last = this.bytes.length) {
    const { shortest, longest, parts } = this.shape;
    const { end } = parts;
    const limit = Math.min(last, at + longest);
    const first = at + Math.max(shortest, examined + 1) - end.length;
    for (let close = find(this.bytes, first, end); close >= 0; close = find(this.bytes, close + 1, end)) {
      const after = close + end.length;
      if (after > limit) return 0;
      if (fits(this.bytes.slice(at, after))) return after;
    }
    return 0;
  }

  /**
   * The end of a frame whose data the link refuses; 0 for none, and where one that it accepts begins within. Bytes that
   * come when this is decided do not count: frames do not depend on the pieces in which they come.
   */
  refused(at) {
    const stop = this.stop(at, 0, (frame) => this.holds(frame));
    const last = Math.min(this.bytes.length, at + this.shape.longest + 1);
    for (let place = at + 1; place < stop; place++) {
      if (this.mayBegin(place) && this.stop(place, 0, (frame) => this.accepts(frame), last) > 0) return 0;
    }
    return stop;
  }

  accepts(frame) {
    return this.holds(frame) && this.shape.messages.some((message) => this.decodes(frame, message));
  }

  decodes(frame, message) {
    try {
      this.shape.decode(frame, message);
      return true;
    } catch (error) {
      if (error instanceof CodecError) return false;
      throw error;
    }
  }

  holds(frame) {
    try {
      const data = withoutDelimiters(this.shape, this.shape.parts, frame);
      return !foreign(this.shape, data, 0) && wrongParts(this.shape.parts, data) === null;
    } catch {
      return false;
    }
  }
}
