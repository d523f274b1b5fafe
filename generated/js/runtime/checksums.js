const TABLE = new Uint16Array(256);
for (let byte = 0; byte < 256; byte++) {
  let crc = byte;
  for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >> 1) ^ 0xa001 : crc >> 1;
  TABLE[byte] = crc;
}

/** CRC-16 with polynomial A001h, reflected, and initial value FFFFh, over the bytes from `start` to `stop`. */
export function crc16(bytes, start, stop) {
  let crc = 0xffff;
  for (let at = start; at < stop; at++) crc = (crc >> 8) ^ TABLE[(crc ^ bytes[at]) & 0xff];
  return crc;
}

/** The low byte of the sum of the bytes from `start` to `stop`. */
export function sum8(bytes, start, stop) {
  let sum = 0;
  for (let at = start; at < stop; at++) sum += bytes[at];
  return sum & 0xff;
}

/** The two's complement of the sum of the bytes from `start` to `stop`. */
export function lrc(bytes, start, stop) {
  return -sum8(bytes, start, stop) & 0xff;
}
