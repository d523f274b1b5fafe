// Answers queries about a generated module: node javascript_judge.mjs MODULE JOBS
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const exports = await import(pathToFileURL(process.argv[2]));
const jobs = JSON.parse(readFileSync(process.argv[3], "utf8"));
const hex = (bytes) => Buffer.from(bytes).toString("hex");

/** A value from the JSON of the judge, and back: bigints, bytes and numbers that JSON does not have. */
function fromJson(value) {
  if (Array.isArray(value)) return value.map(fromJson);
  if (typeof value !== "object" || value === null) return value;
  if ("$n" in value) return BigInt(value.$n);
  if ("$b" in value) return new Uint8Array(Buffer.from(value.$b, "hex"));
  if ("$f" in value) return Number(value.$f);
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, fromJson(inner)]));
}

function toJson(value) {
  if (typeof value === "bigint") return { $n: String(value) };
  if (value instanceof Uint8Array) return { $b: hex(value) };
  if (typeof value === "number" && (!Number.isFinite(value) || Object.is(value, -0))) {
    return { $f: Object.is(value, -0) ? "-0.0" : String(value).replace("Infinity", "inf") };
  }
  if (Array.isArray(value)) return value.map(toJson);
  if (typeof value === "object" && value !== null) {
    return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, toJson(inner)]));
  }
  return value;
}

const entries = new Map();

/** What is exported under a name and has a property: kept, as there are thousands of exports and of jobs. */
function find(name, key) {
  const place = `${key} ${name}`;
  if (!entries.has(place)) entries.set(place, Object.values(exports).find((value) => value?.name === name && value[key] !== undefined));
  if (entries.get(place) === undefined) throw new Error(`there is no ${name}`);
  return entries.get(place);
}

function again(action) {
  try {
    return hex(action());
  } catch (error) {
    if (error.name !== "CodecError") throw error;
    return `!${error.reason}`;
  }
}

function frame({ path: [linkName, direction, messageName], data, encodes, header, values, error, code, carriesCode }) {
  const link = find(linkName, "encodeRequest");
  const message = link.messages.find((entry) => entry.name === messageName);
  const encode = (parts, entry, content, isError, number) => {
    if (isError) return link.encodeExceptionResponse(parts, number, content);
    return direction === "request" ? link.encodeRequest(parts, entry, content) : link.encodeResponse(parts, entry, content);
  };
  if (encodes) return { again: hex(encode(fromJson(header), message, fromJson(values), error, fromJson(code))) };
  const bytes = new Uint8Array(Buffer.from(data, "hex"));
  const value = direction === "request" ? link.decodeRequest(bytes, message) : link.decodeResponse(bytes, message);
  const isError = value.kind === "exception";
  const stated = value.message && (direction === "request" ? value.message.code : value.message.responseCode);
  const number = !carriesCode && isError ? null : isError ? value.code : stated;
  return {
    value: { ...toJson({ kind: value.kind, name: value.name, header: value.header, data: value.data }), code: coded(number) },
    again: again(() => encode(value.header, value.message, value.data, isError, number)),
  };
}

const coded = (number) => (number === null ? "None" : String(number));

function alone(codec, { data, encodes, values, exponent }) {
  if (encodes) return { again: hex(codec.encode(fromJson(values))) };
  const value = codec.decode(new Uint8Array(Buffer.from(data, "hex")));
  return { value: toJson(value), again: again(() => codec.encode(value)), ...(exponent && quantity(codec, value, exponent)) };
}

/** The value in its unit, or the refusal of it, and the name of the state that it stands for. */
function quantity({ units, absent }, value, exponent) {
  const state = absent?.nameOf(value) ?? null;
  let number = state === null || state === "out_of_range" ? value : null;
  try {
    if (units) number = units.inUnit(value, ...exponent);
  } catch (error) {
    if (error.name !== "CodecError") throw error;
    number = `!${error.reason}`;
  }
  return { quantity: toJson(number), state };
}

function parameter([setName, name]) {
  const set = Object.values(exports).find((value) => value?.setName === setName);
  return Object.values(set.parameters).flat().find((entry) => entry.name === name || entry.name.startsWith(`${name}[`));
}

function registerOf(name) {
  const entry = find(name, "address");
  return entry.decode === undefined ? entry.at(entry.first) : entry;
}

/** What has the unit and the states of a value: a register, a parameter, or those of a field of a record. */
function measured({ noun, path, key }) {
  if (noun === "register") return registerOf(path[0]);
  if (noun === "parameter") return parameter(path);
  const { units, absent } = find(path[0], "least");
  return { units: units[key], absent: absent?.[key] };
}

/** The state of a number that is read; of a field with several types, of that with the name in the path. */
function state(job) {
  const { absent, subindices, absentOf } = measured(job);
  const [, , chosen] = job.path;
  const own = () => (job.noun === "record" ? absent?.[chosen] : absentOf(subindices.find(({ name }) => name === chosen).indices[0][0]));
  return { state: (chosen === undefined ? absent : own())?.nameOf(fromJson(job.raw)) ?? null };
}

/** The count of a quantity; null for a value that has no unit. */
function count(job) {
  const units = measured(job).units ?? null;
  return { again: units === null ? null : toJson(units.fromUnit(job.quantity, ...job.exponent)) };
}

function share({ path: [name], raw, reference }) {
  const conversion = [exports[name], exports[`${name}Conversion`]].find((value) => value?.fromRaw !== undefined);
  return { quantity: toJson(conversion.fromRaw(fromJson(raw), reference)), state: null };
}

function answer(job) {
  try {
    if (job.kind === "quantity") return quantity(measured(job), fromJson(job.raw), job.exponent);
    if (job.kind === "count") return count(job);
    if (job.kind === "state") return state(job);
    if (job.kind === "share") return share(job);
    if (job.kind === "frame") return frame(job);
    if (job.kind === "record") return alone(find(job.path[0], "least"), job);
    if (job.kind === "register") return alone(registerOf(job.path[0]), job);
    if (job.kind === "parameter") return alone(parameter(job.path), job);
    return { error: [null, null] };
  } catch (error) {
    if (error.name !== "CodecError") return { raises: error.name, stack: `${JSON.stringify(job)}: ${error.stack}` };
    return { error: [error.reason, error.offset] };
  }
}

console.log(JSON.stringify(jobs.map(answer)));
