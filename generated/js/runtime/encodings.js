const ENCODING_NAMES = { ascii: "ASCII", latin_1: "Latin-1", utf_8: "UTF-8", utf_16: "UTF-16", packed_ascii: "packed ASCII" };
const CHARACTER_NAMES = { 0x00: "a zero", 0x20: "a space", 0x0a: "a line feed", 0x0d: "a carriage return" };
const LONE_SURROGATE = /[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/;
const UTF_8 = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true });
const USUAL = { encoding: "ascii" };

const unitOf = ({ encoding }) => (encoding === "utf_16" ? 2 : 1);

const isPacked = ({ encoding }) => encoding === "packed_ascii";

/** The characters that three bytes of packed ASCII have, or those of bytes that have one each. */
function unpackedBytes(form, bytes) {
  if (!isPacked(form)) return bytes;
  return Uint8Array.from({ length: Math.floor(bytes.length / 3) * 4 }, (_, at) => {
    const first = Math.floor(at / 4) * 3;
    const number = bytes[first] * 65536 + bytes[first + 1] * 256 + bytes[first + 2];
    const code = (number >> (18 - 6 * (at % 4))) & 63;
    return code < 32 ? code + 64 : code;
  });
}

/** The bytes of characters: three of four characters in packed ASCII. */
function packedBytes(form, characters) {
  if (!isPacked(form)) return characters;
  return Uint8Array.from({ length: (characters.length / 4) * 3 }, (_, at) => {
    const first = at + Math.floor(at / 3);
    const pair = (characters[first] & 63) * 64 + (characters[first + 1] & 63);
    return (pair >> (4 - 2 * (at % 3))) & 255;
  });
}

/** The bytes of a text of `size` bytes before it is packed. */
const wholeSize = (form, size) => (isPacked(form) ? Math.floor(size / 3) * 4 : size);

function characterName(code) {
  return CHARACTER_NAMES[code] ?? `the character 0x${code.toString(16).toUpperCase().padStart(2, "0")}`;
}

/** Bytes with those of each word of 16 bits exchanged, where a form says so. */
const turnedBytes = ({ isTurned }, bytes) => (isTurned ? bytes.map((_, at) => bytes[at ^ 1]) : bytes);

/** The codes that a text has at each place: bytes, or numbers of 16 bits. */
function unitsOf(form, bytes, little) {
  if (unitOf(form) === 1) return bytes;
  return Array.from({ length: bytes.length / 2 }, (_, at) => bytes[2 * at + (little ? 1 : 0)] * 256 + bytes[2 * at + (little ? 0 : 1)]);
}

/** The characters of units; null for those that the encoding does not have. */
function textOfUnits({ encoding }, units) {
  if (encoding === "utf_8") {
    try {
      return UTF_8.decode(Uint8Array.from(units));
    } catch {
      return null;
    }
  }
  let text = "";
  for (const unit of units) text += String.fromCharCode(unit);
  if (encoding === "ascii" && units.some((unit) => unit > 0x7f)) return null;
  return encoding === "utf_16" && LONE_SURROGATE.test(text) ? null : text;
}

/** The units of a text; null for characters that the encoding does not have. */
function unitsOfText({ encoding }, text) {
  if (LONE_SURROGATE.test(text)) return null;
  if (encoding === "utf_8") return [...new TextEncoder().encode(text)];
  const units = Array.from({ length: text.length }, (_, at) => text.charCodeAt(at));
  const [least, most] = { ascii: [0, 0x7f], latin_1: [0, 0xff], utf_16: [0, 0xffff], packed_ascii: [0x20, 0x5f] }[encoding];
  return units.some((unit) => unit < least || unit > most) ? null : units;
}

/**
 * The characters of the bytes of a text in a form, in UTF-16 with the low byte first where `little`; null for bytes
 * that are none. Without a form, a text is ASCII that is filled up with zeros after it.
 */
export function decodedText(form, bytes, little) {
  const { padding = 0, isRight = false, terminator } = form ?? USUAL;
  const units = unitsOf(form ?? USUAL, unpackedBytes(form ?? USUAL, turnedBytes(form ?? USUAL, bytes)), little);
  let [first, last] = [0, units.length];
  if (terminator !== undefined) {
    last = units.indexOf(terminator);
    if (last < 0) return null;
  } else {
    while (!isRight && last > first && units[last - 1] === padding) last--;
    while (isRight && last > first && units[first] === padding) first++;
  }
  const text = textOfUnits(form ?? USUAL, units.slice(first, last));
  return form !== undefined && text !== null && text.includes("\0") ? null : text;
}

/** Why a text cannot be sent in `size` bytes of a form: a reason and words; null where it can. */
export function textFault(form, size, text) {
  const { encoding, padding = 0, isRight = false, terminator } = form;
  const units = unitsOfText(form, text);
  if (units === null) return ["unknown_value", `has characters that are not ${ENCODING_NAMES[encoding]}`];
  if (text.includes("\0")) return ["unknown_value", "has a zero, which ends a text"];
  if (terminator !== undefined) {
    if (units.includes(terminator)) return ["unknown_value", `has ${characterName(terminator)}, which ends the text`];
  } else if (units.at(isRight ? 0 : -1) === padding) {
    const place = isRight ? "begins" : "ends";
    return ["unknown_value", `${place} with ${characterName(padding)}, which fills the text up`];
  }
  const room = wholeSize(form, size) - (terminator === undefined ? 0 : unitOf(form));
  const taken = units.length * unitOf(form);
  const counted = isPacked(form) ? "characters" : "bytes";
  return taken > room ? ["wrong_length", `has ${room} ${counted}, not ${taken}`] : null;
}

/** The `size` bytes of a text that has no fault. */
export function textBytes(form, size, text, little) {
  const { padding = 0, isRight = false, terminator } = form;
  const units = [...unitsOfText(form, text), ...(terminator === undefined ? [] : [terminator])];
  const filler = new Array(Math.floor(wholeSize(form, size) / unitOf(form)) - units.length).fill(padding);
  const all = isRight ? [...filler, ...units] : [...units, ...filler];
  if (unitOf(form) === 1) return turnedBytes(form, packedBytes(form, Uint8Array.from(all)));
  return Uint8Array.from(all.flatMap((unit) => (little ? [unit & 255, unit >> 8] : [unit >> 8, unit & 255])));
}
