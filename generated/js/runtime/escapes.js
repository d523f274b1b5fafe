import { CodecError } from "./error.js";

/**
 * The original bytes, by the `walk` of an escape, which gives each with the place of the byte that is sent for it. Throws
 * CodecError for what is the escape of nothing, as if the data began at `offset`.
 */
function original(data, offset) {
  const result = [];
  try {
    this.walk(data, (byte) => result.push(byte));
  } catch (error) {
    throw error instanceof CodecError ? new CodecError(error.reason, error.detail, offset + error.offset) : error;
  }
  return Uint8Array.from(result);
}

/** Two bytes are sent for each of some bytes: `pairs` are such a byte and the two bytes. */
export function replacing(pairs) {
  const pairOf = new Map(pairs.map(([byte, first, second]) => [byte, [first, second]]));
  const originals = new Map(pairs.map(([byte, first, second]) => [first * 256 + second, byte]));
  const special = new Set(pairs.flatMap(([byte, first]) => [byte, first]));
  return {
    escaped: (data) => Uint8Array.from([...data].flatMap((byte) => pairOf.get(byte) ?? [byte])),
    walk(data, give) {
      for (let at = 0; at < data.length; at++) {
        if (!special.has(data[at])) {
          give(data[at], at);
          continue;
        }
        const byte = at + 1 < data.length ? originals.get(data[at] * 256 + data[at + 1]) : undefined;
        if (byte === undefined) throw wrongEscape("a byte is not escaped, or the escape means nothing", at);
        give(byte, at++);
      }
    },
    original,
    end(bytes, from, mark) {
      for (let at = from; at < bytes.length; at++) {
        if (at + 1 < bytes.length && originals.has(bytes[at] * 256 + bytes[at + 1])) at++;
        else if (begins(bytes, at, mark)) return at;
      }
      return -1;
    },
  };
}

/** A byte is sent after each occurrence of a pattern. */
export function inserting(pattern, inserted) {
  return {
    escaped(data) {
      const result = [];
      for (let at = 0; at < data.length; ) {
        if (begins(data, at, pattern)) {
          result.push(...pattern, inserted);
          at += pattern.length;
        } else {
          result.push(data[at++]);
        }
      }
      return Uint8Array.from(result);
    },
    walk(data, give) {
      for (let at = 0; at < data.length; ) {
        if (!begins(data, at, pattern)) {
          give(data[at], at++);
          continue;
        }
        for (const byte of pattern) give(byte, at++);
        if (data[at] !== inserted) throw wrongEscape(`the byte ${inserted} is missing after the pattern`, at);
        at++;
      }
    },
    original,
    end: find,
  };
}

/** Each byte is sent plus `byte`, without the carry. */
export function adding(byte) {
  return {
    escaped: (data) => data.map((own) => own + byte),
    walk: (data, give) => data.forEach((own, at) => give((own - byte) & 0xff, at)),
    original,
    end: find,
  };
}

/** Consistent overhead byte stuffing: no zero is sent; each block begins with the distance to the next zero. */
export const cobs = {
  escaped(data) {
    const result = [];
    let block = [];
    const finish = () => {
      result.push(block.length + 1, ...block);
      block = [];
    };
    for (const byte of data) {
      if (block.length === 254) finish();
      if (byte) block.push(byte);
      else finish();
    }
    finish();
    return Uint8Array.from(result);
  },
  walk(data, give) {
    for (let at = 0; at < data.length || data.length === 0; ) {
      const code = data[at] ?? 0;
      const block = data.subarray(at + 1, at + code);
      if (code === 0 || block.length < code - 1 || block.includes(0)) {
        throw wrongEscape(`the block of ${code} bytes is not complete`, at);
      }
      block.forEach((byte, place) => give(byte, at + 1 + place));
      at += code;
      if (code < 255 && at < data.length) give(0, at);
    }
  },
  original,
  end: find,
};

function wrongEscape(detail, offset) {
  return new CodecError("wrong_mark", detail, offset);
}

/** Whether a mark stands at a place. */
export function begins(bytes, at, mark) {
  if (at + mark.length > bytes.length) return false;
  for (let place = 0; place < mark.length; place++) if (bytes[at + place] !== mark[place]) return false;
  return true;
}

/** The place of the first mark from a place on, or -1. */
export function find(bytes, from, mark) {
  for (let at = from; at + mark.length <= bytes.length; at++) if (begins(bytes, at, mark)) return at;
  return -1;
}

const [EXTENDED, REMOTE] = [2 ** 31, 2 ** 30];

/**
 * The first parts as the identifier of a CAN frame, which has `bits` bits: the size, whether the byte order is little,
 * the first bit and the bits of each part. A frame is the identifier in four bytes, the number of data, zeros, the data.
 * `remote` is the place of the code where remote requests are sent: it has a bit for these, which have no data, and the
 * number of the data in place of data.
 */
export function canIdentifier(bits, fields, remote = -1) {
  const flags = bits > 11 ? EXTENDED : 0;
  return {
    escaped(data) {
      let [identifier, at] = [flags, 0];
      let isRemote = false;
      for (const [row, [size, isLittle, first, width]] of fields.entries()) {
        let number = numberIn(data.subarray(at, at + size), isLittle);
        if (row === remote && number >= REMOTE && number < EXTENDED) {
          isRemote = true;
          identifier += REMOTE;
          number -= REMOTE;
        }
        if (number >= 2 ** width) throw new CodecError("out_of_range", `${number} has more than ${width} bits`);
        identifier += number * 2 ** first;
        at += size;
      }
      const content = isRemote ? [] : data.subarray(at);
      const size = isRemote && data.length - at === 1 ? data[at] : data.length - at;
      if (size > 8) throw new CodecError("wrong_length", `a CAN frame has at most 8 bytes of data, not ${size}`);
      return Uint8Array.from([identifier / 2 ** 24, identifier / 2 ** 16, identifier / 256, identifier, size, 0, 0, 0, ...content].map((byte) => byte & 0xff));
    },
    // The first part is in the place of the whole header, and the other parts of the identifier follow it. In a remote
    // request, the requested number of bytes is in the second half of the header.
    walk(data, give) {
      const wrong = wrongCanHeader(bits, data, remote);
      if (wrong >= 0) throw wrongEscape(canHeaderFault(bits, data, wrong, remote), wrong);
      const isRemote = isRemoteRequest(data, remote);
      canParts(fields, data, isRemote ? remote : -1).forEach((byte, at) => give(byte, at < fields[0][0] ? 0 : isRemote ? 4 : 8));
      if (isRemote) give(data[4], 4);
      data.subarray(8).forEach((byte, at) => give(byte, at + 8));
    },
    original,
    end: () => -1,
  };
}

/** Whether a frame is a remote request, on a bus where these have codes at the place `remote` of the identifier. */
export function isRemoteRequest(data, remote) {
  return remote >= 0 && (data[0] & 0x40) !== 0;
}

/** The offset at which bytes are not a CAN frame with an identifier of some bits; -1 where they are. */
function wrongCanHeader(bits, data, remote) {
  const isRemote = isRemoteRequest(data, remote);
  const flags = (bits > 11 ? EXTENDED : 0) + (isRemote ? REMOTE : 0);
  const identifier = numberIn(data.subarray(0, 4), false);
  if (data.length < 8 || identifier < flags || identifier >= flags + 2 ** bits) return 0;
  if (data.length !== 8 + (isRemote ? 0 : data[4]) || data[4] > 8) return 4;
  return data.subarray(5, 8).some((byte) => byte !== 0) ? 5 : -1;
}

/** What is wrong with a CAN frame at an offset that `wrongCanHeader` returns. */
function canHeaderFault(bits, data, at, remote) {
  const size = data.length - 8;
  const isRemote = isRemoteRequest(data, remote);
  if (at === 4 && isRemote && size) return `a remote request has no data, but there are ${size} bytes`;
  if (at === 4 && !isRemote && data[4] !== size) return `byte 4 says ${data[4]} bytes of data, but there are ${size}`;
  if (at === 4) return `a CAN frame has at most 8 bytes of data, not ${data[4]}`;
  if (at === 5) return "the three bytes after the data length are not zero";
  return `it is not a CAN frame with an identifier of ${bits} bits`;
}

/** The bytes of the parts of the identifier of a CAN frame; the code at the place `remote` is that of a remote request. */
function canParts(fields, data, remote) {
  const identifier = numberIn(data.subarray(0, 4), false) % REMOTE;
  return fields.flatMap(([size, isLittle, first, width], row) => {
    const number = Math.floor(identifier / 2 ** first) % 2 ** width + (row === remote ? REMOTE : 0);
    const bytes = Array.from({ length: size }, (_, at) => Math.floor(number / 256 ** at) & 0xff);
    return isLittle ? bytes : bytes.reverse();
  });
}

function numberIn(bytes, isLittle) {
  const ordered = isLittle ? bytes.toReversed() : bytes;
  return ordered.reduce((number, byte) => number * 256 + byte, 0);
}

/** The identifier and the data of a frame as encoders return it, for a driver; a remote request has a number of data. */
export function canFrame(bytes) {
  const identifier = numberIn(bytes.subarray(0, 4), false);
  const frame = { identifier: identifier % REMOTE, data: bytes.slice(8), isExtended: identifier >= EXTENDED };
  return isRemoteRequest(bytes, 0) ? { ...frame, isRemote: true, dlc: bytes[4] } : frame;
}

/** The frame of an identifier and its data, as a driver gives them, for decoders. */
export function canBytes({ identifier, data = [], isExtended = false, isRemote = false, dlc = data.length }) {
  const number = identifier + (isExtended ? EXTENDED : 0) + (isRemote ? REMOTE : 0);
  const head = [number / 2 ** 24, number / 2 ** 16, number / 256, number].map((byte) => byte & 0xff);
  return Uint8Array.from([...head, dlc, 0, 0, 0, ...(isRemote ? [] : data)]);
}
