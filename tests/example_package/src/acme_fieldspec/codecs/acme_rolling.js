/** The sum of some bytes, turned by three bits before each. */
function checksum(bytes) {
  let total = 0x5aa5;
  for (const byte of bytes) {
    total = ((total << 3) | (total >> 13)) & 0xffff;
    total = (total + byte) & 0xffff;
  }
  return total;
}
