import { CodecError } from "./error.js";
import { digitsOfNumber, numberOfDigits } from "./widths.js";

/** The number in the bits of a number that count the elements of a field. */
const countInBits = ({ mask }, number) => ((Number(number) & mask) >>> 0) / ((mask & -mask) >>> 0);

/** Whether the bits of a number, any of them where there are no `numbers`, say that something is sent. */
function isMet({ mask, numbers }, number) {
  const bits = (Number(number) & mask) >>> 0;
  return numbers.length ? numbers.includes(bits) : bits > 0;
}

/** Whether a number is right about how many elements a field has. */
export function fits(presence, number, elements) {
  const { numbers, unit, plus } = presence;
  return numbers ? isMet(presence, number) === elements > 0 : countInBits(presence, number) === elements * unit + plus;
}

/** What the bits that count elements should contain. */
export const bitsText = ({ mask }, content) => `${content} in bits ${31 - Math.clz32(mask & -mask)}..${31 - Math.clz32(mask)}`;

/** The bytes in the image of a list that does not end with the data, as its count in some bytes says. */
function countedBytes(list, bytes) {
  const { length, unit, plus = 0, most, element, presence, more } = list;
  if (!length) return more ? element : most;
  let number = listNumber(list, bytes);
  if (presence?.numbers) return isMet(presence, number) ? element : 0;
  if (presence) number = countInBits(presence, number);
  return (number - plus) * unit;
}

/** The number at a place, of up to four bytes or of digits; NaN for what are no digits. */
function listNumber({ at, length, little, digits }, bytes) {
  let number = 0;
  if (digits) return numberOfDigits(digits, bytes.slice(at, at + length));
  for (let place = 0; place < length; place++) number = number * 256 + bytes[at + (little ? length - 1 - place : place)];
  return number;
}

/** The sent bytes that a number in sent bytes counts, or bits of it. */
function sentNumber(list, bytes) {
  const number = listNumber(list, bytes);
  return (list.presence ? countInBits(list.presence, number) : number) - list.sentPlus;
}

/** The sent bytes of a list that a number in sent bytes counts; undefined where that cannot be right. */
function measuredBytes(list, bytes) {
  const size = sentNumber(list, bytes);
  return size >= 0 && size <= list.most ? size : undefined;
}

/** Some bytes with another number in the field that counts a list; bits that count it stay. */
function setListNumber({ name, at, length, little, digits, presence }, bytes, number) {
  if (presence) return;
  const limit = (digits ? digits === "decimal" ? 10 : 16 : 256) ** length;
  if (number < 0 || number >= limit) throw new CodecError("out_of_range", `${name} has more bytes than a field can count`);
  if (digits) return void bytes.set(digitsOfNumber(digits, number, length), at);
  for (let place = 0; place < length; place++) bytes[at + (little ? place : length - 1 - place)] = number / 256 ** place & 255;
}

/** Whether another element follows one with some bytes. */
export const follows = (more, bytes) => isMet(more, listNumber(more, bytes));

/** How many elements a list with a first one has, each of which says whether another one follows, in an image. */
export function elementsInImage({ element, most, more }, image, start) {
  let count = 1;
  while (count * element < most && follows(more, image.subarray(start + (count - 1) * element, start + count * element))) count++;
  return count;
}

/** The number that decides an element, or its bits that do. */
function decidingNumber({ at, length, little, mask }, bytes) {
  let number = 0n;
  for (let place = 0; place < length; place++) {
    number = (number << 8n) | BigInt(bytes[at + (little ? length - 1 - place : place)]);
  }
  return String(mask === undefined ? number : number & BigInt(mask));
}

/** The bytes of an element that another field decides; undefined where that decides nothing. */
const decidedBytes = (decision, bytes) => decision.sizes[decidingNumber(decision, bytes)];

/** Whether an element is bytes of varying length, which have a mark after them in the image. */
const isMarked = (decision, bytes) => !!decision.marked?.includes(Number(decidingNumber(decision, bytes)));

/** The sent bytes of an element that another field decides, which a number may count; why they are not known. */
function decidedExtent(inner, list, fields, extents) {
  const size = decidedBytes(list.decision, fields);
  if (size === undefined) return { fault: { reason: "unknown_value", at: placeAround(inner, extents, list.decision.at) } };
  const number = list.sentPlus === undefined ? size : sentNumber(list, fields);
  if (number < Math.max(size, 0) || number > Math.abs(size)) return { fault: numberFault(inner, extents, list) };
  const hasMark = isMarked(list.decision, fields);
  return { size: number, elements: [number], isText: size < 0 && !hasMark, hasMark };
}

const isRight = ({ least, most, element }, size) => size >= least && size <= most && size % element === 0;

/** The bytes that are sent for `size` bytes of the image of a list, of elements that do not differ in size. */
const sentListBytes = ({ element, packing }, size) => packing ? Math.ceil(size / element * packing.bits / 8) : size;

/** The first byte with bits of a packed number, and the one after the last. */
export const packedPlace = ({ bits }, index) => [Math.floor(index * bits / 8), Math.ceil((index + 1) * bits / 8)];

/** How many numbers some bytes of a packed list have room for, at most all that it may have. */
const numbersIn = ({ element, most, packing }, size) => Math.min(Math.floor(8 * size / packing.bits), most / element);

/** The image of a packed number, from the bytes with bits of it. */
export function unpackedNumber({ bits, little, signed }, bytes, index, size) {
  let number = 0;
  for (let bit = 0; bit < bits; bit++) {
    const place = index * bits % 8 + bit;
    const content = bytes[place >> 3] >> (little ? place & 7 : 7 - (place & 7)) & 1;
    number = little ? number + content * 2 ** bit : number * 2 + content;
  }
  if (signed && number >= 2 ** (bits - 1)) number -= 2 ** bits;
  return Uint8Array.from({ length: size }, (_, at) => number >> 8 * (little ? at : size - 1 - at) & 255);
}

/** The image of the numbers of a packed list. */
function unpackedList({ element, packing }, bytes, numbers) {
  const image = new Uint8Array(numbers * element);
  for (let index = 0; index < numbers; index++) {
    const own = bytes.subarray(...packedPlace(packing, index));
    image.set(unpackedNumber(packing, own, index, element), index * element);
  }
  return image;
}

/** What is sent of the image of a packed list. */
function packedList({ element, packing: { bits, little } }, image) {
  const bytes = new Uint8Array(Math.ceil(image.length / element * bits / 8));
  for (let place = 0; place < image.length / element * bits; place++) {
    const [index, bit] = [Math.floor(place / bits), place % bits];
    const own = little ? bit : bits - 1 - bit;
    const byte = image[index * element + (little ? own >> 3 : element - 1 - (own >> 3))];
    bytes[place >> 3] |= (byte >> (own & 7) & 1) << (little ? place & 7 : 7 - (place & 7));
  }
  return bytes;
}

/** The bytes of an element that some bytes begin with, maybe more than there are, or why they are not known. */
function elementIn(parts, bytes) {
  const extents = [];
  const fields = [];
  let before = 0;
  for (const list of parts.lists) {
    const at = list.first + before;
    if (bytes.length < at) break;
    fields.push(...bytes.subarray(fields.length + before, at));
    const extent = extentAt(parts, extents, fields, bytes, at, bytes.length, false);
    if (extent.fault) return extent;
    extents.push(extent);
    before += extent.size;
  }
  return { size: parts.fixed + before };
}

/**
 * The bytes of the list after those that have `extents`, maybe more than there are up to `end`, or why they are not known.
 * The data decide where the last one ends.
 */
function extentAt(inner, extents, image, data, at, end, isLast) {
  const list = inner.lists[extents.length];
  if (list.digits && Number.isNaN(listNumber(list, image))) {
    return { fault: { reason: "unknown_value", at: placeAround(inner, extents, list.at) } };
  }
  if (list.decision) return decidedExtent(inner, list, image, extents);
  const isOpen = isLast && !list.more;
  const isMeasured = list.sentPlus !== undefined;
  const size = isMeasured ? measuredBytes(list, image) : isOpen ? null : sizeIn(list, image);
  if (size === undefined || (isMeasured && isLast && at + size !== end)) return { fault: numberFault(inner, extents, list) };
  if (isMeasured && at + size <= end) return measuredIn(inner, list, data.subarray(at, at + size), at, extents);
  if (list.parts && !isMeasured) return elementsIn(list, data.subarray(at, end), size, at);
  return { size: size === null ? end - at : sentListBytes(list, size), elements: [] };
}

/** The bytes of a list that does not end with the data, as an image says; undefined where that cannot be right. */
function sizeIn(list, image) {
  const size = countedBytes(list, image);
  return isRight(list, size) ? size : undefined;
}

/** Why nobody knows the bytes of a list. */
function numberFault(inner, extents, { at }) {
  return { reason: "wrong_measure", at: placeAround(inner, extents, at) };
}

/** The bytes of an element that some bytes begin with, as `parts` tell them; -1 for a wrong count. */
export function elementBytes(parts, bytes) {
  const { size, fault } = elementIn(parts, bytes);
  return fault ? -1 : size;
}

/** The bytes of each element of a list whose elements differ in size, or why they are not known. */
function elementsIn(list, data, size, start) {
  const { more } = list;
  const elements = [];
  let at = 0;
  while (size === null ? at < data.length : elements.length * list.element < size) {
    if (elements.length * list.element === list.most) return { fault: { reason: "wrong_length", at: start + at } };
    const own = elementIn(list.parts, data.subarray(at));
    if (own.fault) return { fault: { reason: own.fault.reason, at: start + at + own.fault.at } };
    if (at + own.size > data.length) return { fault: { reason: "incomplete", at: start + data.length } };
    elements.push(own.size);
    if (more && follows(more, data.subarray(at, at + own.size))) {
      if (size === list.most) return { fault: { reason: "wrong_measure", at: start + at + more.at } };
      size += list.element;
    }
    at += own.size;
  }
  if (elements.length * list.element < list.least) return { fault: { reason: "incomplete", at: start + at } };
  return { size: at, elements };
}

/** The elements of a list in all of the bytes that a number counts, which is wrong if they end otherwise. */
function measuredIn(inner, list, data, start, extents) {
  const extent = elementsIn(list, data, null, start);
  const { reason } = extent.fault ?? {};
  return reason === "incomplete" || reason === "wrong_length" ? { fault: numberFault(inner, extents, list) } : extent;
}

/**
 * The bytes of each list in some data, and of its elements where these differ; up to the first one for which they are
 * not known, and why. In the image of a record with `lists`, these come last, each at its `room`; the other fields have
 * `fixed` bytes, `first` of them before a list. It has `least` to `most` bytes there, `element` for each element. At `at`
 * in the image is the number of units of `unit` bytes, plus `plus`, as `digits` or binary; a `length` of 0 is that of a list that always has
 * `most` bytes. The data decide the size of the last one. `parts` tell the size of an element where elements differ, a
 * `decision` that of the only element. With a `packing`, numbers have fewer bits than in the image. With a `presence`,
 * bits of the number say whether the only element is sent, or have the count. With a `sentPlus`, the number is that of
 * the sent bytes, plus `sentPlus`, and only in the image that of units. With `more`, bits of each element say whether
 * another one follows, and the number is that of the first one.
 */
export function extentsIn({ fixed, lists }, data) {
  const extents = [];
  const image = [];
  let before = 0;
  for (const list of lists) {
    const at = list.first + before;
    const end = data.length - fixed + list.first;
    const left = end - at;
    if (left < 0) return { extents, fault: { reason: "incomplete", at: data.length } };
    image.push(...data.subarray(image.length + before, at));
    const isLast = list === lists.at(-1);
    const extent = extentAt({ fixed, lists }, extents, image, data, at, end, isLast);
    if (extent.fault) return { extents, fault: extent.fault };
    if (extent.size > left) return { extents, fault: { reason: "incomplete", at: data.length } };
    if (list.packing) {
      extent.numbers = numbersIn(list, extent.size);
      const taken = sentListBytes(list, extent.numbers * list.element);
      if (isLast && extent.numbers * list.element < list.least) return { extents, fault: { reason: "incomplete", at: at + left } };
      if (isLast && taken < left) return { extents, fault: { reason: "wrong_length", at: at + taken } };
    }
    if (isLast && extent.size < left) return { extents, fault: { reason: "wrong_length", at: at + extent.size } };
    extents.push(extent);
    before += extent.size;
  }
  return { extents, fault: null };
}

/** The byte in data, whose lists have some extents, for a byte of their image. */
export function placeAround({ lists }, extents, at) {
  let before = 0;
  for (const [number, { first, room, most, element, parts, decision, packing }] of lists.entries()) {
    const { size, elements } = extents[number] ?? { size: 0, elements: [] };
    if (at >= room && (number === lists.length - 1 || at < room + most)) {
      if (packing) return first + before + packedPlace(packing, Math.floor((at - room) / element))[0];
      const index = parts || decision ? Math.floor((at - room) / element) : 0;
      return first + before + at - room - index * element + sumOf(elements.slice(0, index));
    }
    if (at < first) return at + before;
    before += size;
  }
  return at + before;
}

const sumOf = (numbers) => numbers.reduce((sum, number) => sum + number, 0);

/** The image of data whose lists have some extents. */
function imageOf({ fixed, lists }, data, extents) {
  const last = extents.at(-1);
  const { room, element, parts, decision, packing } = lists.at(-1);
  const numbers = packing ? last.numbers : last.elements.length;
  const image = new Uint8Array(room + (parts || decision || packing ? numbers * element : last.size));
  let [before, at] = [0, 0];
  for (const [number, list] of lists.entries()) {
    const { size, elements } = extents[number];
    image.set(data.subarray(at + before, list.first + before), at);
    let from = list.first + before;
    if (list.packing) image.set(unpackedList(list, data.subarray(from, from + size), extents[number].numbers), list.room);
    else for (const [index, own] of (elements.length ? elements : [size]).entries()) {
      image.set(data.subarray(from, from + own), list.room + index * list.element);
      if (extents[number].hasMark) image[list.room + own] = 1;
      from += own;
    }
    before += size;
    at = list.first;
  }
  image.set(data.subarray(at + before, fixed + before), at);
  for (const [number, list] of lists.entries()) {
    if (list.sentPlus !== undefined) setListNumber(list, image, extents[number].elements.length);
  }
  return image;
}

/** Throws CodecError for a zero in a text, unless the last list has a wrong number of bytes, which is refused before. */
function refuseZeros({ lists }, extents, data, offset) {
  const { parts, decision, packing } = lists.at(-1);
  if (!parts && !decision && !packing && !isRight(lists.at(-1), extents.at(-1).size)) return;
  let before = 0;
  for (const [number, { size, isText }] of extents.entries()) {
    const { name, first } = lists[number];
    const at = first + before;
    if (isText && data.subarray(at, at + size).includes(0)) throw new CodecError("unknown_value", `${name} has a zero`, offset + at);
    before += size;
  }
}

/** What `read(image, start, end)` makes of the image of a record. Throws CodecError with the place in the data. */
export function readAround(inner, read, bytes, offset, end) {
  const data = bytes.subarray(offset, end);
  const { extents, fault } = extentsIn(inner, data);
  if (fault) {
    const { name } = inner.lists[extents.length];
    throw new CodecError(fault.reason, `${name} has a different number of bytes`, offset + fault.at);
  }
  refuseZeros(inner, extents, data, offset);
  const image = imageOf(inner, data, extents);
  try {
    return read(image, 0, image.length);
  } catch (error) {
    if (!(error instanceof CodecError) || error.offset === null) throw error;
    throw new CodecError(error.reason, error.detail, offset + placeAround(inner, extents, error.offset));
  }
}

/** How many bytes come before the mark, or of a text before the zeros after it. */
function sizeInRoom(image, hasMark) {
  if (hasMark) return image.lastIndexOf(1);
  let size = image.length;
  while (size > 0 && image[size - 1] === 0) size--;
  return size;
}

/** What is sent of an image whose last list has `last` bytes there. */
export function sentOfImage({ fixed, lists }, image, last) {
  const fields = image.slice(0, fixed);
  const lengths = lists.map((list) => {
    const decided = list.decision && (decidedBytes(list.decision, image) ?? 0);
    if (decided < 0) return sizeInRoom(image.subarray(list.room, list.room + list.element), isMarked(list.decision, image));
    if (decided !== undefined || list === lists.at(-1)) return decided ?? last;
    return countedBytes(list, image) * (list.more ? elementsInImage(list, image, list.room) : 1);
  });
  const pieces = lists.map((list, index) => sentOfList(list, image.subarray(list.room, list.room + lengths[index])));
  for (const [index, list] of lists.entries()) {
    if (list.sentPlus === undefined) continue;
    const size = pieces[index].length;
    if (list.presence && sentNumber(list, fields) !== size) {
      throw new CodecError("wrong_measure", `bits of ${list.countName} do not count the ${size} bytes of ${list.name}`);
    }
    setListNumber(list, fields, size + list.sentPlus);
  }
  const ends = [...lists.map(({ first }) => first), fixed];
  const sent = ends.flatMap((end, index) => [...fields.subarray(ends[index - 1] ?? 0, end), ...(pieces[index] ?? [])]);
  return Uint8Array.from(sent);
}

/** What is sent of a list that has some bytes in the image. */
function sentOfList(list, image) {
  const { element, parts, packing } = list;
  if (packing) return [...packedList(list, image)];
  if (!parts) return [...image];
  const sent = [];
  for (let from = 0; from < image.length; from += element) {
    const own = image.subarray(from, from + element);
    sent.push(...own.subarray(0, elementBytes(parts, own)));
  }
  return sent;
}

/**
 * The bytes of the elements of a list, each of which has a codec. Throws CodecError for what is none. An element that
 * cannot be written counts as the longest one: whoever writes the fields before it refuses these first.
 */
export function elementsLength(items, codec) {
  return items.reduce((sum, item) => sum + sizeOrMost(item, codec), 0);
}

function sizeOrMost(item, codec) {
  try {
    codec.check(item);
    return codec.size(item);
  } catch (error) {
    if (!(error instanceof CodecError)) throw error;
    return codec.most;
  }
}
