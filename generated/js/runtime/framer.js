import { begins, find } from "./escapes.js";
import { withoutDelimiters } from "./delimiters.js";
import { originalParts, wrongParts } from "./link.js";
import { onBits } from "./number_bits.js";
import { readCode, readPart } from "./parts.js";

/**
 * Finds the frames of one direction in a stream of bytes that arrives in pieces of any size. It keeps at most the bytes
 * of one frame. Where bytes look like a frame and are none, it drops one byte and tries again.
 *
 * `extent(bytes, at)` is the length of the frame that seems to begin at a byte: 0 for none, -1 where it is unknown. Where
 * too few bytes are there, it is the number of those that are needed to determine it.
 */
export class Framer {
  constructor(shape, extent) {
    this.shape = shape;
    this.extent = extent;
    /** The number of bytes that belong to no frame. */
    this.dropped = 0;
    /** The bytes dropped last that may belong to a preamble. */
    this.lead = 0;
    this.bytes = new Uint8Array(0);
  }

  /** Counts a byte that belongs to no frame, but not the last ones that may belong to a preamble. */
  drop(byte) {
    this.dropped++;
    const { preamble } = this.shape.parts;
    if (preamble === undefined) return;
    const before = this.lead;
    this.lead = byte === preamble.byte ? Math.min(before + 1, preamble.spare) : 0;
    this.dropped += before - this.lead;
  }

  /** A frame with the bytes of its preamble that were dropped. */
  led(frame) {
    if (this.lead === 0) return frame;
    const lead = new Uint8Array(this.lead).fill(this.shape.parts.preamble.byte);
    this.lead = 0;
    return joined(lead, frame);
  }

  /** The frames that these bytes complete, each with its delimiters and checksum. */
  feed(piece) {
    const { shortest, longest } = this.shape;
    const bytes = joined(this.bytes, piece);
    const frames = [];
    let at = 0;
    while (bytes.length - at >= shortest) {
      const extent = this.extent(bytes, at);
      if (at + extent > bytes.length) break;
      if (extent < 0) {
        if (bytes.length - at <= longest) break;
      } else if (extent > 0) {
        const frame = bytes.slice(at, at + extent);
        if (this.holds(frame)) {
          frames.push(this.led(frame));
          at += extent;
          continue;
        }
      }
      this.drop(bytes[at]);
      at++;
    }
    this.bytes = bytes.slice(at);
    return frames;
  }

  /** To be called when the line has been silent: the frames in the bytes so far; the rest is dropped. */
  idle() {
    const frames = [];
    while (this.bytes.length > 0) {
      const whole = this.bytes;
      if (whole.length >= this.shape.shortest && this.extent(whole, 0) < 0 && this.holds(whole)) {
        this.bytes = new Uint8Array(0);
        frames.push(whole);
        break;
      }
      this.bytes = whole.slice(1);
      this.drop(whole[0]);
      frames.push(...this.feed(new Uint8Array(0)));
    }
    this.dropped += this.lead;
    this.lead = 0;
    return frames;
  }

  /** Drops all bytes so far. */
  reset() {
    this.bytes = new Uint8Array(0);
    this.lead = 0;
  }

  /** Whether delimiters, checksums and constants of a frame are right. */
  holds(frame) {
    try {
      const { parts } = this.shape;
      return wrongParts(parts, originalParts(parts, withoutDelimiters(this.shape, parts, frame))) === null;
    } catch {
      return false;
    }
  }
}

export function joined(first, second) {
  if (first.length === 0) return second;
  const bytes = new Uint8Array(first.length + second.length);
  bytes.set(first, 0);
  bytes.set(second, first.length);
  return bytes;
}

/** More numbers than a set is for, by the first and the last one of each interval. */
export function addressIntervals(bounds) {
  return { has: (number) => bounds.some(([low, high]) => number >= low && number <= high) };
}

export function foreign({ address, addresses }, bytes, at) {
  return addresses !== null && !addresses.has(readPart(bytes, at + address.offset, address));
}

/** The framer of frames whose length part decides where they end. */
export function lengthFramer(shape) {
  const { length, shortest, longest } = shape;
  const { start, end, preamble } = shape.parts;
  return new Framer(shape, (bytes, at) => {
    if (!begins(bytes, at, start) || (preamble !== undefined && bytes[at + preamble.least] === preamble.byte)) return 0;
    at += start.length;
    if (foreign(shape, bytes, at)) return 0;
    const extent = readPart(bytes, at + length.offset, length) * length.unitSize + length.base + start.length + end.length;
    return extent >= shortest && extent <= longest ? extent : 0;
  });
}

/**
 * The framer of frames whose code decides their length. `extents` has for each code the length of the frame without its
 * repeated part, then offset, size and order of the part that measures it, and the bytes of each unit of the measure; a
 * size of 0 where the length is fixed, and of -1 where nothing measures the repeated part. With a size of -2, the frame
 * ends with the next end delimiter, and has at least that length. With `isTurned`, the bytes of the words of a measure
 * have the opposite order. `subcodes` has the codes that messages of several lengths share: the place of the number that
 * tells these messages apart, and the extents by this number.
 */
export function codeFramer(shape) {
  const { code, extents, subcodes, flag, refusal, shortest, longest } = shape;
  const { start, end } = shape.parts;
  return new Framer(shape, (bytes, from) => {
    if (!begins(bytes, from, start)) return 0;
    const at = from + start.length;
    const number = readCode(bytes, at + code.offset, code);
    if (Number.isNaN(number)) return 0;
    let extent = onBits(number, flag, (bits, mask) => bits & mask) ? refusal : extents[number];
    const shared = extent === undefined ? subcodes?.[number] : undefined;
    if (shared !== undefined) {
      const needed = at + shared.offset + shared.size;
      if (needed > bytes.length) return foreign(shape, bytes, at) ? 0 : needed - from;
      extent = shared.extents[readCode(bytes, at + shared.offset, shared)];
    }
    if (extent === undefined || foreign(shape, bytes, at)) return 0;
    if (extent.size === -2) {
      const stop = find(bytes, from + extent.length - end.length, end);
      return stop < 0 ? -1 : stop + end.length - from;
    }
    if (extent.size <= 0) return extent.size === 0 ? extent.length : -1;
    const after = at + extent.offset + extent.size;
    if (after > bytes.length) return after - from;
    const own = bytes.slice(after - extent.size, after);
    const length = extent.length + readPart(extent.isTurned ? turned(own) : own, 0, extent) * extent.unit;
    return length >= shortest && length <= longest ? length : 0;
  });
}

/** 16-bit words with the two bytes of each exchanged. */
function turned(words) {
  return words.map((_, at) => words[at ^ 1]);
}

/** The framer of frames of characters between delimiters, neither of which occurs within. */
export function delimiterFramer(shape) {
  return new DelimiterFramer(shape);
}

class DelimiterFramer extends Framer {
  constructor(shape) {
    super(shape, null);
    const { start, end } = shape.parts;
    /** How many of the last bytes of an end delimiter may begin a frame. */
    this.common = end.length;
    while (!end.slice(end.length - this.common).every((byte, at) => byte === start[at])) this.common--;
  }

  feed(piece) {
    const { longest } = this.shape;
    const { start, end } = this.shape.parts;
    const bytes = joined(this.bytes, piece);
    const frames = [];
    let done = 0;
    for (let close = find(bytes, start.length, end); close >= 0; close = find(bytes, done + start.length, end)) {
      const open = findLast(bytes, start, done, close);
      const frame = open < 0 ? null : bytes.slice(open, close + end.length);
      const isFrame = frame !== null && this.holds(frame);
      if (isFrame) frames.push(frame);
      const after = close + end.length - (isFrame ? 0 : this.common);
      this.dropped += (isFrame ? open : after) - done;
      done = after;
    }
    const open = findLast(bytes, start, done, bytes.length);
    const rest = open >= 0 && bytes.length - open < longest ? open : Math.max(done, bytes.length - start.length + 1);
    this.dropped += rest - done;
    this.bytes = bytes.slice(rest);
    return frames;
  }

  /** No frames: frames with delimiters may pause, so silence decides nothing. */
  idle() {
    return [];
  }

  holds(frame) {
    const { shortest, longest } = this.shape;
    if (frame.length < shortest || frame.length > longest) return false;
    try {
      const data = withoutDelimiters(this.shape, this.shape.parts, frame);
      return !foreign(this.shape, data, 0) && wrongParts(this.shape.parts, data) === null;
    } catch {
      return false;
    }
  }
}

/**
 * The framer of frames whose end delimiter does not occur among their bytes, because these are escaped. `most` is the
 * greatest size of a frame with the bytes that escaping adds.
 */
export function escapeFramer(shape) {
  return new EscapeFramer(shape, null);
}

class EscapeFramer extends Framer {
  feed(piece) {
    const { most, parts } = this.shape;
    const { start, end } = parts;
    const bytes = joined(this.bytes, piece);
    const frames = [];
    let at = 0;
    const dropTo = (next) => {
      this.dropped += next - at;
      at = next;
    };
    while (at < bytes.length) {
      if (!begins(bytes, at, start)) {
        const next = find(bytes, at, start);
        dropTo(next < 0 ? Math.max(at, bytes.length - start.length + 1) : next);
        if (next < 0) break;
      }
      const close = parts.escape.end(bytes, at + start.length, end);
      if (close < 0) {
        if (bytes.length - at <= most) break;
        dropTo(at + 1);
        continue;
      }
      const frame = bytes.slice(at, close + end.length);
      if (this.holds(frame)) {
        frames.push(frame);
        at = close + end.length;
      } else {
        // What ends bytes that are not a frame may begin one, or the frame may begin later.
        dropTo(start.length > 0 ? at + 1 : close + end.length);
      }
    }
    this.bytes = bytes.slice(at);
    return frames;
  }

  /** No frames: frames with delimiters may pause, so silence decides nothing. */
  idle() {
    return [];
  }

  holds(frame) {
    const { shortest, longest, parts } = this.shape;
    const { start, end } = parts;
    try {
      const data = originalParts(parts, withoutDelimiters(this.shape, parts, frame));
      const size = data.length + start.length + end.length;
      return size >= shortest && size <= longest && wrongParts(parts, data) === null && !foreign(this.shape, data, 0);
    } catch {
      return false;
    }
  }
}

function findLast(bytes, mark, from, to) {
  for (let at = to - mark.length; at >= from; at--) if (begins(bytes, at, mark)) return at;
  return -1;
}
