// The frames of a log. Only the rows on the screen are in the page, so that a long log is as quick as a short one.

const ROW_HEIGHT = 26;  // pixels, as in the style sheet
const SLICE = 12;  // milliseconds of work before the browser may draw
const DRAWN = 150;  // milliseconds between two states of the list while it grows
const SHOWN_BYTES = 12;

class LogList {
  constructor(lab) {
    this.lab = lab;
    this.list = byId("log-list");
    this.rows = byId("log-rows");
    this.entries = [];
    this.visible = [];
    this.selected = -1;
    this.run = 0;
    this.list.addEventListener("scroll", () => this.draw());
    this.list.addEventListener("keydown", (event) => this.move(event));
    this.rows.addEventListener("click", (event) => {
      const row = event.target.closest("[data-index]");
      if (row) this.select(Number(row.dataset.index));
    });
    byId("faults-only").addEventListener("change", () => this.filter());
  }

  // Reads a text line by line, in slices. A later text ends an earlier run.
  read(text, options, asked) {
    const run = ++this.run;
    const lines = linesOf(text.replace(/^\ufeff/, ""));
    const reader = new LogReader(this.lab.device, options, asked);
    this.entries = [];
    this.faults = 0;
    this.selected = -1;
    let at = 0;
    let drawn = -Infinity;
    const work = () => {
      if (run !== this.run) return;
      const end = performance.now() + SLICE;
      while (at < lines.length) {
        this.readLine(reader, lines[at]);
        at += 1;
        if (performance.now() >= end) break;  // after a line, so that a single one is explained at once
      }
      if (at === lines.length || end - drawn > DRAWN) {
        drawn = end;
        this.progress(at, lines.length);
      }
      if (at < lines.length) setTimeout(work);
      else this.lab.finished(this.entries.length);
    };
    work();
  }

  progress(at, count) {
    this.filter();
    const rest = at < count ? `, ${Math.floor((100 * at) / count)} % read` : "";
    byId("log-status").textContent = `${this.entries.length} frames in ${count} lines, ${this.faults} with faults${rest}`;
    if (this.selected < 0 && this.visible.length) this.select(0);
  }

  readLine(reader, line) {
    try {
      const reading = reader.read(line);
      if (!reading) return;
      // Rows are made again when they are wanted: those of a long log would not fit into memory.
      const { explanation, remarks, wrong, request } = reading;
      this.faults += Number(wrong);
      this.entries.push({
        line: reader.number, frame: explanation.frame, reading: readingOf(explanation), remarks, wrong,
        request: request && { link: request.link, message: request.message, frame: request.frame },
        fault: wrong ? faultTexts(explanation)[0] ?? remarks[0] : "",
      });
    } catch (error) {
      if (!(error instanceof Unreadable)) throw error;
      this.faults += 1;
      this.entries.push({ line: reader.number, frame: null, text: shortened(line.trim()), wrong: true, fault: shortened(error.message) });
    }
  }

  filter() {
    const onlyFaults = byId("faults-only").checked;
    this.visible = onlyFaults ? this.entries.filter(({ wrong }) => wrong) : this.entries;
    byId("log").hidden = this.entries.length < 2;
    this.rows.style.height = `${this.visible.length * ROW_HEIGHT}px`;
    this.draw();
  }

  draw() {
    const first = Math.max(0, Math.floor(this.list.scrollTop / ROW_HEIGHT) - 5);
    const count = Math.ceil(this.list.clientHeight / ROW_HEIGHT) + 10;
    const chosen = this.entries[this.selected];
    this.rows.replaceChildren(...this.visible.slice(first, first + count).map((entry, at) => {
      const index = first + at;
      const row = element("li", {
        id: `log-${index}`,
        className: `${entry.wrong ? "fault" : ""} ${entry === chosen ? "lit" : ""}`,
        dataset: { index },
        attributes: {
          role: "option", "aria-selected": String(entry === chosen), "aria-posinset": index + 1, "aria-setsize": this.visible.length,
        },
      }, ...this.cells(entry));
      row.style.top = `${index * ROW_HEIGHT}px`;
      return row;
    }));
    const index = this.visible.indexOf(chosen);
    if (index < 0 || !byId(`log-${index}`)) this.list.removeAttribute("aria-activedescendant");
    else this.list.setAttribute("aria-activedescendant", `log-${index}`);
  }

  cells(entry) {
    const number = element("span", { className: "quiet", textContent: entry.line });
    if (!entry.frame) return [number, element("span", { className: "wrong absent", textContent: `no frame: ${entry.fault}` })];
    const [link, direction, message, error] = entry.reading;
    const name = error ? "exception response" : this.lab.device.links.get(link).directionNames[direction];
    const digits = hexOf(entry.frame.subarray(0, SHOWN_BYTES), " ") + (entry.frame.length > SHOWN_BYTES ? " …" : "");
    return [
      number,
      element("span", { textContent: `${message || "unknown"} ${name}` }),
      element("code", { textContent: digits }),
      element("span", { className: "wrong", textContent: entry.fault }),
    ];
  }

  select(index) {
    const entry = this.visible[index];
    if (!entry) return;
    this.selected = this.entries.indexOf(entry);
    const top = index * ROW_HEIGHT;
    if (top < this.list.scrollTop) this.list.scrollTop = top;
    const bottom = top + ROW_HEIGHT - this.list.clientHeight;
    if (bottom > this.list.scrollTop) this.list.scrollTop = bottom;
    this.draw();
    this.lab.showEntry(entry);
  }

  move(event) {
    const page = Math.max(1, Math.floor(this.list.clientHeight / ROW_HEIGHT) - 1);
    const step = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity }[event.key];
    if (!step) return;
    event.preventDefault();
    const own = this.visible.indexOf(this.entries[this.selected]);
    this.select(Math.min(this.visible.length - 1, Math.max(0, own + step)));
  }
}
