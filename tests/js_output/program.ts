// A program as users write it. The compiler checks its types, and it throws where a value is not as expected.
import { CodecError, type FrameOf } from "fieldspec-devices";
import { MoveRelative, MoveRelativeRequest, serial, serialResponseFramer } from "fieldspec-devices/esc11";
import { StatusWord1Positioning, Telegram111Response } from "fieldspec-devices/hiwin-e";
import { forVersion } from "fieldspec-devices/tc100";
import {
  ALARM_HISTORY, MOTION_COMMAND, MotionCommand, POINTS, ReadRegisters, WriteRegister, readRequests, readValue, rtu,
  writeRequests,
} from "fieldspec-devices/tc100/v2_0.js";

function expect(condition: boolean, text: string): void {
  if (!condition) throw new Error(text);
}

function hex(bytes: Uint8Array): string {
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join(" ");
}

// Frames
const frame = rtu.encodeRequest({ unitAddress: 1 }, ReadRegisters, { address: 0x1000, wordCount: 1 });
expect(hex(frame) === "01 03 10 00 00 01 80 ca", hex(frame));
const request = rtu.decodeRequest(frame);
if (request.name === "read_registers") {
  const address: number = request.data.address;
  expect(address === 0x1000, "address");
}
const reply = rtu.decodeResponse(new Uint8Array([1, 0x83, 2, 0xc0, 0xf1]));
expect(reply.kind === "exception" && reply.code === 3 && reply.data.exceptionCode === 2, "exception");
if (reply.kind === "response" && reply.name === "read_registers") {
  const values: readonly number[] = reply.data.values;
  expect(values.length > 0, "values");
}
const typed = rtu.decodeResponse(rtu.encodeResponse({ unitAddress: 1 }, ReadRegisters, { values: [1, 2] }), ReadRegisters);
expect(typed.kind === "response" && typed.data.values[1] === 2, "typed");
const message: FrameOf<typeof WriteRegister, "request", { readonly unitAddress: number }> | null = null;
expect(message === null, "a type alone");

// Registers
for (const { message: name, data } of writeRequests(MOTION_COMMAND, MotionCommand.JogNegative)) {
  expect(name === WriteRegister && "value" in data && data.value === MotionCommand.JogNegative, "write");
}
expect(readRequests(POINTS.at(1)).length === 1 && POINTS.at(1).words > 1, "table");
const command: number = readValue(MOTION_COMMAND, { values: [5] });
expect(command === 5 && ALARM_HISTORY.length === [...ALARM_HISTORY].length, "registers");

// Quantities, words of flags, streams
const distance = MoveRelativeRequest.units.distance.fromUnit("20.00");
expect(distance === 2000 && MoveRelativeRequest.units.distance.inUnit(-1234) === -12.34, "quantity");
const move = serial.encodeRequest({ unitAddress: 0 }, MoveRelative, { distance: Number(distance), speed: 50 });
expect(serial.decodeRequest(move).name === "move_relative", "move");
const telegram = Telegram111Response.decode(new Uint8Array([4, 0xbf, ...Array<number>(22).fill(0)]));
const status = StatusWord1Positioning.of(telegram.statusWord1);
expect(status.operationEnabled && status.alarm, "status");
expect(StatusWord1Positioning.raw({ alarm: false }, telegram.statusWord1) === (0x04bf & ~8), "raw");
const framer = serialResponseFramer();
expect(framer.feed(new Uint8Array([0xff, 4, 0])).length === 0, "half a frame");
expect(hex(framer.feed(new Uint8Array([3, 7]))[0] ?? new Uint8Array()) === "04 00 03 07" && framer.dropped === 1, "framer");

// Errors
try {
  rtu.decodeRequest(frame.slice(0, 7));
  expect(false, "not refused");
} catch (error) {
  expect(error instanceof CodecError && error.reason === "wrong_checksum" && error.offset === 5, String(error));
}
// @ts-expect-error a request needs all of its fields
expect(throws(() => rtu.encodeRequest({ unitAddress: 1 }, ReadRegisters, { address: 0x1000 })) === "missing_value", "fields");
// @ts-expect-error only members of the enum can be written
expect(throws(() => writeRequests(MOTION_COMMAND, 77)) === "unknown_value", "members");
// @ts-expect-error a header has a unit address
expect(throws(() => rtu.encodeRequest({ station: 1 }, ReadRegisters, { address: 0, wordCount: 1 })) === "unknown_field", "header");

function throws(action: () => unknown): string {
  try {
    action();
    return "";
  } catch (error) {
    if (error instanceof CodecError) return error.reason;
    throw error;
  }
}

const module = await forVersion("2.0");
expect(module.VERSION === "2.0" && module.DEVICE === "tc100", "version");
