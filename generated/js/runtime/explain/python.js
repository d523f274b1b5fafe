import { exactWhole, onBits } from "../number_bits.js";
import { bytesOfHex, hexOf, latinOf, sameValue, sentence, valueText } from "./texts.js";
import { isWhole } from "./numbers.js";

/** The same key for whole numbers that are equal, and for lists of equal items. */
function keyOf(key) {
  if (typeof key === "bigint") return exactWhole(key);
  return Array.isArray(key) ? JSON.stringify(key) : key;
}

/** A dictionary of Python: it lists its keys, and lists are keys by their items. */
export class Dictionary {
  constructor(entries = []) {
    this.byKey = new Map();
    for (const [key, value] of entries) this.set(key, value);
  }

  get size() {
    return this.byKey.size;
  }

  set(key, value) {
    this.byKey.set(keyOf(key), [key, value]);
  }

  get(key) {
    return this.byKey.get(keyOf(key))?.[1];
  }

  has(key) {
    return this.byKey.has(keyOf(key));
  }

  setdefault(key, value) {
    if (!this.has(key)) this.set(key, value);
    return this.get(key);
  }

  update(other) {
    for (const [key, value] of other.entries()) this.set(key, value);
  }

  entries() {
    return this.byKey.values();
  }

  keys() {
    return [...this.byKey.values()].map(([key]) => key);
  }

  values() {
    return [...this.byKey.values()].map(([, value]) => value);
  }

  [Symbol.iterator]() {
    return this.keys()[Symbol.iterator]();
  }
}

const compared = (left, right) => {
  if (!Array.isArray(left)) return left < right ? -1 : Number(left > right);
  for (const [place, own] of left.entries()) {
    const result = place < right.length ? compared(own, right[place]) : 1;
    if (result) return result;
  }
  return left.length - right.length;
};

const trimmed = (text, characters, isLeft, isRight) => {
  const isBlank = (character) => (characters === undefined ? !character.trim() : characters.includes(character));
  let [start, end] = [0, text.length];
  while (isLeft && start < end && isBlank(text[start])) start++;
  while (isRight && end > start && isBlank(text[end - 1])) end--;
  return text.slice(start, end);
};

const patterns = new Map();

/** A pattern of Python as a regular expression; `frame` puts it between others. */
function patternOf(pattern, frame = (inner) => inner, flags = "") {
  const key = `${frame("")}${flags}${pattern}`;
  if (!patterns.has(key)) {
    const [, own = "", inner] = /^(?:\(\?([a-z]+)\))?(.*)$/s.exec(pattern);
    const text = inner.replaceAll("(?P<", "(?<").replaceAll("\\Z", "$")
      .replace(/\[(?:\\.|[^\]\\])*\]|\\w/g, (part) => (part === "\\w" ? "[\\w]" : part).replaceAll("\\w", "\\p{L}\\p{N}_"));
    patterns.set(key, new RegExp(frame(text), `u${own}${flags}`));
  }
  return patterns.get(key);
}

function matchOf(match) {
  return match && Object.assign(match, { start: () => match.index, end: () => match.index + match[0].length });
}

/** What JavaScript lacks of Python. */
export const py = {
  truth: (value) => (typeof value === "object" && value !== null ? (value.length ?? value.size ?? 1) !== 0 : Boolean(value)),
  either: (value, other) => (py.truth(value) ? value : other()),
  equal: (left, right) => (left ?? null) === (right ?? null) || (left != null && right != null && sameValue(left, right)),
  has: (series, value) => {
    if (typeof series === "string") return series.includes(value);
    if (series instanceof Uint8Array) return series.includes(value);
    if (typeof series.has === "function") return series.has(value);
    return [...series].some((own) => py.equal(own, value));
  },
  item: (series, key) => {
    if (typeof series.get === "function") return series.get(key);
    return typeof key === "string" ? series.groups[key] : series.at(Number(key));
  },
  put: (dictionary, key, value) => dictionary.set(key, value),
  slice: (series, start, stop) => (series instanceof Uint8Array ? series.subarray(start, stop) : series.slice(start, stop)),
  joined: (left, right) => Uint8Array.from([...left, ...right]),
  startswith: (series, start) => py.equal(py.slice(series, 0, start.length), start),
  repeated: (series, count) => new Array(Math.max(0, count)).fill(series).flat(),
  format: sentence,
  repr: (value) => valueText(value),
  zip: (...series) => series[0].slice(0, Math.min(...series.map((own) => own.length))).map((_, place) => series.map((own) => own[place])),
  replace: (value, more) => Object.setPrototypeOf({ ...value, ...more }, Object.getPrototypeOf(value)),
  dict: (entries = []) => new Dictionary(Array.isArray(entries) ? entries : entries.entries()),
  isWhole,
  isList: Array.isArray,
  any: (series) => [...series].some(py.truth),
  all: (series) => [...series].every(py.truth),
  list: (series) => [...series],
  tuple: (series) => [...series],
  frozenset: (series) => new Set(series),
  issubset: (left, right) => [...left].every((own) => right.has(own)),
  sum: (series) => [...series].reduce((sum, own) => sum + Number(own), 0),
  next: (series, otherwise) => {
    for (const value of series) return value;
    return otherwise;
  },
  sorted: (series, key = (own) => own) => [...series].sort((left, right) => compared(key(left), key(right))),
  min: (...values) => (values.length > 1 && typeof values[1] !== "function" ? Math.min(...values) : py.sorted(...values)[0]),
  max: Math.max,
  range: (first, last, step = 1) => {
    const [start, stop] = last === undefined ? [0, first] : [first, last];
    return Array.from({ length: Math.max(0, Math.ceil((stop - start) / step)) }, (_, place) => start + place * step);
  },
  reversed: (series) => (typeof series === "string" ? [...series].reverse().join("") : series.toReversed()),
  enumerate: (series) => [...series].map((own, place) => [place, own]),
  bytes: (series) => Uint8Array.from(series),
  int: (value, base) => (typeof value === "string" ? parseInt(value, base ?? 10) : Number(value)),
  str: String,
  chr: String.fromCharCode,
  islice: (series, count) => [...series].slice(0, count),
  join: (separator, series) => [...series].join(separator),
  hexadecimal: (number, form) => {
    const digits = number.toString(16).padStart(Number(form.slice(0, -1)), "0");
    return form.endsWith("X") ? digits.toUpperCase() : digits;
  },
  common: (left, right) => onBits(left, right, (bits, mask) => bits & mask),
  without: (left, right) => onBits(left, right, (bits, mask) => bits & ~mask),
  count: (text, part) => text.split(part).length - 1,
  decode: latinOf,
  encode: (text) => Uint8Array.from([...text], (character) => (character.codePointAt(0) > 255 ? 0x3f : character.charCodeAt(0))),
  endswith: (series, end) => py.equal(py.slice(series, Math.max(0, series.length - end.length)), end),
  groups: (match) => match.slice(1),
  hex: (bytes, separator) => hexOf(bytes, separator).toLowerCase(),
  bytesOfHex: (text) => {
    const digits = text.replace(/\s/g, "");
    if (!/^\s*(?:[0-9A-Fa-f]{2}\s*)*$/.test(text)) throw new RangeError("these are not the digits of bytes");
    return bytesOfHex(digits);
  },
  zfill: (text, count) => text.padStart(count, "0"),
  strip: (text, characters) => trimmed(text, characters, true, true),
  lstrip: (text, characters) => trimmed(text, characters, true, false),
  rstrip: (text, characters) => trimmed(text, characters, false, true),
  split: (text, separator) => (separator === undefined ? text.trim().split(/\s+/).filter(Boolean) : text.split(separator)),
  re: {
    fullmatch: (pattern, text) => matchOf(patternOf(pattern, (inner) => `^(?:${inner})$`).exec(text)),
    match: (pattern, text) => matchOf(patternOf(pattern, (inner) => `^(?:${inner})`).exec(text)),
    search: (pattern, text) => matchOf(patternOf(pattern).exec(text)),
    sub: (pattern, text, other) => other.replace(patternOf(pattern, undefined, "g"), text),
    split: (pattern, text) => text.split(patternOf(pattern)),
    finditer: (pattern, text) => [...text.matchAll(patternOf(pattern, undefined, "g"))].map(matchOf),
  },
};
