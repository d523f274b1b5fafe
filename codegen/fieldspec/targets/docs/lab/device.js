// The panel of a device that is connected: it sends the request of the page, and explains what comes.

const MOST_TRAFFIC = 200;  // lines
const BAUD = [1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600];

class DevicePanel {
  constructor(lab) {
    this.lab = lab;
    this.exchange = new Exchange();
    this.link = null;
    this.lines = [];
    if (!("serial" in navigator)) {
      const choice = byId("carrier").querySelector("[value=serial]");
      choice.disabled = true;
      choice.textContent += ": this browser has none";
    }
    byId("carrier").addEventListener("change", () => this.update());
    byId("connect").addEventListener("click", () => this.toggle());
    byId("allow-writes").addEventListener("change", () => this.update());
    byId("send").addEventListener("click", () => this.send());
    byId("traffic-log").addEventListener("click", () => this.explainTraffic());
  }

  // ---- the connection ----

  async toggle() {
    const { carrier } = this.exchange;
    if (carrier) {
      await carrier.close();
      return;
    }
    byId("exchange-fault").textContent = "";
    byId("connect").disabled = true;
    this.say("Connecting …");
    const events = {
      received: (bytes) => this.exchange.received(bytes),
      faulted: (text) => this.fault(text),
      ended: (reason) => this.end(reason),
    };
    try {
      const isSerial = byId("carrier").value === "serial";
      this.exchange.carrier = await (isSerial
        ? SerialCarrier.opened(this.settings(), events)
        : SocketCarrier.opened(byId("socket-address").value.trim(), events));
      this.say(`Connected to ${this.exchange.carrier.name}.`);
    } catch (error) {
      if (!(error instanceof ConnectionFault)) throw error;
      this.say("Not connected.");
      this.fault(error.message);
    } finally {
      byId("connect").disabled = false;
      byId("allow-writes").checked = false;  // each connection is agreed to anew
      this.update();
    }
  }

  end(reason) {
    if (!this.exchange.carrier) return;
    this.exchange.carrier = null;
    this.exchange.finish(reason);
    byId("allow-writes").checked = false;
    this.say(reason);
    this.update();
  }

  settings() {
    const number = (id) => Number(byId(id).value);
    return { baudRate: number("baud"), dataBits: number("data-bits"), parity: byId("parity").value, stopBits: number("stop-bits") };
  }

  say(text) {
    byId("connection").textContent = text;
  }

  fault(text) {
    byId("exchange-fault").textContent = text;
  }

  // ---- the request ----

  // The request of the page; null where what is there is none.
  request() {
    const { current } = this.lab;
    if (!current || this.lab.isEntryRefused || current.explanation.direction !== "request" || current.explanation.reasons.length) return null;
    return current.explanation;
  }

  onlyReads({ link, message }) {
    return this.lab.requests.reads[link].includes(message) && !this.hazards("read").length;
  }

  // What the spec says of an operation on the facts of the request, one text for each hazard.
  hazards(operation) {
    const { rows, registers, message } = this.request();
    const names = new Map([...rows, ...registers].map((row) => [row.fact, row.path]));
    names.set(this.lab.device.messages.get(message)?.path, message);
    return Object.entries(this.lab.requests.hazards[operation]).flatMap(([text, paths]) => {
      const present = paths.filter((path) => names.has(path)).map((path) => names.get(path));
      return present.length ? [`${present.join(", ")}: ${text}`] : [];
    });
  }

  update() {
    const { carrier } = this.exchange;
    const isSerial = byId("carrier").value === "serial";
    byId("connect").textContent = carrier ? "Disconnect" : "Connect";
    for (const id of ["carrier", "socket-address", "baud", "data-bits", "parity", "stop-bits"]) byId(id).disabled = Boolean(carrier);
    byId("socket-choice").hidden = isSerial;
    byId("serial-choice").hidden = !isSerial;
    const request = this.request();
    this.fillSettings(request?.link ?? [...this.lab.device.links.keys()][0]);
    const writes = request !== null && !this.onlyReads(request);
    const isAllowed = !writes || byId("allow-writes").checked;
    const texts = writes ? [...this.hazards("write"), ...this.hazards("read")] : [];
    byId("hazards").replaceChildren(...texts.map((text) => element("li", { textContent: text })));
    byId("send-remark").textContent = this.remark(request, writes, isAllowed);
    byId("send").disabled = !carrier || !request || !isAllowed || Boolean(this.exchange.waiting) || this.isElsewhere(request);
  }

  isElsewhere(request) {
    const link = this.exchange.carrier?.link;
    return Boolean(request && link && link !== request.link);
  }

  remark(request, writes, isAllowed) {
    if (this.lab.isEntryRefused) return "What is entered in the form makes no frame, so nothing is sent.";
    if (!request) return "There is no valid request above. Paste one, or build it.";
    if (this.isElsewhere(request)) return `The request is one of the link ${request.link}, and the connection is to ${this.exchange.carrier.link}.`;
    const name = request.message || "The request";
    if (!writes) return `${name} only reads.`;
    const why = this.lab.requests.reads[request.link].includes(request.message) ? "changes what it reads" : "writes, or the spec does not say that it only reads";
    return `${name} ${why}. ${isAllowed ? "It is sent as it is." : "Allow it to be sent."}`;
  }

  fillSettings(name) {
    if (this.link === name) return;
    this.link = name;
    const { serial = {} } = this.lab.device.links.get(name);
    const fill = (id, values, chosen) => {
      byId(id).replaceChildren(...values.map((value) => option(String(value), String(value))));
      byId(id).value = String(chosen ?? values[0]);
    };
    const bauds = serial.baud?.length ? serial.baud : BAUD;
    fill("baud", bauds, serial.default ?? (serial.baud?.length ? bauds[0] : 9600));
    fill("data-bits", serial.dataBits?.length ? serial.dataBits : [7, 8], Math.max(...(serial.dataBits?.length ? serial.dataBits : [8])));
    fill("parity", serial.parity?.length ? serial.parity : ["none", "even", "odd"]);
    fill("stop-bits", serial.stopBits?.length ? serial.stopBits : [1, 2]);
  }

  // Whether the device answers a request: not one to all stations, and not one without a response.
  isAnswered(request) {
    const link = this.lab.device.links.get(request.link);
    const broadcast = link.addresses?.broadcast;
    const station = link.request.header.find(({ role }) => role === "unit_address");
    if (broadcast !== undefined && station && request.values.get(station.name) === broadcast) return false;
    return !request.message || link.carriedMessages.response.has(request.message);
  }

  async send() {
    const { device } = this.lab;
    const request = this.request();
    if (!request || !this.exchange.carrier || byId("send").disabled) return;
    const { exchange } = this;
    const stray = exchange.stray;
    const patience = Math.min(60000, Math.max(50, Number(byId("patience").value) || 1000));
    const isAnswered = this.isAnswered(request);
    const asked = { request, sure: true };
    const readAnswer = (data) => readFrame(device, data, new FrameOptions({}), "response", asked);
    this.fault("");
    this.say("Waiting for the answer …");
    this.note("TX", request.frame);
    const asking = exchange.ask(request.frame, (data) => !readAnswer(data).explanation.reasons.length, isAnswered ? patience : QUIET);
    this.update();
    const { data, milliseconds, lost } = await asking;
    if (data.length) this.note("RX", data);
    const texts = [stray ? `${stray} unrequested bytes came before.` : "", lost];
    if (data.length) texts.push(this.show(readAnswer(data), data, patience));
    else if (!lost) texts.push(isAnswered ? `No answer within ${patience} ms.` : "");
    this.fault(texts.filter(Boolean).join(" "));
    const took = data.length ? ` The answer took ${Math.round(milliseconds)} ms.` : isAnswered ? "" : " The request has no answer.";
    if (exchange.carrier) this.say(`Connected to ${exchange.carrier.name}.${took}`);
    this.update();
    byId("send").dataset.count = Number(byId("send").dataset.count ?? 0) + 1;
  }

  // Explains an answer, and says what is wrong with it.
  show(reading, data, patience) {
    const { explanation } = reading;
    const remarks = [...remarksOn(this.lab.device, reading, 0, new FrameOptions({}))];
    this.lab.table.show({ explanation, remarks, wrong: reading.wrong });
    if (explanation.reasons.length) return `No valid answer within ${patience} ms, but ${data.length} bytes: ${explanation.reasons.join(", ")}.`;
    if (reading.mismatches.length) return "The answer does not fit the request.";
    return explanation.error ? "The device refuses the request." : "";
  }

  // ---- the traffic ----

  note(direction, data) {
    this.lines.push(`${direction}: ${hexOf(data, " ")}`);
    this.lines.splice(0, this.lines.length - MOST_TRAFFIC);
    byId("traffic").hidden = false;
    byId("traffic-lines").textContent = this.lines.join("\n");
    byId("traffic-lines").scrollTop = byId("traffic-lines").scrollHeight;
  }

  explainTraffic() {
    byId("frames").value = `${this.lines.join("\n")}\n`;
    byId("request").value = "";
    this.lab.forgetKnown();
    this.lab.read();
    byId("frames").focus();
  }
}
