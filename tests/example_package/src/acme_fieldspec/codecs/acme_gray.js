/** The position of an encoder whose tracks are two bytes. */
function decode(bytes) {
  let number = bytes[0] * 256 + bytes[1];
  for (const shift of [8, 4, 2, 1]) number ^= number >> shift;
  return number;
}

/** The tracks of a position. */
function encode(number) {
  const tracks = number ^ (number >> 1);
  return [tracks >> 8, tracks & 0xff];
}
