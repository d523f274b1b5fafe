// Runs frames through generated modules, in Node and in browsers.

const hexOf = (bytes) => Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
const bytesOf = (digits) => Uint8Array.from(digits.match(/../g) ?? [], (pair) => parseInt(pair, 16));

/** A value as JSON of the tests: bigints, bytes and numbers that JSON does not have are objects with one key. */
function portable(value) {
  if (typeof value === "bigint") return { $n: String(value) };
  if (value instanceof Uint8Array) return { $b: hexOf(value) };
  if (typeof value === "number" && !Number.isFinite(value)) return { $f: String(value) };
  if (Object.is(value, -0)) return { $f: "-0" };
  if (Array.isArray(value)) return value.map(portable);
  if (typeof value === "object" && value !== null) {
    return Object.fromEntries(Object.entries(value).sort().map(([key, inner]) => [key, portable(inner)]));
  }
  return value;
}

function named(exports, key, name) {
  return Object.values(exports).find((value) => value?.[key] !== undefined && value.name === name);
}

function outcome(action) {
  try {
    return { value: action() };
  } catch (error) {
    if (error.name !== "CodecError") throw error;
    return { error: [error.reason, error.offset] };
  }
}

/** What a module makes of the frame of a job: its values, and the frame that these give, or the error. */
export function judge(exports, job) {
  const link = named(exports, "encodeRequest", job.link);
  const message = link.messages.find((entry) => entry.name === job.message);
  const frame = bytesOf(job.frame);
  const read = () => (job.direction === "request" ? link.decodeRequest(frame, message) : link.decodeResponse(frame, message));
  const have = outcome(read);
  if (have.error) return { error: have.error };
  const { kind, header, data } = have.value;
  const result = { value: { kind, message: have.value.message?.name ?? null, header: portable(header), data: portable(data) } };
  const again = outcome(() =>
    kind === "exception"
      ? link.encodeExceptionResponse(header, job.coded ? have.value.code : null, data)
      : kind === "request"
        ? link.encodeRequest(header, have.value.message, data)
        : link.encodeResponse(header, have.value.message, data),
  );
  result.again = again.error ? again.error[0] : hexOf(again.value);
  return result;
}
