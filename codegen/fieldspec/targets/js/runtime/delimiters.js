import { CodecError } from "./error.js";

function isHex(byte) {
  return (byte >= 48 && byte <= 57) || (byte >= 65 && byte <= 70) || (byte >= 97 && byte <= 102);
}

function digit(byte) {
  return byte <= 57 ? byte - 48 : (byte & 0x5f) - 55;
}

/** Whether bytes are at an offset. */
export function matches(bytes, offset, mark) {
  for (let at = 0; at < mark.length; at++) if (bytes[offset + at] !== mark[at]) return false;
  return true;
}

/** Bytes as hexadecimal digits. */
export function hexText(bytes) {
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join(" ");
}

/** A frame without its delimiters, as bytes instead of characters. Throws CodecError. */
export function withoutDelimiters({ hex }, { start, end, preamble }, frame) {
  const bytes = preamble === undefined ? frame : frame.subarray(surplusOf(preamble, frame));
  if (start.length === 0 && end.length === 0 && !hex) return bytes;
  if (bytes.length < start.length || !matches(bytes, 0, start)) {
    throw new CodecError("wrong_mark", `the frame does not start with ${hexText(start)}`, 0);
  }
  const last = bytes.length - end.length;
  if (last < start.length || !matches(bytes, last, end)) {
    throw new CodecError("wrong_mark", `the frame does not end with ${hexText(end)}`, bytes.length);
  }
  if (!hex) return bytes.subarray(start.length, last);
  for (let at = start.length; at < last; at++) {
    if (!isHex(bytes[at])) throw new CodecError("not_hex", `byte ${bytes[at]} is not a hexadecimal character`, at);
  }
  if ((last - start.length) % 2) throw new CodecError("wrong_length", "an odd number of characters", last);
  const data = new Uint8Array((last - start.length) / 2);
  for (let at = 0; at < data.length; at++) {
    data[at] = digit(bytes[start.length + 2 * at]) * 16 + digit(bytes[start.length + 2 * at + 1]);
  }
  return data;
}

/** How many bytes of its preamble a frame has before the least ones, which are the first of the start delimiter. */
function surplusOf({ byte, least, spare }, frame) {
  let run = 0;
  while (run < frame.length && frame[run] === byte) run++;
  return Math.max(0, Math.min(run - least, spare));
}

/** A frame of the bytes of its parts. */
export function withDelimiters(context, shape, data) {
  const frame = delimited(context, shape, data);
  const { byte, further } = shape.preamble ?? { further: 0 };
  return further > 0 ? Uint8Array.from([...new Uint8Array(further).fill(byte), ...frame]) : frame;
}

function delimited({ hex }, { start, end }, data) {
  if (start.length === 0 && end.length === 0 && !hex) return data;
  const inner = hex ? 2 * data.length : data.length;
  const bytes = new Uint8Array(start.length + inner + end.length);
  bytes.set(start, 0);
  if (hex) {
    for (let at = 0; at < data.length; at++) {
      const [high, low] = [data[at] >> 4, data[at] & 15];
      bytes[start.length + 2 * at] = high + (high < 10 ? 48 : 55);
      bytes[start.length + 2 * at + 1] = low + (low < 10 ? 48 : 55);
    }
  } else {
    bytes.set(data, start.length);
  }
  bytes.set(end, start.length + inner);
  return bytes;
}
