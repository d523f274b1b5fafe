const EARLIER = "before-";
const NUMBER = /^[0-9]{1,9}$/;
const BLANKS = /^[ \t\r\n\0]+|[ \t\r\n\0]+$/g;

/** Firmware that a spec does not list: `firmware` is the requested one, `known` are the versions of the spec. */
export class UnknownFirmwareError extends RangeError {
  constructor(firmware, known) {
    super(`the firmware ${JSON.stringify(firmware)} is unknown; known are ${known.join(", ")}`);
    this.name = "UnknownFirmwareError";
    this.firmware = firmware;
    this.known = known;
  }
}

/** The version that a value of the device tells: `2.21` of 221 in the form `decimal` with two places. */
export function versionIn(lines, value, form, places, named) {
  if (typeof value === "string") {
    const text = value.replace(BLANKS, "");
    return named.get(text) ?? text;
  }
  const number = Number(value);
  const version = named.get(number) ?? (Number.isSafeInteger(number) && number >= 0 ? read(number, form, places) : null);
  if (version === null) throw new UnknownFirmwareError(String(value), lines.flat());
  return version;
}

function read(number, form, places) {
  if (form === "bytes" && number < 256 ** places) {
    return Array.from({ length: places }, (_, at) => Math.floor(number / 256 ** (places - 1 - at)) % 256).join(".");
  }
  if (form !== "decimal" && form !== "hexadecimal") return null;
  const digits = number.toString(form === "decimal" ? 10 : 16).toUpperCase().padStart(places + 1, "0");
  return places === 0 ? digits : `${digits.slice(0, -places)}.${digits.slice(-places)}`;
}

/** The version of a spec for a firmware; `lines` have the versions, the oldest first. */
export function versionOf(lines, firmware, nearest) {
  const text = firmware.replace(BLANKS, "");
  const version = lines.flat().find((known) => known === text) ?? numbered(lines, text, nearest);
  if (version === null) throw new UnknownFirmwareError(firmware, lines.flat());
  return version;
}

function numbered(lines, text, nearest) {
  const asked = numbers(text);
  if (asked === null) return null;
  for (const line of lines.length === 1 ? lines : lines.filter((own) => first(own) === asked[0])) {
    const known = line.map((version) => ({ version, number: numbers(version) })).filter(({ number }) => number !== null);
    const same = known.find(({ number }) => order(number, asked) === 0);
    if (same !== undefined) return same.version;
    const earlier = line.find((version) => isBefore(version, asked));
    if (earlier !== undefined && known.every(({ number }) => order(asked, number) < 0)) return earlier;
    const below = known.filter(({ number }) => order(number, asked) < 0);
    if (nearest && below.length > 0) return below.reduce((one, other) => (order(one.number, other.number) < 0 ? other : one)).version;
  }
  return null;
}

/** `v02.21` as [2, 21], without trailing zeros; null for a text that is not a version number. */
function numbers(text) {
  const parts = text.replace(/^v/i, "").split(".");
  if (!parts.every((part) => NUMBER.test(part))) return null;
  const result = parts.map(Number);
  while (result.length > 1 && result[result.length - 1] === 0) result.pop();
  return result;
}

function withoutEarlier(version) {
  return version.startsWith(EARLIER) ? version.slice(EARLIER.length) : version;
}

/** The first number of the versions of a line. */
function first(line) {
  const known = line.map((version) => numbers(withoutEarlier(version))).find((parts) => parts !== null);
  return known === undefined ? null : known[0];
}

/** Whether a version stands for all firmware below a number, and the requested number is below it. */
function isBefore(version, asked) {
  const bound = version.startsWith(EARLIER) ? numbers(withoutEarlier(version)) : null;
  return bound !== null && order(asked, bound) < 0;
}

/** Less than 0 where the first list of numbers is below the second one. */
function order(one, other) {
  for (let at = 0; at < Math.min(one.length, other.length); at += 1) {
    if (one[at] !== other[at]) return one[at] - other[at];
  }
  return one.length - other.length;
}
