import { CodecError } from "./error.js";

/** Two bytes are sent for each of some bytes: `pairs` are such a byte and the two bytes. */
export function replacing(pairs) {
  const pairOf = new Map(pairs.map(([byte, first, second]) => [byte, [first, second]]));
  const originals = new Map(pairs.map(([byte, first, second]) => [first * 256 + second, byte]));
  const special = new Set(pairs.flatMap(([byte, first]) => [byte, first]));
  return {
    escaped: (data) => Uint8Array.from([...data].flatMap((byte) => pairOf.get(byte) ?? [byte])),
    original(data, offset) {
      const result = [];
      for (let at = 0; at < data.length; at++) {
        if (!special.has(data[at])) {
          result.push(data[at]);
          continue;
        }
        const byte = at + 1 < data.length ? originals.get(data[at] * 256 + data[at + 1]) : undefined;
        if (byte === undefined) throw wrongEscape("a byte is not escaped, or the escape means nothing", offset + at);
        result.push(byte);
        at++;
      }
      return Uint8Array.from(result);
    },
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
    original(data, offset) {
      const result = [];
      for (let at = 0; at < data.length; ) {
        if (!begins(data, at, pattern)) {
          result.push(data[at++]);
          continue;
        }
        at += pattern.length;
        if (data[at] !== inserted) throw wrongEscape(`the byte ${inserted} is missing behind the pattern`, offset + at);
        result.push(...pattern);
        at++;
      }
      return Uint8Array.from(result);
    },
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
  original(data, offset) {
    const result = [];
    for (let at = 0; at < data.length || data.length === 0; ) {
      const code = data[at] ?? 0;
      const block = data.subarray(at + 1, at + code);
      if (code === 0 || block.length < code - 1 || block.includes(0)) {
        throw wrongEscape(`the block of ${code} bytes is not complete`, offset + at);
      }
      result.push(...block);
      at += code;
      if (code < 255 && at < data.length) result.push(0);
    }
    return Uint8Array.from(result);
  },
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
