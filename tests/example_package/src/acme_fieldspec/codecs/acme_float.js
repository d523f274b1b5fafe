/** The number of a sign, a power of ten and 16 bits; null where the first byte has other bits. */
function decode(bytes) {
  const power = bytes[0] & 0x7f;
  if (power > 4) return null;
  const number = (bytes[1] * 256 + bytes[2]) * 10 ** power;
  return bytes[0] & 0x80 && number ? -number : number;
}

/** The bytes of the nearest number. */
function encode(number) {
  const magnitude = Math.abs(number);
  let [power, rest] = [0, magnitude];
  while (rest > 0xffff) {
    power++;
    rest = Math.floor((magnitude + 10 ** power / 2) / 10 ** power);
  }
  return [(number < 0 ? 0x80 : 0) | power, rest >> 8, rest & 0xff];
}
