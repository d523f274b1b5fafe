// The explanation of a frame: its bytes, its fields, its registers, and what there is to say about them.

const COLUMNS = ["At", "Bytes", "Field", "Label", "Raw", "Value", "Meaning", "Check", "Manual"];
const CHARACTER_DIGITS = new Set(["decimal", "upper_hex", "lower_hex"]);
const REGISTER_COLUMNS = ["Address", "Bytes", "Register", "Label", "Raw", "Value", "Meaning", "Check", "Manual"];

class FrameTable {
  constructor(lab) {
    this.lab = lab;
    this.bytes = byId("bytes");
    for (const id of ["bytes", "rows", "registers"]) {
      byId(id).addEventListener("pointerover", (event) => this.light(event.target));
      byId(id).addEventListener("focusin", (event) => this.light(event.target));
      byId(id).addEventListener("pointerleave", () => this.light(null));
    }
    for (const id of ["rows", "registers"]) byId(id).addEventListener("keydown", (event) => this.move(event));
    this.bytes.addEventListener("click", (event) => {
      const byte = event.target.closest("[data-row]");
      if (byte) byId("rows").querySelector(`tr[data-row="${byte.dataset.row}"]`)?.focus();
    });
  }

  // Highlights a row and its bytes, from either; those of the row with the focus if the pointer is on none.
  light(target) {
    const origin = target?.closest("[data-from]") ?? document.activeElement?.closest("[data-from]");
    const [from, to] = origin ? [Number(origin.dataset.from), Number(origin.dataset.to)] : [0, 0];
    for (const byte of this.bytes.children) {
      const at = Number(byte.dataset.from);
      byte.classList.toggle("lit", at >= from && at < to);
    }
    for (const row of document.querySelectorAll("#rows tr[data-from], #registers tr[data-from]")) {
      const [first, last] = [Number(row.dataset.from), Number(row.dataset.to)];
      row.classList.toggle("lit", first < to && from < last);
    }
  }

  // The arrow keys move from row to row.
  move(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step || event.target.tagName !== "TR") return;
    const rows = [...document.querySelectorAll("#rows tr[data-from], #registers tr[data-from]")];
    const next = rows[rows.indexOf(event.target) + step];
    if (!next) return;
    event.preventDefault();
    next.focus();
  }

  show(reading) {
    const { device } = this.lab;
    const { explanation } = reading;
    byId("explanation").hidden = false;
    byId("frame-title").replaceChildren(...this.title(reading));
    byId("remarks").replaceChildren(...reading.remarks.map((text) => element("li", { textContent: text })));
    byId("remarks").className = reading.wrong ? "wrong" : "";
    this.showBytes(explanation);
    this.showTable(byId("rows"), "The frame, field by field", COLUMNS, explanation.rows, (row) => row.at, this.rawForms(explanation));
    const registers = byId("registers");
    registers.hidden = !explanation.registers.length;
    if (explanation.registers.length) {
      const { access } = device.messages.get(explanation.message);
      const caption = access ? `What the frame ${access.operation}s` : "Registers that the frame accesses";
      this.showTable(registers, caption, REGISTER_COLUMNS, explanation.registers, addressText);
    }
    byId("faults").replaceChildren(...faultTexts(explanation).map((text) => element("li", { textContent: text })));
    byId("notes").replaceChildren(...this.notes(explanation));
  }

  title({ explanation, wrong }) {
    const { device } = this.lab;
    const link = device.links.get(explanation.link);
    const message = device.messages.get(explanation.message);
    const kind = explanation.error ? "exception response" : link.directionNames[explanation.direction];
    const name = explanation.message || "unknown";
    const text = message?.title || message?.label;
    return [
      this.factLink(message?.path ?? "", element("code", { textContent: name })),
      ` ${kind}, ${explanation.link}${text ? `: ${text}` : ""} `,
      element("span", { className: wrong ? "wrong" : "right", textContent: wrong ? "refused" : "valid" }),
    ];
  }

  showBytes({ frame, rows, link }) {
    const isText = this.lab.device.links.get(link).transmission === "hex_ascii";
    const rowAt = new Map();
    for (const [number, { offset, length }] of rows.entries()) {
      for (let at = offset; at < offset + length; at++) rowAt.set(at, number);
    }
    this.bytes.replaceChildren(...Array.from(frame, (byte, at) => {
      const row = rows[rowAt.get(at)];
      const isFirst = row?.offset === at;
      const style = [isFirst ? "first" : "", row?.reason && row.reason !== "out_of_range" ? "fault" : ""];
      return element("li", {
        className: style.filter(Boolean).join(" "),
        textContent: isText ? characterOf(byte) : hexOf([byte]),
        dataset: { from: at, to: at + 1, row: rowAt.get(at) ?? "", kind: row?.kind ?? "" },
        title: row?.path ?? "",
      });
    }));
  }

  // How the command line prints raw values: codes, addresses and wire numbers of parameters in hexadecimal, but not characters.
  rawForms({ link, direction, message, error, rows }) {
    const { device } = this.lab;
    const { [direction]: frame } = device.links.get(link);
    const code = frame.role("code");
    const { access, [direction]: record } = device.messages.get(message) ?? {};
    const fields = error ? [] : record?.fields ?? [];
    const isHexadecimal = ({ name, value }) => {
      if (!value || CHARACTER_DIGITS.has(value.digits)) return false;
      if (value.flags || name === access?.start) return true;
      const row = rows.find(({ path }) => path === name);
      if (value.parameter?.part !== "number" || !isWhole(row?.number ?? "")) return false;
      const [own] = device.parameterAt(value.parameter.set, row.number) ?? [];
      return !own || Boolean(own.digits || own.base);
    };
    return {
      hidden: frame.checksums.map(({ name }) => name),
      hexadecimal: [code?.name, ...fields.filter(isHexadecimal).map(({ name }) => name)],
    };
  }

  showTable(place, caption, columns, rows, first, rawForms = { hidden: [], hexadecimal: [] }) {
    const titles = columns.map((text) => element("th", { scope: "col", textContent: text }));
    const body = element("tbody");
    for (const [number, row] of rows.entries()) body.append(this.row(row, number, first(row), rawForms));
    const table = element("table", {}, element("caption", { textContent: caption }), element("thead", {}, element("tr", {}, ...titles)), body);
    place.replaceChildren(table);
  }

  row(row, number, first, { hidden, hexadecimal }) {
    const { device } = this.lab;
    const isWrong = row.verdict.startsWith("wrong");
    const isDoubtful = row.kind === "register" || row.reason === "out_of_range";
    const name = row.path || (row.kind === "unexplained" && !row.doc ? "surplus" : "");
    const labels = [row.printedName && element("code", { textContent: row.printedName }), " ", labelText(device, row.label)];
    const meanings = row.meanings.map((meaning) => element("li", {}, ...this.meaning(meaning)));
    const sent = row.characters && row.characters !== hexOf(row.raw) ? `${visibleCharacters(row.sent)} ` : "";
    const cells = [
      element("td", { className: "number" }, element("code", { textContent: first })),
      element("td", { className: "bytes" }, sent && element("span", { className: "quiet", textContent: sent }), element("code", { textContent: hexOf(row.raw, " ") })),
      element("th", { scope: "row" }, this.factLink(row.fact, name && element("code", { textContent: name })), row.path ? "" : row.doc),
      element("td", {}, ...labels.filter(Boolean)),
      element("td", { className: "number", textContent: hidden.includes(row.path) ? "" : rawText(row, hexadecimal.includes(row.path)) }),
      element("td", { className: "number", textContent: row.value }),
      element("td", { className: "wide" }, ...(meanings.length > 1 ? [element("ul", {}, ...meanings)] : meanings.flatMap((item) => [...item.childNodes]))),
      element("td", { className: isWrong ? "wrong" : "right", textContent: isWrong && isDoubtful ? row.verdict.replace("wrong", "doubtful") : row.verdict }),
      element("td", { className: "source" }, row.source, ...row.errata.flatMap((id, at) => [at || row.source ? " " : "", this.erratumLink(id)])),
    ];
    const dataset = { row: number, from: row.offset, to: row.offset + row.length };
    return element("tr", { tabIndex: number ? -1 : 0, dataset, className: isWrong ? "fault" : "" }, ...cells);
  }

  meaning({ name, label, text, bits }) {
    const place = bits && element("span", { className: "quiet", textContent: `bit${/^\d+$/.test(bits) ? "" : "s"} ${bits} ` });
    const words = [name && element("code", { textContent: name }), label && labelText(this.lab.device, label)].filter(Boolean);
    const shown = text.replaceAll(" ", "_") === name ? "" : text;
    return [place, words[0] ?? "", words[1] ? " " : "", words[1] ?? "", shown && words.length ? ": " : "", shown].filter(Boolean);
  }

  // A link to a fact on the page of the version; a fact that has no place of its own is found by the search there.
  factLink(path, content) {
    if (!path) return content;
    return element("a", { href: `${this.lab.page}.html#${path.split("/").map(encodeURIComponent).join("/")}` }, content);
  }

  erratumLink(id) {
    return this.factLink(`errata/${id}`, element("span", { className: "badge", textContent: `erratum ${id}` }));
  }

  notes(explanation) {
    const { device } = this.lab;
    const rows = [...explanation.rows, ...explanation.registers];
    const notes = new Map();
    for (const row of rows) for (const note of row.notes) if (!notes.has(note)) notes.set(note, row.path || "the frame");
    const ids = new Set([...explanation.errata, ...rows.flatMap((row) => row.errata)]);
    const digits = hexOf(explanation.frame);
    for (const example of device.data.examples) if (example.printed === digits) for (const id of example.errata ?? []) ids.add(id);
    const errata = device.data.errata.filter(({ id }) => ids.has(id));
    const examples = device.data.examples.filter(({ frame }) => frame === digits).slice(0, 3);
    return [
      ...[...notes].map(([note, place]) => element("li", { textContent: `Note on ${place}: ${note}` })),
      ...errata.map((erratum) => element("li", {}, this.erratumLink(erratum.id), ` ${printedText(erratum.printed)}${erratum.reason}`)),
      ...examples.map((example) => element("li", {}, "Example ", this.factLink(`examples/${example.id}`, element("code", { textContent: example.id })),
        [example.source && ` (${example.source})`, example.title && `: ${example.title}`].filter(Boolean).join(""))),
    ];
  }
}

function printedText(printed) {
  const pairs = Object.entries(printed).map(([key, value]) => `${key} ${value === null ? "absent" : value}`);
  return pairs.length ? `Printed: ${pairs.join(", ")}. ` : "";
}

function addressText(row) {
  return `0x${row.address.toString(16).toUpperCase().padStart(4, "0")}`;
}

function characterOf(byte) {
  return byte >= 0x20 && byte < 0x7f ? String.fromCharCode(byte) : byte < 0x20 ? String.fromCharCode(0x2400 + byte) : hexOf([byte]);
}

function visibleCharacters(text) {
  return Array.from(text, (char) => characterOf(char.charCodeAt(0))).join("");
}

// The raw value; bit fields are always hexadecimal.
function rawText({ number, meanings, raw }, isHexadecimal) {
  if (number === null) return "";
  if (number instanceof Uint8Array) return hexOf(number, " ");
  if (typeof number === "boolean") return String(number);
  if ((isHexadecimal || meanings.some(({ bits }) => bits)) && isWhole(number)) {
    const digits = BigInt.asUintN(8 * raw.length, BigInt(number)).toString(16).toUpperCase();
    return `0x${digits.padStart(2 * raw.length, "0")}`;
  }
  return typeof number === "number" && !Number.isInteger(number) ? floatText(number, raw.length) : String(number);
}

// A line for each wrong or doubtful value.
function faultTexts({ rows, registers }) {
  return [...rows, ...registers].filter(({ verdict }) => verdict.startsWith("wrong")).map((row) => {
    const kind = row.kind === "register" || row.reason === "out_of_range" ? "doubtful" : "wrong";
    return `${kind}: ${placeText(row)}: ${row.verdict.replace("wrong: ", "")}`;
  });
}
