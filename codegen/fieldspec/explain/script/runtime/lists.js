import { CodecError } from "./error.js";

/**
 * The byte in data of a size for a byte of their image, in which a list comes last that begins `first` bytes behind the
 * start, and that `behind` bytes follow. Data with fewer bytes than these are their own image.
 */
export function placeAround({ first, behind }, size, at) {
  if (at < first || size < first + behind) return at;
  return at >= first + behind ? at - behind : at + size - first - behind;
}

/** What `read(image, start, end)` makes of the image of a record. Throws CodecError with the place in the data. */
export function readAround(inner, read, bytes, offset, end) {
  const size = end - offset;
  const image = Uint8Array.from({ length: size }, (_, at) => bytes[offset + placeAround(inner, size, at)]);
  try {
    return read(image, 0, size);
  } catch (error) {
    if (!(error instanceof CodecError) || error.offset === null) throw error;
    throw new CodecError(error.reason, error.detail, offset + placeAround(inner, size, error.offset));
  }
}

/** Moves the list in the image of a record, the bytes from `start` to `end`, to where it is sent. */
export function placeList({ first, behind }, bytes, start, end) {
  const last = bytes.slice(start + first, start + first + behind);
  bytes.copyWithin(start + first, start + first + behind, end);
  bytes.set(last, end - behind);
}
