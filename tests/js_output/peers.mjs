// The generated modules talk with modbus-serial and jsmodbus over loopback, as a server and as a client of both.
// Arguments: the generated module, and the folder of the tools. Prints the conversations, all of which are asserted.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import net from "node:net";
import { once } from "node:events";
import { pathToFileURL } from "node:url";

const [module, tools] = process.argv.slice(2);
const station = await import(pathToFileURL(module));
const require = createRequire(pathToFileURL(`${tools}/`));
const ModbusSerial = require("modbus-serial");
const jsmodbus = require("jsmodbus");
const { tcp } = station;
const HOST = "127.0.0.1";

// ---- the generated code as a server ----

const SERVED = { registers: [50, 1, 0xffff, 4], coils: [1, 0, 0, 1, 1, 0, 0, 0, 0, 1] };

function packed(bits) {
  return Array.from({ length: Math.ceil(bits.length / 8) }, (_, at) => bits.slice(8 * at, 8 * at + 8).reduce((byte, bit, place) => byte | (bit << place), 0));
}

const unpacked = (bytes, count) => Array.from({ length: count }, (_, at) => (bytes[at >> 3] >> (at & 7)) & 1);

function answer({ message, data }) {
  const { registers, coils } = SERVED;
  const { address } = data;
  if (address >= 0x100) return null;
  switch (message.name) {
    case "read_registers":
      return { values: registers.slice(address, address + data.wordCount) };
    case "write_register":
      registers[address] = data.value;
      return data;
    case "write_registers":
      registers.splice(address, data.values.length, ...data.values);
      return { address, wordCount: data.values.length };
    case "read_coils":
      return { bits: packed(coils.slice(address, address + data.bitCount)) };
    case "write_coil":
      coils[address] = Number(data.value !== 0);
      return data;
    case "write_coils":
      coils.splice(address, data.bitCount, ...unpacked(data.bits, data.bitCount));
      return { address, bitCount: data.bitCount };
    default:
      throw new Error(message.name);
  }
}

async function serving() {
  const server = net.createServer((socket) => {
    const framer = station.tcpRequestFramer();
    socket.on("data", (bytes) => {
      for (const frame of framer.feed(bytes)) {
        const request = tcp.decodeRequest(frame);
        const data = answer(request);
        socket.write(data === null
          ? tcp.encodeExceptionResponse(request.header, request.message.code, { exceptionCode: 2 })
          : tcp.encodeResponse(request.header, request.message, data));
      }
    });
  });
  server.listen(0, HOST);
  await once(server, "listening");
  return server;
}

async function askedByModbusSerial(port) {
  const client = new ModbusSerial();
  await client.connectTCP(HOST, { port });
  client.setID(7);
  assert.deepEqual((await client.readHoldingRegisters(0, 4)).data, SERVED.registers);
  await client.writeRegister(1, 1234);
  await client.writeRegisters(2, [7, 8]);
  assert.deepEqual(SERVED.registers, [50, 1234, 7, 8]);
  assert.deepEqual((await client.readCoils(0, 10)).data.slice(0, 10).map(Number), SERVED.coils);
  await client.writeCoil(1, true);
  await client.writeCoils(2, [true, true, false]);
  assert.deepEqual(SERVED.coils.slice(0, 5), [1, 1, 1, 1, 0]);
  await assert.rejects(client.readHoldingRegisters(0x200, 1), { modbusCode: 2 });
  await new Promise((resolve) => { client.close(resolve); });
}

async function askedByJsmodbus(port) {
  const socket = net.connect(port, HOST);
  const client = new jsmodbus.client.TCP(socket, 7);
  await once(socket, "connect");
  const read = await client.readHoldingRegisters(0, 4);
  assert.deepEqual(read.response.body.valuesAsArray, SERVED.registers);
  await client.writeSingleRegister(1, 4321);
  await client.writeMultipleRegisters(2, [9, 10]);
  assert.deepEqual(SERVED.registers, [50, 4321, 9, 10]);
  const bits = await client.readCoils(0, 10);
  assert.deepEqual(bits.response.body.valuesAsArray.slice(0, 10).map(Number), SERVED.coils);
  await client.writeSingleCoil(0, false);
  await client.writeMultipleCoils(1, [false, true, true]);
  assert.deepEqual(SERVED.coils.slice(0, 4), [0, 0, 1, 1]);
  await assert.rejects(client.readHoldingRegisters(0x200, 1), (error) => error.response.body.code === 2);
  socket.end();
}

// ---- the generated code as a client ----

async function asking(port) {
  const socket = net.connect(port, HOST);
  await once(socket, "connect");
  const framer = station.tcpResponseFramer();
  let transaction = 0;
  return {
    async ask(message, data) {
      transaction += 1;
      socket.write(tcp.encodeRequest({ transaction, unitAddress: 1 }, message, data));
      for (;;) {
        const [bytes] = await once(socket, "data");
        const [frame] = framer.feed(bytes);
        if (!frame) continue;
        const response = tcp.decodeResponse(frame);
        assert.equal(response.header.transaction, transaction);
        return response.data;
      }
    },
    end: () => socket.end(),
  };
}

async function asked(port, registers) {
  const { ReadRegisters, WriteRegister, WriteRegisters, ReadCoils, WriteCoil } = station;
  const client = await asking(port);
  const before = registers();
  assert.deepEqual((await client.ask(ReadRegisters, { address: 0, wordCount: 3 })).values, before.slice(0, 3));
  await client.ask(WriteRegister, { address: 1, value: 777 });
  await client.ask(WriteRegisters, { address: 2, values: [31, 0xfffe] });
  assert.deepEqual(registers().slice(1, 4), [777, 31, 0xfffe]);
  await client.ask(WriteCoil, { address: 3, value: 0xff00 });
  assert.deepEqual(unpacked((await client.ask(ReadCoils, { address: 0, bitCount: 5 })).bits, 5), [0, 0, 0, 1, 0]);
  client.end();
}

async function askedOfModbusSerial() {
  const registers = [5, 6, 7, 8];
  const coils = Array(16).fill(false);
  const server = new ModbusSerial.ServerTCP({
    getHoldingRegister: (address) => registers[address],
    setRegister: (address, value) => { registers[address] = value; },
    getCoil: (address) => coils[address],
    setCoil: (address, value) => { coils[address] = value; },
  }, { host: HOST, port: 0, unitID: 1 });
  await once(server, "initialized");
  await asked(server._server.address().port, () => registers);
  await new Promise((resolve) => { server.close(resolve); });
}

async function askedOfJsmodbus() {
  const listener = net.createServer();
  const holding = Buffer.alloc(16);
  [5, 6, 7, 8].forEach((value, at) => holding.writeUInt16BE(value, 2 * at));
  const server = new jsmodbus.server.TCP(listener, { holding, coils: Buffer.alloc(4) });
  assert.equal(server.holding, holding);
  listener.listen(0, HOST);
  await once(listener, "listening");
  await asked(listener.address().port, () => [0, 1, 2, 3].map((at) => holding.readUInt16BE(2 * at)));
  listener.close();
}

const served = await serving();
await askedByModbusSerial(served.address().port);
await askedByJsmodbus(served.address().port);
served.close();
await askedOfModbusSerial();
await askedOfJsmodbus();
console.log("asked by modbus-serial, by jsmodbus; asked modbus-serial, jsmodbus");
process.exit(0);
