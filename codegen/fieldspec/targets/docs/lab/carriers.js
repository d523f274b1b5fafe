// What carries bytes to a device and back: a serial port of the browser, or the WebSocket of a simulated device.
// `received` is called with bytes, `faulted` with what was wrong on the line, `ended` with the reason of the end.

const OWN_MACHINE = /^ws:\/\/(?:localhost|127\.0\.0\.1)(?::\d{1,5})?\//;
const OPENING = 5000;  // milliseconds

class ConnectionFault extends Error {}

class SocketCarrier {
  static opened(address, events) {
    if (!OWN_MACHINE.test(address)) {
      throw new ConnectionFault("The address begins with ws://127.0.0.1 or ws://localhost, as the simulator prints it.");
    }
    return new Promise((resolve, reject) => {
      const socket = new WebSocket(address);
      const fail = () => reject(new ConnectionFault("No response from this address. Is the simulator running, and is the key from its last start?"));
      const timer = setTimeout(() => { socket.close(); fail(); }, OPENING);
      socket.binaryType = "arraybuffer";
      socket.addEventListener("open", () => {
        clearTimeout(timer);
        resolve(new SocketCarrier(socket, address, events));
      });
      socket.addEventListener("close", () => { clearTimeout(timer); fail(); });
    });
  }

  constructor(socket, address, events) {
    this.socket = socket;
    this.link = decodeURIComponent(new URL(address).pathname.slice(1));
    this.name = `the simulated device at ${new URL(address).host}`;
    socket.addEventListener("message", ({ data }) => {
      if (data instanceof ArrayBuffer) events.received(new Uint8Array(data));
    });
    socket.addEventListener("close", () => events.ended("The simulator has closed the connection."));
  }

  send(bytes) {
    if (this.socket.readyState !== WebSocket.OPEN) throw new ConnectionFault("The connection is closed.");
    this.socket.send(bytes);
  }

  close() {
    this.socket.close();
  }
}

class SerialCarrier {
  static async opened(settings, events) {
    try {
      const port = await navigator.serial.requestPort();
      await port.open({ ...settings, bufferSize: 4096 });
      return new SerialCarrier(port, events);
    } catch (error) {
      if (error.name === "NotFoundError") throw new ConnectionFault("No port was chosen.");
      throw new ConnectionFault(`The port cannot be opened: ${error.message}`);
    }
  }

  constructor(port, events) {
    this.port = port;
    this.link = "";
    this.name = "the serial port";
    this.events = events;
    this.isOpen = true;
    this.reading = this.read();
  }

  // A wrong parity or a break ends the reader, and the port has a new one; a port that is gone has none.
  async read() {
    while (this.isOpen && this.port.readable) {
      this.reader = this.port.readable.getReader();
      try {
        for (;;) {
          const { value, done } = await this.reader.read();
          if (done) break;
          this.events.received(value);
        }
      } catch (error) {
        if (this.isOpen && this.port.readable) this.events.faulted(`On the line: ${error.message}`);
      } finally {
        this.reader.releaseLock();
      }
    }
    if (this.isOpen) {
      this.isOpen = false;
      this.events.ended("The serial port is gone.");
    }
  }

  async send(bytes) {
    if (!this.port.writable) throw new ConnectionFault("The serial port is gone.");
    const writer = this.port.writable.getWriter();
    try {
      await writer.write(bytes);
    } catch (error) {
      throw new ConnectionFault(`The request cannot be sent: ${error.message}`);
    } finally {
      writer.releaseLock();
    }
  }

  async close() {
    if (!this.isOpen) return;
    this.isOpen = false;
    await this.reader.cancel().catch(() => {});
    await this.reading;
    await this.port.close().catch(() => {});
    this.events.ended("Not connected.");
  }
}
