// Words of bits in the form: what an entry begins with, and what it becomes when a box is ticked.

// The number of an entered word; undefined while the entry has no meaning.
const wordNumber = (device, value, text) => {
  try {
    return BigInt(rawOf(device, value.flags, value, text));
  } catch (error) {
    if (error instanceof CodecError) return undefined;
    throw error;
  }
};

// The defaults of the bits of a word; nothing where one has to be entered.
const initialWord = (device, value) => {
  const raw = wordNumber(device, value, "");
  return raw === undefined ? "" : entryOf(device, value, raw);
};

const namesInWord = (text) => text.split(/[, ]+/).filter(Boolean);

// Whether a bit is set in an entry: in its number, or by its name while the entry has no meaning yet.
const isBitSet = (raw, text, bit) => (raw === undefined ? namesInWord(text).includes(bit.name) : Boolean(raw & bitMask(bit)));

// The entry of a word with one bit changed: a number, or names while it has no meaning yet.
const wordWithBit = (device, value, text, { bit, name }, isSet) => {
  const raw = wordNumber(device, value, text);
  if (raw === undefined) {
    const others = namesInWord(text).filter((item) => item !== name);
    return [...others, ...(isSet ? [name] : [])].join(", ");
  }
  const mask = 1n << BigInt(bit);
  return entryOf(device, value, isSet ? raw | mask : raw & ~mask);
};
