// The form of a message: a frame is made of what is entered, with its lengths and checksums.

const messageOption = ({ name, title, label }) => option(name, [name, title || label].filter(Boolean).join(": "));

class MessageForm {
  constructor(lab) {
    this.lab = lab;
    this.fields = byId("fields");
    this.choice = null;
    this.entries = new Map();
    this.counts = new Map();
    this.deciding = new Set();
    this.fields.addEventListener("input", (event) => this.entered(event.target));
    for (const id of ["build-link", "build-direction", "build-message"]) {
      byId(id).addEventListener("change", () => {
        this.choose(id);
        this.build();
      });
    }
  }

  // ---- what is built ----

  fill() {
    const { device } = this.lab;
    byId("build-link").replaceChildren(...[...device.links.values()].map(({ name, title }) => option(name, title ? `${name}: ${title}` : name)));
    this.choose("build-link");
  }

  // Fills the choices that depend on the one that has changed, and begins an empty message.
  choose(id) {
    const link = this.lab.device.links.get(byId("build-link").value);
    const direction = byId("build-direction");
    const message = byId("build-message");
    if (id === "build-link") {
      const ways = DIRECTIONS.filter((way) => link.carriedMessages[way].size > 0);
      direction.replaceChildren(...ways.map((way) => option(way, link.directionNames[way])));
    }
    if (direction.value === "") {
      message.replaceChildren();
      this.leave(`No ${link.messageName} goes over ${link.name}.`);
      return;
    }
    if (id !== "build-message") {
      const before = message.value;
      const names = [...link.carriedMessages[direction.value].values()];
      message.replaceChildren(...names.map(messageOption));
      if (link.carriedMessages[direction.value].has(before)) message.value = before;
      byId("build-message-label").textContent = titled(link.messageName);
    }
    this.begin({ link: link.name, direction: direction.value, message: message.value, error: false });
  }

  // Nothing is built, and the text says why.
  leave(text) {
    this.choice = null;
    this.fields.replaceChildren();
    this.message(text);
  }

  begin(choice) {
    this.choice = choice;
    this.entries = new Map();
    this.counts = new Map();
    this.draw();
  }

  // Takes over the values of a frame that is explained.
  take(explanation) {
    const { device } = this.lab;
    const { link, direction, message, error, values } = explanation;
    const own = device.links.get(link);
    const isKnown = own.carriedMessages[error ? "request" : direction].has(message);
    if (!isKnown) {
      this.leave("Nothing says which message this is, so there are no fields to edit. Choose one to build it.");
      return;
    }
    byId("build-link").value = link;
    const ways = DIRECTIONS.filter((way) => way === direction || own.carriedMessages[way].size > 0);
    byId("build-direction").replaceChildren(...ways.map((way) => option(way, own.directionNames[way])));
    byId("build-direction").value = direction;
    const names = [...own.carriedMessages[error ? "request" : direction].values()];
    byId("build-message").replaceChildren(...names.map(messageOption));
    byId("build-message").value = message;
    byId("build-message-label").textContent = titled(own.messageName);
    this.choice = { link, direction, message, error };
    this.entries = new Map();
    this.counts = new Map();
    this.takeValues(this.headFields(), values, "");
    this.takeValues(this.record().fields, values, "");
    const form = formOfValues(this.record(), values);
    if (form) this.takeValues(form.fields, values, "");
    this.draw();
    this.message("");
  }

  takeValues(fields, values, prefix) {
    for (const field of fields.map((own) => (own.forms && values.has(own.by) && formOfNumber(own, values.get(own.by))) || own)) {
      const raw = values.get(field.name);
      const path = prefix + field.name;
      if (raw === undefined || (!field.value && !field.record)) continue;
      if (field.record) {
        const items = field.isList ? raw : [raw];
        this.counts.set(path, items.length);
        const { fields: inner } = this.lab.device.records.get(field.record);
        items.forEach((item, at) => this.takeValues(inner, item, `${field.isList ? `${path}[${at}]` : path}.`));
      } else {
        const texts = (field.isList ? raw : [raw]).map((item) => entryOf(this.lab.device, field.value, item, this.isAddress(field)));
        this.entries.set(path, texts.join(", "));
      }
    }
  }

  // ---- the fields ----

  record() {
    const { link, direction, message, error } = this.choice;
    const { device } = this.lab;
    return error ? device.records.get(device.links.get(link).exception.record) : device.messages.get(message)[direction];
  }

  headFields() {
    const { link, direction } = this.choice;
    const own = this.lab.device.links.get(link);
    return own[direction].header.filter(isArgument).map((part) => (
      part.role === "unit_address" && own.addresses?.ranges
        ? { ...part, value: { ...part.value, ranges: own.addresses.ranges } } : part));
  }

  access() {
    const { message, error } = this.choice;
    const own = this.lab.device.messages.get(message);
    return error ? undefined : own.access;
  }

  isAddress(field) {
    return this.access()?.start === field.name;
  }

  // The fields that people enter, with their paths; elements of lists of records one by one.
  leaves(fields, prefix = "") {
    const leaves = [];
    for (const field of fields.map((own) => this.decided(fields, own, prefix)).filter(Boolean)) {
      const path = prefix + field.name;
      if (field.measures || field.reserved || field.value?.const !== undefined || field.cases) continue;
      if (!field.record) {
        leaves.push({ path, field });
        continue;
      }
      const count = this.countOf(field, path);
      if (field.repeat) leaves.push({ path, field, isCount: true });
      const { fields: inner } = this.lab.device.records.get(field.record);
      for (let at = 0; at < count; at++) leaves.push(...this.leaves(inner, `${field.isList ? `${path}[${at}]` : path}.`));
    }
    return leaves;
  }

  // A field of the type that what is entered decides; undefined where that decides nothing.
  decided(fields, field, prefix) {
    if (!field.forms) return field;
    const by = fields.find(({ name }) => name === field.by);
    this.deciding.add(prefix + by.name);
    try {
      return formOfNumber(field, by.value.const ?? this.rawValue({ path: prefix + by.name, field: by }));
    } catch (error) {
      if (!(error instanceof CodecError)) throw error;
      return undefined;
    }
  }

  countOf(field, path) {
    if (!field.repeat) return field.count ?? 1;
    return this.counts.get(path) ?? field.repeat[0];
  }

  allLeaves() {
    const record = this.record();
    let form = record;
    if (record.selector) {
      const by = record.selector;
      form = record;
      try {
        form = formOfValues(record, new Map([[by.name, this.rawValue({ path: by.name, field: by })]])) ?? record;
      } catch (error) {
        if (!(error instanceof CodecError)) throw error;
      }
    }
    return [...this.leaves(this.headFields()), ...this.leaves(form.fields)];
  }

  text(path, field) {
    if (this.entries.has(path)) return this.entries.get(path);
    const text = Array.from({ length: field.isList ? field.count ?? field.repeat[0] : 1 }, () => this.initialText(field)).join(", ");
    this.entries.set(path, text);
    return text;
  }

  initialText(field) {
    const { value } = field;
    const { device } = this.lab;
    const ranges = value.writeRanges ?? value.ranges;
    const listing = value.enum && device.enums.get(value.enum);
    if (typeof value.default === "number") return entryOf(device, value, value.default);
    if (listing && !memberOf(listing, 0)) return listing.members.find(({ unavailable }) => !unavailable)?.name ?? "0";
    if (value.kind === "bytes") return "00".repeat(value.size);
    if (value.kind === "text") return "";
    if (value.flags) return initialWord(device, value);
    const first = ranges && !isWithin(ranges, 0) ? ranges[0][0] : 0;
    return entryOf(device, value, value.kind === "boolean" ? false : first, this.isAddress(field));
  }

  draw() {
    const focused = document.activeElement?.dataset?.path;
    this.fields.replaceChildren(...this.allLeaves().map((leaf, number) => this.leaf(leaf, number)));
    if (focused) [...this.fields.querySelectorAll("[data-path]")].find(({ dataset }) => dataset.path === focused)?.focus();
  }

  leaf({ path, field, isCount }, number) {
    const id = `field-${number}`;
    const { device } = this.lab;
    if (isCount) {
      const [low, high] = field.repeat;
      const input = element("input", { id, type: "number", min: low, max: Math.min(high, 64), value: this.countOf(field, path), dataset: { path, count: "yes" } });
      return element("div", {}, element("label", { htmlFor: id, textContent: `Number of ${path}` }), input);
    }
    const value = this.text(path, field);
    const input = element("input", { id, type: "text", value, autocomplete: "off", spellcheck: false, dataset: { path } });
    const suggestions = this.suggestions(field);
    const parts = [element("label", { htmlFor: id }, element("code", { textContent: path }), " ", labelText(device, field.label)), input];
    if (suggestions.length) {
      input.setAttribute("list", `${id}-list`);
      parts.push(element("datalist", { id: `${id}-list` }, ...suggestions.map((text) => option(text, ""))));
    }
    const hint = this.hint(field);
    if (hint) parts.push(element("span", { className: "quiet", textContent: hint }));
    if (field.value.flags && !field.isList) parts.push(this.bits(path, field, value));
    return element("div", {}, ...parts);
  }

  suggestions(field) {
    const { device } = this.lab;
    if (field.value.enum) return device.enums.get(field.value.enum).members.filter(({ unavailable }) => !unavailable).map(({ name }) => name);
    if (!this.isAddress(field)) return (field.value.sentinels ?? []).map(({ name }) => name);
    const { space = "" } = this.access();
    return device.data.registers.filter((register) => (register.space ?? "") === space).map(({ name }) => name);
  }

  hint({ value, doc }) {
    const ranges = value.writeRanges ?? value.ranges;
    const bounds = ranges && value.kind !== "float" ? intervalsText(ranges) : "";
    return [bounds && `counts ${bounds}`, value.unit && `unit ${value.unit}`, doc].filter(Boolean).join("; ");
  }

  bits(path, field, text) {
    const word = this.lab.device.flags.get(field.value.flags);
    const raw = wordNumber(this.lab.device, field.value, text);
    const boxes = (word.bits ?? []).filter(({ reserved, width }) => !reserved && width === 1).map((bit) => {
      const box = element("input", { type: "checkbox", checked: isBitSet(raw, text, bit), dataset: { path, bit: bit.first, name: bit.name } });
      return element("label", {}, box, ` ${bit.first} `, element("code", { textContent: bit.name }));
    });
    return element("details", {}, element("summary", { textContent: "Bits" }), element("div", { className: "bit-boxes" }, ...boxes));
  }

  // ---- what is entered ----

  entered(target) {
    const { path, count, bit } = target.dataset;
    if (count) {
      const number = Math.floor(Number(target.value));
      if (!(number >= Number(target.min) && number <= Number(target.max))) {
        this.refuse(`Number of ${path}: enter ${target.min} to ${target.max}.`);
        return;
      }
      this.counts.set(path, number);
      this.draw();
    } else if (bit !== undefined) {
      const field = this.allLeaves().find((leaf) => leaf.path === path).field;
      this.entries.set(path, wordWithBit(this.lab.device, field.value, this.entries.get(path), target.dataset, target.checked));
      const input = [...this.fields.querySelectorAll("input[type=text]")].find(({ dataset }) => dataset.path === path);
      input.value = this.entries.get(path);
    } else {
      this.entries.set(path, target.value);
      if (this.record().selector?.name === path || this.deciding.has(path)) this.draw();
    }
    this.build();
  }

  rawValue({ path, field }) {
    const { device } = this.lab;
    const text = this.text(path, field);
    if (this.isAddress(field)) {
      const register = device.data.registers.find(({ name }) => name === text.trim());
      if (register) return register.address;
    }
    if (!field.isList) return rawOf(device, path, field.value, text);
    if (field.value.kind === "bytes" || field.value.kind === "text") return text.split(",").map((item) => rawOf(device, path, field.value, item.trim()));
    return text.split(/\s*,\s*|\s+(?=[-+]?(?:0x)?[0-9])/).filter(Boolean).map((item) => rawOf(device, path, field.value, item));
  }

  // The quantity or the name of a register's value, as the words that are written to it.
  words(leaf, address) {
    const { device } = this.lab;
    const access = this.access();
    const items = this.text(leaf.path, leaf.field).split(",").map((item) => item.trim()).filter(Boolean);
    const words = [];
    for (const item of items.flatMap((text) => (/^[-+0-9a-fx ]+$/i.test(text) ? text.split(/\s+/) : [text]))) {
      const count = countOf(item);
      const isWord = count !== undefined && count >= 0 && count <= 0xFFFF;
      const occupant = occupantAt(device, access.space ?? "", address + words.length);
      const isOneWord = occupant?.value.kind === "integer" && occupant.value.size === 2 && !occupant.skip;
      if (!occupant || (isWord && !isOneWord)) {
        words.push(rawOf(device, leaf.path, leaf.field.value, item));
        continue;
      }
      const { path } = occupant;
      const value = forWriting(occupant.value);
      if (isWord) {
        // A word is written as it is, but not if the register cannot have it.
        const bytes = Uint8Array.of(count >> 8, count & 0xFF);
        const number = contentOf({ ...value, order: undefined }, bytes) ?? bytes;
        encodeRecord(device, { fields: [{ name: path, value, count: 1 }] }, new Map([[path, number]]));
        words.push(count);
        continue;
      }
      if (value.size % 2) throw new CodecError("wrong_type", `${path} shares a word with others; enter the whole word`);
      const bytes = encodeRecord(device, { fields: [{ name: path, value, count: 1 }] }, new Map([[path, rawOf(device, path, value, item)]]));
      for (let at = 0; at < bytes.length; at += 2) words.push(Number(unsignedOf(bytes.subarray(at, at + 2), device.data.wordOrder)));
    }
    return words;
  }

  values() {
    const leaves = this.allLeaves().filter(({ isCount }) => !isCount);
    const values = new Map();
    const access = this.access();
    for (const leaf of leaves) {
      const isWords = access?.operation === "write" && access.values === leaf.path && !access.set && this.choice.direction === "request";
      const address = isWords ? values.get(access.start) : undefined;
      if (isWords && isWhole(address ?? "") && leaf.field.value.kind === "integer") {
        const words = this.words(leaf, Number(address));
        this.put(values, leaf.path, leaf.field.isList ? words : words.length === 1 ? words[0] : this.tooMany(leaf, words));
      } else {
        this.put(values, leaf.path, this.rawValue(leaf));
      }
    }
    this.putEmptyLists(this.record().fields, values);
    return values;
  }

  tooMany({ path }, words) {
    throw new CodecError("wrong_length", `${path}: this takes ${words.length} words, and the message writes one`);
  }

  // `items[0].size` becomes a Map in a list in a Map.
  put(values, path, raw) {
    const steps = path.split(".");
    let place = values;
    for (const step of steps.slice(0, -1)) {
      const [, name, index] = /^([^[]+)(?:\[(\d+)\])?$/.exec(step);
      if (!place.has(name)) place.set(name, index === undefined ? new Map() : []);
      let inner = place.get(name);
      if (index !== undefined) inner = inner[Number(index)] ??= new Map();
      place = inner;
    }
    place.set(steps.at(-1), raw);
  }

  putEmptyLists(fields, values) {
    for (const field of fields) if (field.record && field.isList && !values.has(field.name)) values.set(field.name, []);
  }

  build() {
    if (!this.choice?.message) return;
    this.refuse("");  // until there is a frame, whatever happens
    try {
      const frame = encodeFrame(this.lab.device, this.choice, this.values());
      this.message("");
      this.lab.edited(frame, this.choice);
    } catch (error) {
      if (!(error instanceof CodecError)) throw error;
      this.refuse(error.message);
    }
  }

  // What is entered makes no frame, and the frame before it is not what somebody wants to send.
  refuse(text) {
    this.message(text);
    byId("built").textContent = "";
    this.lab.isEntryRefused = true;
    this.lab.panel.update();
  }

  message(text) {
    byId("build-fault").textContent = text;
  }
}
