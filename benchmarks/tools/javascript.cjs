// Times the generated JavaScript beside hand-written code and Kaitai Struct: node javascript.cjs MODULES POINT REQUEST
// MODULES is the folder of the generated modules, POINT and REQUEST are files that kaitai.js has printed. Prints a row of
// numbers for each comparison: name, peer, and the median of nanoseconds of both, and of their ratio.
const path = require("path");
const { pathToFileURL } = require("url");
const KaitaiStream = require("kaitai-struct/KaitaiStream");

const [modules, pointFile, requestFile] = process.argv.slice(2);
const ROUNDS = 25;
const LEAST = 8e6;
const MANY = 64;

function timed(action, number) {
  const start = process.cpuUsage();
  let sink = 0;
  for (let turn = 0; turn < number; turn++) sink += action(turn);
  const used = process.cpuUsage(start);
  if (sink === -1) console.log(sink);
  return ((used.user + used.system) * 1000) / number;
}

function enough(action) {
  let number = 1000;
  while (timed(action, number) * number < LEAST) number *= 2;
  return number;
}

// Once it has called several actions, no action is a part of the code of its loop.
for (let number = 2; number < 10; number++) timed(new Function("turn", `return turn % ${number}`), 100000);

const median = (numbers) => numbers.sort((a, b) => a - b)[numbers.length >> 1];

function row(name, ours, peer, theirs) {
  const [first, second] = [enough(ours), enough(theirs)];
  const pairs = Array.from({ length: ROUNDS }, (_, turn) => {
    if (turn % 2) return [timed(ours, first), timed(theirs, second)];
    const its = timed(theirs, second);
    return [timed(ours, first), its];
  });
  const numbers = [median(pairs.map(([a]) => a)), median(pairs.map(([, b]) => b)), median(pairs.map(([a, b]) => a / b))];
  console.log(JSON.stringify([name, peer, ...numbers]));
}

function crc16(bytes, stop) {
  let crc = 0xffff;
  for (let at = 0; at < stop; at++) {
    crc ^= bytes[at];
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >> 1) ^ 0xa001 : crc >> 1;
  }
  return crc;
}

function telegramByHand(view) {
  return {
    statusWord1: view.getUint16(0), positioningStatusWord1: view.getUint16(2), positioningStatusWord2: view.getUint16(4),
    statusWord2: view.getUint16(6), messageWord: view.getUint16(8), positionActualA: view.getInt32(10),
    speedActualB: view.getInt32(14), faultCode: view.getUint16(18), warningCode: view.getUint16(20),
  };
}

function telegramByShifts(bytes) {
  return {
    statusWord1: (bytes[0] << 8) | bytes[1], positioningStatusWord1: (bytes[2] << 8) | bytes[3],
    positioningStatusWord2: (bytes[4] << 8) | bytes[5], statusWord2: (bytes[6] << 8) | bytes[7],
    messageWord: (bytes[8] << 8) | bytes[9],
    positionActualA: (bytes[10] << 24) | (bytes[11] << 16) | (bytes[12] << 8) | bytes[13],
    speedActualB: (bytes[14] << 24) | (bytes[15] << 16) | (bytes[16] << 8) | bytes[17],
    faultCode: (bytes[18] << 8) | bytes[19], warningCode: (bytes[20] << 8) | bytes[21],
  };
}

function sumOfTelegram(value) {
  return value.statusWord1 + value.positioningStatusWord1 + value.positioningStatusWord2 + value.statusWord2 +
    value.messageWord + value.positionActualA + value.speedActualB + value.faultCode + value.warningCode;
}

function writeTelegramByHand(value, view) {
  view.setUint16(0, value.statusWord1);
  view.setUint16(2, value.positioningStatusWord1);
  view.setUint16(4, value.positioningStatusWord2);
  view.setUint16(6, value.statusWord2);
  view.setUint16(8, value.messageWord);
  view.setInt32(10, value.positionActualA);
  view.setInt32(14, value.speedActualB);
  view.setUint16(18, value.faultCode);
  view.setUint16(20, value.warningCode);
}

function telegramBytesByHand(value) {
  const bytes = new Uint8Array(24);
  bytes[0] = value.statusWord1 >> 8; bytes[1] = value.statusWord1;
  bytes[2] = value.positioningStatusWord1 >> 8; bytes[3] = value.positioningStatusWord1;
  bytes[4] = value.positioningStatusWord2 >> 8; bytes[5] = value.positioningStatusWord2;
  bytes[6] = value.statusWord2 >> 8; bytes[7] = value.statusWord2;
  bytes[8] = value.messageWord >> 8; bytes[9] = value.messageWord;
  bytes[10] = value.positionActualA >> 24; bytes[11] = value.positionActualA >> 16;
  bytes[12] = value.positionActualA >> 8; bytes[13] = value.positionActualA;
  bytes[14] = value.speedActualB >> 24; bytes[15] = value.speedActualB >> 16;
  bytes[16] = value.speedActualB >> 8; bytes[17] = value.speedActualB;
  bytes[18] = value.faultCode >> 8; bytes[19] = value.faultCode;
  bytes[20] = value.warningCode >> 8; bytes[21] = value.warningCode;
  return bytes;
}

(async () => {
  const load = (device) => import(pathToFileURL(path.join(modules, device, "index.js")));
  const [hiwin, ck10] = [await load("hiwin-e"), await load("ck10")];
  const { Point } = require(pointFile);
  const { Request } = require(requestFile);
  const telegram = hiwin.Telegram111Response;
  const frames = Array.from({ length: MANY }, (_, number) =>
    Uint8Array.from({ length: 24 }, (_, at) => (at < 22 ? (at * 7 + number * 13) & 255 : 0)));
  const views = frames.map((bytes) => new DataView(bytes.buffer));
  const values = frames.map((bytes) => telegram.decode(bytes));
  // With a single array to write into, V8 puts its address into the code of the peer, as in no program.
  const targets = frames.map(() => new Uint8Array(24));
  const targetViews = targets.map((bytes) => new DataView(bytes.buffer));
  row("decode telegram 111, nine fields read", (turn) => sumOfTelegram(telegram.decode(frames[turn % MANY])),
    "a reused DataView by hand", (turn) => sumOfTelegram(telegramByHand(views[turn % MANY])));
  row("decode telegram 111, nine fields read from bytes", (turn) => sumOfTelegram(telegram.decode(frames[turn % MANY])),
    "shifts by hand, unchecked", (turn) => sumOfTelegram(telegramByShifts(frames[turn % MANY])));
  // Where only the sum of the fields leaves the call, V8 makes no object on either side; most programs keep the value.
  const stored = new Array(MANY);
  row("decode telegram 111, value kept", (turn) => (stored[turn % MANY] = telegram.decode(frames[turn % MANY])).faultCode,
    "a reused DataView by hand", (turn) => (stored[turn % MANY] = telegramByHand(views[turn % MANY])).faultCode);
  row("encode telegram 111, all values checked", (turn) => telegram.encode(values[turn % MANY])[turn % 24],
    "shifts by hand, unchecked", (turn) => telegramBytesByHand(values[turn % MANY])[turn % 24]);
  row("write telegram 111 into bytes, all values checked", (turn) => {
    telegram.write(values[turn % MANY], targets[turn % MANY], 0);
    return targets[turn % MANY][turn % 24];
  }, "reused DataViews by hand, unchecked", (turn) => {
    writeTelegramByHand(values[turn % MANY], targetViews[turn % MANY]);
    return targets[turn % MANY][turn % 24];
  });
  const point = new Uint8Array(64);
  row("decode a point", () => ck10.Point.decode(point).position, "Kaitai Struct 0.11",
    () => new Point(new KaitaiStream(point.buffer)).position);
  const frame = ck10.rtu.encodeRequest({ unitAddress: 1 }, ck10.ReadRegisters, { address: 1000, wordCount: 2 });
  row("decode a frame", () => ck10.rtu.decodeRequest(frame).data.address, "Kaitai Struct 0.11, CRC by hand", () => {
    const request = new Request(new KaitaiStream(frame.buffer));
    return request.check === crc16(frame, 6) ? request.start : -2;
  });
})();
