import { CodecError } from "./error.js";

/** The bytes of a list, as its count in the image says. */
function countedBytes({ at, length, little, unit, plus = 0 }, image) {
  let number = 0;
  for (let place = 0; place < length; place++) number = number * 256 + image[at + (little ? length - 1 - place : place)];
  return (number - plus) * unit;
}

/**
 * The bytes of each list in some data; up to the first one for which they are not known, and why. In the image of a
 * record with `lists`, these come last, each at its `room`; the other fields have `fixed` bytes, `first` of them before
 * a list. It has `least` to `most` bytes, `element` for each element. At `at` in the image is the number of units of
 * `unit` bytes, plus `plus`; a `length` of 0 is that of the list whose size the data decide.
 */
export function sizesIn({ fixed, lists }, data) {
  const sizes = [];
  const image = [];
  let before = 0;
  for (const list of lists) {
    const at = list.first + before;
    const left = data.length - at - fixed + list.first;
    if (left < 0) return { sizes, fault: { reason: "incomplete", at: data.length } };
    image.push(...data.subarray(image.length + before, at));
    const size = list.length ? countedBytes(list, image) : left;
    const isWrong = size < list.least || size > list.most || size % list.element;
    if (list.length && isWrong) {
      return { sizes, fault: { reason: "wrong_measure", at: placeAround({ fixed, lists }, sizes, list.at) } };
    }
    if (size > left) return { sizes, fault: { reason: "incomplete", at: data.length } };
    sizes.push(size);
    before += size;
  }
  return { sizes, fault: null };
}

/** The byte in data, whose lists have some sizes, for a byte of their image. */
export function placeAround({ lists }, sizes, at) {
  let before = 0;
  for (const [number, { first, room, length, most }] of lists.entries()) {
    if (at >= room && (!length || at < room + most)) return first + before + at - room;
    if (at < first) return at + before;
    before += sizes[number] ?? 0;
  }
  return at + before;
}

/** The image of data whose lists have some sizes. */
function imageOf({ fixed, lists }, data, sizes) {
  const image = new Uint8Array(lists.at(-1).room + sizes.at(-1));
  let [before, at] = [0, 0];
  for (const [number, { first, room }] of lists.entries()) {
    image.set(data.subarray(at + before, first + before), at);
    image.set(data.subarray(first + before, first + before + sizes[number]), room);
    before += sizes[number];
    at = first;
  }
  image.set(data.subarray(at + before, fixed + before), at);
  return image;
}

/** What `read(image, start, end)` makes of the image of a record. Throws CodecError with the place in the data. */
export function readAround(inner, read, bytes, offset, end) {
  const data = bytes.subarray(offset, end);
  const { sizes, fault } = sizesIn(inner, data);
  if (fault) {
    throw new CodecError(fault.reason, `${inner.lists[sizes.length].name} has another number of bytes`, offset + fault.at);
  }
  const image = imageOf(inner, data, sizes);
  try {
    return read(image, 0, image.length);
  } catch (error) {
    if (!(error instanceof CodecError) || error.offset === null) throw error;
    throw new CodecError(error.reason, error.detail, offset + placeAround(inner, sizes, error.offset));
  }
}

/** What is sent of an image whose last list has `last` bytes. */
export function sentOfImage({ fixed, lists }, image, last) {
  const pieces = [];
  let at = 0;
  for (const list of lists) {
    const size = list.length ? countedBytes(list, image) : last;
    pieces.push(...image.subarray(at, list.first), ...image.subarray(list.room, list.room + size));
    at = list.first;
  }
  return Uint8Array.from([...pieces, ...image.subarray(at, fixed)]);
}
