import { explainedAfter } from "./frame_rows.js";
import { hexOf, portableValue } from "./texts.js";

const [MOST_REMEMBERED, LONGEST_REMEMBERED] = [256, 300];
const remembered = new WeakMap();

/** The explanation of a whole frame as the answer to `request`, the bytes of another one. Never throws. */
export function explained(device, link, direction, frame, message = "", request = new Uint8Array()) {
  if (!remembered.has(device)) remembered.set(device, new Map());
  const known = remembered.get(device);
  const key = [link, direction, message, hexOf(frame), hexOf(request)].join(" ");
  if (!known.has(key)) {
    const asked = request.length && direction === "response" ? explained(device, link, "request", request, message) : null;
    const explanation = explainedAfter(device, link, direction, frame, message, asked);
    if (frame.length + request.length > LONGEST_REMEMBERED) return explanation;
    if (known.size >= MOST_REMEMBERED) known.delete(known.keys().next().value);
    known.set(key, explanation);
  }
  return known.get(key);
}

/** `speed at byte 4`; in a CAN frame `speed at byte 2 of the data` or `node in the identifier`; without its path elsewhere. */
export function placeText({ canPlace, path, byteText }) {
  return path ? `${path} ${canPlace === "identifier" ? "in" : "at"} ${byteText}` : byteText;
}

/** The names of what a row has where its data call it otherwise; `words` are named by their unit. */
const NAMES = { canPlace: "can_place", printedName: "printed_name", words: undefined, unit: undefined };

/** Data with null for empty texts, by other names; without what has none. */
function emptied(data, names = {}) {
  const result = {};
  for (const key in data) {
    const name = key in names ? names[key] : key;
    if (name) result[name] = data[key] === "" ? null : data[key];
  }
  return result;
}

/** A row as data: what is empty is null, bytes are hexadecimal digits. */
export function rowData(row) {
  const data = emptied(row, NAMES);
  data.raw = hexOf(row.raw);
  data.number = portableValue(row.number);
  data.meanings = row.meanings.map((meaning) => emptied(meaning));
  data[row.unit === "byte" ? "size" : `${row.unit || "word"}s`] = row.words || null;
  return data;
}

/** Readings as data: link, direction, message and whether it is an exception response. */
function readingData([link, direction, message, error]) {
  return { link, direction, message: message || null, error };
}

/** An explanation as data, with the readings that fit, how one of them was chosen, and remarks on the input. */
export function explanationData(device, explanation, readings, chosen, remarks, wrong) {
  const rows = [...explanation.rows, ...explanation.registers];
  const errata = new Set([...explanation.errata, ...rows.flatMap((row) => row.errata)]);
  return {
    device: device.data.device,
    version: device.data.version,
    frame: hexOf(explanation.frame),
    link: explanation.link,
    direction: explanation.direction,
    direction_name: device.links.get(explanation.link).directionNames[explanation.direction],
    message: explanation.message || null,
    error: explanation.error,
    wrong,
    reasons: explanation.reasons,
    chosen,
    readings: readings.map(readingData),
    remarks,
    values: portableValue(new Map(explanation.values.entries())),
    rows: explanation.rows.map(rowData),
    registers: explanation.registers.map(rowData),
    errata: device.data.errata.filter(({ id }) => errata.has(id)),
  };
}
