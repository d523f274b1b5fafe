// The lab of a device: the frames that somebody enters, what is known of them, and the address that says it all.

const MOST_IN_ADDRESS = 2000;  // characters of frames in the address of the page
const TYPING = 200;  // milliseconds after the last key
const KNOWN = ["link", "direction", "message"];

class Lab {
  constructor() {
    this.content = byId("content");
    this.device = null;
    this.page = "";
    this.current = null;
    this.isEntryRefused = false;
    this.timer = 0;
    this.loads = new Map();
    this.table = new FrameTable(this);
    this.list = new LogList(this);
    this.form = new MessageForm(this);
    this.panel = new DevicePanel(this);
    byId("lab").hidden = false;
    byId("version").addEventListener("change", () => this.open(byId("version").value));
    byId("frames").addEventListener("input", () => {
      if (this.isKnownFromForm) this.forgetKnown();
      this.soon();
    });
    byId("request").addEventListener("input", () => this.soon());
    for (const name of KNOWN) byId(`known-${name}`).addEventListener("change", () => {
      this.isKnownFromForm = false;
      this.read();
    });
    byId("example").addEventListener("change", () => this.example());
    byId("file").addEventListener("change", () => this.file());
    byId("clear").addEventListener("click", () => this.clear());
    byId("copy").addEventListener("click", (event) => copyText(this.frameText(), event.target));
    byId("copy-link").addEventListener("click", (event) => copyText(location.href, event.target));
    window.addEventListener("hashchange", () => this.restore());
  }

  // ---- the data of a version ----

  // Called by the data file of a version; `requests` is what there is to know before a request is sent.
  add(data, requests) {
    const device = new ExplainedDevice(data);
    this.loads.get(device.data.version)?.({ device, requests });
  }

  load(page, version) {
    return new Promise((resolve, reject) => {
      this.loads.set(version, resolve);
      const script = element("script", { src: `lab-${page}.js` });
      script.addEventListener("error", () => reject(new Error(`lab-${page}.js cannot be read`)));
      document.body.append(script);
    });
  }

  async open(page) {
    const choice = [...byId("version").options].find(({ value }) => value === page);
    byId("version").value = page;
    this.page = page;
    try {
      this.devices ??= new Map();
      if (!this.devices.has(page)) this.devices.set(page, await this.load(page, choice.textContent));
      if (this.page !== page) return;
      ({ device: this.device, requests: this.requests } = this.devices.get(page));
    } catch (error) {
      byId("input-fault").textContent = error.message;
      return;
    }
    this.current = null;
    this.panel.link = null;
    this.fillChoices();
    this.form.fill();
    this.panel.update();
    this.read();
    byId("lab").dataset.ready = page;
  }

  fillChoices() {
    const { links, data } = this.device;
    const kept = Object.fromEntries(KNOWN.map((name) => [name, byId(`known-${name}`).value]));
    byId("known-link").replaceChildren(option("", "any"), ...[...links.keys()].map((name) => option(name, name)));
    const directions = new Map([...links.values()].flatMap(({ directionNames }) => Object.values(directionNames).map((name) => [name, name])));
    byId("known-direction").replaceChildren(option("", "any"), ...[...directions.keys()].map((name) => option(name, name)));
    const messages = new Set([...links.values()].flatMap(({ carriedMessages }) => Object.values(carriedMessages).flatMap((named) => named.keys())));
    byId("known-message").replaceChildren(option("", "any"), ...[...messages].map((name) => option(name, name)));
    const words = new Set([...links.values()].map(({ messageName }) => messageName));
    byId("known-message-label").textContent = titled(words.size === 1 ? [...words][0] : "message");
    for (const name of KNOWN) {
      const select = byId(`known-${name}`);
      select.value = kept[name];
      if (select.selectedIndex < 0) select.value = "";
    }
    const examples = data.examples.map(({ id, title }) => option(id, [id, title].filter(Boolean).join(": ")));
    byId("example").replaceChildren(option("", examples.length ? "choose" : "none"), ...examples);
    byId("example").disabled = !examples.length;
  }

  // ---- the frames ----

  soon() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.read(), TYPING);
  }


  // Reads what is entered. Whatever is wrong with it is said beside it.
  read() {
    clearTimeout(this.timer);
    if (!this.device) return;
    const text = byId("frames").value;
    this.current = null;
    this.isEntryRefused = false;
    this.panel.update();
    byId("input-fault").textContent = "";
    delete byId("lab").dataset.frames;
    try {
      const known = Object.fromEntries(KNOWN.map((name) => [name, byId(`known-${name}`).value]));
      const options = frameOptions(this.device, known);
      const asked = namedRequest(this.device, byId("request").value.trim(), options);
      byId("explanation").hidden = true;
      this.list.read(text, options, asked);
    } catch (error) {
      if (!(error instanceof RangeError || error instanceof Unreadable)) throw error;
      byId("input-fault").textContent = error instanceof Unreadable ? `The request is not a frame: ${error.message}` : error.message;
    }
    this.remember(text);
  }

  finished(count) {
    byId("lab").dataset.frames = count;
  }

  // Explains an entry of the list, and fills the form with its values.
  showEntry(entry) {
    if (!entry.frame) {
      byId("explanation").hidden = true;
      byId("input-fault").textContent = `Line ${entry.line} is not a frame: ${entry.fault}`;
      return;
    }
    byId("input-fault").textContent = "";
    const { request } = entry;
    const asked = request && explained(this.device, request.link, "request", request.frame, request.message);
    const [link, direction, message, error] = entry.reading;
    const explanation = explainedAfter(this.device, link, direction, entry.frame, error ? "" : message, asked);
    this.current = { frame: entry.frame, explanation, request: asked };
    this.isEntryRefused = false;
    this.table.show({ explanation, remarks: entry.remarks, wrong: entry.wrong });
    this.form.take(explanation);
    byId("built").textContent = "";
    this.panel.update();
  }

  // A frame that the form makes. In a log it is shown beside the frames of the log, else it takes their place.
  edited(frame, { link, direction, message, error }) {
    const own = this.device.links.get(link);
    const isCoded = Boolean(own[direction].role("code"));
    const known = { link, direction: own.directionNames[direction], message: isCoded || error ? "" : message };
    const options = frameOptions(this.device, known);
    const answers = this.current?.request;
    const asked = direction === "response" && answers?.link === link && answers.message === message ? answers : null;
    const reading = readFrame(this.device, frame, options, "", asked && { request: asked, sure: true });
    const remarks = [...remarksOn(this.device, reading, 0, options)];
    this.current = { frame, explanation: reading.explanation, request: asked };
    this.isEntryRefused = false;
    byId("built").textContent = this.frameText();
    byId("input-fault").textContent = "";
    this.table.show({ explanation: reading.explanation, remarks, wrong: reading.wrong });
    this.panel.update();
    if (this.list.entries.length > 1) return;
    byId("frames").value = this.frameText();
    for (const name of KNOWN) byId(`known-${name}`).value = known[name];
    this.isKnownFromForm = true;
    this.remember(byId("frames").value);
  }

  // What the form says of its own frame is not known of another one.
  forgetKnown() {
    for (const name of KNOWN) byId(`known-${name}`).value = "";
    this.isKnownFromForm = false;
  }

  frameText() {
    const { frame, explanation } = this.current ?? { frame: new Uint8Array() };
    const link = explanation && this.device.links.get(explanation.link);
    if (link?.transmission !== "hex_ascii") return hexOf(frame, " ");
    return latinOf(frame).replace("\r", "\\r").replace("\n", "\\n");
  }

  example() {
    const example = this.device.data.examples.find(({ id }) => id === byId("example").value);
    if (!example) return;
    const asks = this.device.data.examples.find(({ id }) => id === example.replyTo);
    const isCoded = this.device.links.get(example.link)[example.direction].role("code");
    byId("known-link").value = example.link;
    byId("known-direction").value = this.device.links.get(example.link).directionNames[example.direction];
    byId("known-message").value = isCoded ? "" : example.message ?? "";
    byId("request").value = asks && example.direction === "response" && !asks.refused ? asks.frame : "";
    byId("frames").value = hexOf(bytesOfHex(example.frame), " ");
    this.read();
  }

  async file() {
    const [file] = byId("file").files;
    if (!file) return;
    byId("frames").value = await file.text();
    this.read();
  }

  clear() {
    for (const id of ["frames", "request", "file", "example"]) byId(id).value = "";
    for (const name of KNOWN) byId(`known-${name}`).value = "";
    this.read();
    byId("frames").focus();
  }

  // ---- the address of the page ----

  remember(text) {
    const state = new URLSearchParams({ version: this.page });
    for (const name of KNOWN) if (byId(`known-${name}`).value) state.set(name, byId(`known-${name}`).value);
    const request = byId("request").value.trim();
    if (request) state.set("request", request);
    const isShort = text.length <= MOST_IN_ADDRESS;
    if (text && isShort) state.set("frames", text);
    byId("copy-link").disabled = !isShort;
    this.hash = `#${state}`;
    history.replaceState(null, "", this.hash);
  }

  restore() {
    if (location.hash === this.hash || (this.device && !location.hash.includes("="))) return;
    const state = new URLSearchParams(location.hash.slice(1));
    const version = byId("version");
    const wanted = state.get("version");
    const isKnown = wanted !== null && [...version.options].some(({ value }) => value === wanted);
    byId("frames").value = state.get("frames") ?? "";
    byId("request").value = state.get("request") ?? "";
    byId("address-remark").textContent = wanted && !isKnown ? `There is no version ${shortened(wanted)} here; this is the newest one.` : "";
    this.open(isKnown ? wanted : version.options[0].value).then(() => {
      const lacking = [];
      for (const name of KNOWN) {
        const select = byId(`known-${name}`);
        select.value = state.get(name) ?? "";
        if (select.selectedIndex < 0) {
          select.value = "";
          lacking.push(`${name} ${shortened(state.get(name))}`);
        }
      }
      if (lacking.length) byId("address-remark").textContent = `This version does not have the ${lacking.join(" and the ")} of the address.`;
      this.read();
    });
  }
}

const lab = new Lab();
window.fieldspecLab = Object.freeze({ add: (data, requests) => lab.add(data, requests) });
lab.restore();
