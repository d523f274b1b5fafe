// Rows of facts can be opened: bits to scale, quantities, values, code to copy, changes, and what else mentions a fact.
// Without this script, pages say the same in their tables, except for the code.
"use strict";
(() => {
  const KINDS = ["registers", "records", "parameters", "messages", "signals", "flags"];
  const MOST_VALUES = 40;  // an enum with more members is not repeated in a fact
  const page = document.getElementById("search").dataset.page;
  if (!page) { return; }
  const main = document.getElementById("content");
  const details = new Map();  // the rows of opened facts by the rows that they belong to
  let data = null;
  let waiting = [];
  let language = "";

  function element(tag, properties = {}, ...children) {
    const node = Object.assign(document.createElement(tag), properties);
    node.append(...children);
    return node;
  }

  const here = () => data.pages.findIndex((row) => row[0] === page);
  const holds = (mask) => !mask || mask >> here() & 1;

  // The data is loaded when the first fact is opened.
  function withData(then) {
    if (data) { then(data); return; }
    waiting.push(then);
    if (waiting.length > 1) { return; }
    const script = element("script", { src: "fact-index.js" });
    script.onerror = () => { data = { pages: [], variables: {}, templates: [], code: {}, values: {}, steps: [] }; run(); };
    document.head.append(script);
  }

  function run() {
    const calls = waiting;
    waiting = [];
    calls.forEach((call) => call(data));
  }

  window.fieldspecFacts = {
    add(content) { data = content; run(); },
    whenLoaded: withData,
    pageNumber: here
  };

  // ---- parts of a fact ----

  const part = (title, ...nodes) => nodes.length ? [element("section", {}, element("h4", { textContent: title }), ...nodes)] : [];

  function copyOf(node) {
    const copy = node.cloneNode(true);
    copy.removeAttribute("id");
    copy.querySelectorAll("[id]").forEach((inner) => inner.removeAttribute("id"));
    copy.querySelectorAll(".opener").forEach((inner) => inner.remove());
    copy.querySelectorAll("tr.opened").forEach((inner) => inner.remove());
    copy.querySelectorAll("thead th > button").forEach((inner) => inner.replaceWith(inner.textContent));
    copy.querySelectorAll("tr[hidden]").forEach((inner) => { inner.hidden = false; });
    copy.querySelectorAll("[tabindex]").forEach((inner) => inner.removeAttribute("tabindex"));
    return copy;
  }

  const scrolling = (table) => element("div", { className: "scroll", tabIndex: 0, role: "group", ariaLabel: table.caption ? table.caption.textContent : "Table" }, table);

  function tableOf(caption, titles, rows) {
    const head = element("tr", {}, ...titles.map((title) => element("th", { scope: "col", textContent: title })));
    const body = rows.map((cells) => element("tr", {}, ...cells.map((cell) => element("td", { className: "number" }, cell))));
    return element("table", {}, element("caption", { textContent: caption }), element("thead", {}, head), element("tbody", {}, ...body));
  }

  // A word of 16 bits, with the numbers of the bits of the value: those that are sent first stand first.
  function wordOf(significance, caption) {
    const numbers = [...significance].flatMap((byte) => [7, 6, 5, 4, 3, 2, 1, 0].map((bit) => 8 * Number(byte) + bit));
    const head = element("tr", {}, ...numbers.map((number) => element("th", { scope: "col", textContent: number })));
    const boxes = [...significance].map((byte) => element("td", { colSpan: 8, className: "field", textContent: `bits ${8 * Number(byte) + 7} to ${8 * Number(byte)}` }));
    const table = element("table", { className: "bits" }, element("caption", { textContent: caption }), element("thead", {}, head));
    table.append(element("tbody", {}, element("tr", {}, ...boxes)));
    return table;
  }

  function wireOf(row, path) {
    const known = (data.values[path] || []).find(([mask]) => holds(mask));
    if (!known || !known[1]) { return []; }
    const first = row.querySelector("td.number code");
    const address = first && path.startsWith("registers/") ? parseInt(first.textContent, 16) : NaN;
    const words = known[1].match(/..?/g);
    const telegram = wordIn(path);
    return words.map((word, number) => wordOf(word, telegram ? `Word ${telegram.word + number} of ${telegram.name}`
      : words.length === 1 ? "One word, the byte that is sent first on the left"
        : Number.isNaN(address) ? `Bytes ${2 * number} and ${2 * number + 1} as they are sent`
          : `Word ${number + 1} of ${words.length}, at 0x${(address + number).toString(16).toUpperCase().padStart(4, "0")}`));
  }

  // The number of the word in which a field of a telegram begins, and what the manual calls the telegram.
  function wordIn(path) {
    const link = path.startsWith("messages/") ? document.querySelector(`#words a[href="#${CSS.escape(path)}"]`) : null;
    const cell = link && link.closest("td");
    return cell ? { word: Number(cell.parentElement.cells[0].textContent), name: cell.closest("table").tHead.rows[0].cells[cell.cellIndex].textContent } : null;
  }

  const hexadecimal = (raw) => raw < 0 ? "" : `0x${raw.toString(16).toUpperCase()}`;

  function quantitiesOf(path) {
    const known = (data.values[path] || []).find(([mask]) => holds(mask));
    const rows = known ? known.slice(2).map(([raw, quantity]) => [String(raw), hexadecimal(raw), quantity]) : [];
    return rows.length ? [tableOf("Raw values and quantities", ["Raw", "Hexadecimal", "Quantity"], rows)] : [];
  }

  const linksTo = (row, kind) => [...new Set([...row.querySelectorAll(`a[href^="#${kind}/"]`)].map((link) => decodeURIComponent(link.hash.slice(1))))];

  function bitsOf(row, path) {
    const own = path.startsWith("flags/") ? [path.split("/").slice(0, 2).join("/")] : linksTo(row, "flags");
    const sections = own.map((target) => document.getElementById(target)).filter(Boolean);
    return sections.flatMap((section) => {
      const drawings = [...section.querySelectorAll("table.bits")].map(copyOf);
      drawings.forEach((drawing) => drawing.querySelectorAll("td a").forEach((link) => {
        if (link.getAttribute("href") === `#${path}`) { link.parentElement.classList.add("here"); }
      }));
      const table = path.startsWith("flags/") ? null : section.querySelector("table:not(.bits)");
      return [...drawings.map(scrolling), ...(table ? [scrolling(copyOf(table))] : [])];
    });
  }

  function valuesOf(row) {
    return linksTo(row, "enums").flatMap((target) => {
      const section = document.getElementById(target);
      const table = section && section.querySelector("table:not(.bits)");
      if (!table || table.tBodies[0].rows.length > MOST_VALUES) { return []; }
      return [scrolling(copyOf(table))];
    });
  }

  function signalOf(path) {
    const name = path.split("/").pop();
    const row = path.startsWith("messages/") ? document.getElementById(`signals/${name}`) : null;
    const meaning = row && row.querySelector("td.wide");
    if (!meaning || !meaning.textContent) { return []; }
    const text = element("p", {}, "Signal ", element("a", { href: `#signals/${name}`, textContent: name }), ": ");
    text.append(...copyOf(meaning).childNodes);
    return [text];
  }

  // Where else the page mentions the fact: tasks, examples, limits, notes, errata.
  function mentionsOf(path) {
    const holders = new Map();
    for (const link of main.querySelectorAll(`a[href="#${CSS.escape(path)}"], a[href="#${encodeURI(path).replace(/["\\]/g, "\\$&")}"]`)) {
      const holder = link.closest(".fact, nav") ? null : link.closest("[id]");
      if (holder && holder.id !== path && !holder.id.startsWith(`${path}/`)) { holders.set(holder.id, holder); }
    }
    const items = [...holders.keys()].sort().map((id) => element("li", {}, element("a", { href: `#${encodeURI(id)}`, textContent: id })));
    return items.length ? [element("ul", { className: "mentions" }, ...items)] : [];
  }

  function versionsOf(path) {
    const steps = data.steps.flatMap(([, at, rows]) => rows.filter((row) => row[0] === path).map((row) => `${data.pages[at][1]}: ${row[2]}`));
    const others = data.pages.filter((row) => row[0] !== page);
    const items = steps.map((text) => element("li", { textContent: text }));
    const links = others.flatMap(([file, name]) => [" ", element("a", { href: `${encodeURIComponent(file)}.html#${encodeURI(path)}`, textContent: name })]);
    return [...(items.length ? [element("ul", {}, ...items)] : []), ...(links.length ? [element("p", {}, "In the version", ...links)] : [])];
  }

  // ---- code ----

  function codesOf(path) {
    const rows = (data.code[path] || []).filter(([mask]) => holds(mask));
    const codes = new Map();
    for (const [, number, ...names] of rows) {
      const [name, template] = data.templates[number];
      const variables = data.variables[name][here()];
      const filled = template.replace(/@([0-9]+)@/g, (whole, number) => names[number] ?? whole);
      const text = filled.replace(/@([a-z]+)@/g, (whole, key) => variables[key] ?? whole);
      codes.set(name, codes.has(name) ? `${codes.get(name)}\n\n${text.trim()}` : text.trim());
    }
    return codes;
  }

  async function copy(button, source) {
    try {
      await navigator.clipboard.writeText(source.textContent);
      button.textContent = "Copied";
      setTimeout(() => { button.textContent = "Copy"; }, 2000);
    } catch {
      getSelection().selectAllChildren(source);  // the browser has no clipboard here, or forbids it
      button.textContent = "Selected";
    }
  }

  function codeOf(path) {
    const codes = codesOf(path);
    if (!codes.size) { return []; }
    const source = element("code");
    const block = element("pre", { tabIndex: 0 }, source);
    const copier = element("button", { type: "button", textContent: "Copy" });
    const choices = [...codes.keys()].map((name) => element("button", { type: "button", textContent: name }));
    function choose(name) {
      choices.forEach((button) => button.setAttribute("aria-pressed", String(button.textContent === name)));
      source.textContent = codes.get(name);
      copier.textContent = "Copy";
    }
    choices.forEach((button) => button.addEventListener("click", () => { language = button.textContent; choose(language); }));
    copier.addEventListener("click", () => copy(copier, source));
    choose(codes.has(language) ? language : codes.keys().next().value);
    const note = element("p", { className: "quiet", textContent: "Values and unit addresses are examples: check them before you send them." });
    return [element("div", { className: "tools" }, ...choices, copier), block, note];
  }

  // ---- opening ----

  function contentOf(row, path) {
    return [
      ...part("On the wire", ...wireOf(row, path)),
      ...part("Quantities", ...quantitiesOf(path)),
      ...part("Bits", ...bitsOf(row, path)),
      ...part("Values", ...valuesOf(row)),
      ...part("Signal", ...signalOf(path)),
      ...part("Code", ...codeOf(path)),
      ...part("Versions", ...versionsOf(path)),
      ...part("Mentioned by", ...mentionsOf(path))
    ];
  }

  function close(row) {
    const detail = details.get(row);
    if (!detail) { return; }
    detail.remove();
    details.delete(row);
    row.querySelector(".opener").setAttribute("aria-expanded", "false");
  }

  function open(row) {
    if (details.has(row)) { return; }
    const fact = element("div", { className: "fact" });
    const detail = element("tr", { className: "opened" }, element("td", { colSpan: row.cells.length }, fact));
    details.set(row, detail);
    row.after(detail);
    fact.style.width = `${row.closest(".scroll").clientWidth - 24}px`;
    const opener = row.querySelector(".opener");
    if (opener) { opener.setAttribute("aria-expanded", "true"); }
    withData(() => {
      const parts = contentOf(row, row.id);
      fact.append(...(parts.length ? parts : [element("p", { className: "quiet", textContent: "The row says everything." })]));
    });
  }

  const isOpenable = (row) => row.id && KINDS.includes(row.id.split("/")[0]) && !row.classList.contains("element");

  function equip(table) {
    for (const row of table.tBodies[0].rows) {
      const heading = row.querySelector("th[scope=row]");
      if (!heading || !isOpenable(row) || heading.querySelector(".opener")) { continue; }
      const button = element("button", { type: "button", className: "opener" });
      button.setAttribute("aria-label", `Open ${row.id.split("/").pop()}`);
      button.setAttribute("aria-expanded", "false");
      button.addEventListener("click", () => details.has(row) ? close(row) : open(row));
      heading.prepend(button);
    }
  }

  // After sorting and filtering, what belongs to a row stands below it and is hidden with it.
  main.addEventListener("arranged", () => {
    for (const [row, detail] of details) {
      if (row.nextElementSibling !== detail) { row.after(detail); }
      detail.hidden = row.hidden;
    }
  });

  // ---- frames as strips of bytes ----

  const OF_A_FRAME = ":scope > .scroll > table.frame, :scope > details > .scroll > table.frame";
  const SPAN = /^([0-9]+)(?:\.\.([0-9]+))?$/;

  function stripOf(table) {
    const boxes = [...table.tBodies[0].rows].filter((row) => !row.classList.contains("opened")).map((row) => {
      const place = row.cells[0].textContent;
      const match = SPAN.exec(place);
      const bytes = match ? Number(match[2] ?? match[1]) - Number(match[1]) + 1 : 3;
      const name = row.querySelector("th code") || row.cells[1];
      const box = element(row.id ? "a" : "span", { className: match ? "part" : "part open-ended" });
      if (row.id) { box.href = `#${encodeURI(row.id)}`; }
      box.append(element("span", { className: "quiet", textContent: place }), element("span", { textContent: name.textContent }));
      box.style.minWidth = `${Math.min(bytes, 8) * 1.6}rem`;
      return box;
    });
    return element("figure", {}, element("figcaption", { textContent: table.caption.textContent }), element("div", { className: "strip" }, ...boxes));
  }

  // The frames of a message stand beside each other, above the tables of their fields.
  function draw(section) {
    const tables = [...section.querySelectorAll(OF_A_FRAME)];
    const drawing = element("div", { className: "frames" }, ...tables.map(stripOf));
    const facts = section.querySelector(":scope > dl.facts, :scope > details > dl.facts");
    if (facts) { facts.after(drawing); } else { tables[0].parentElement.before(drawing); }
    if (!section.id.startsWith("messages/")) { return; }
    const button = element("button", { type: "button", textContent: "Code for this message" });
    button.setAttribute("aria-expanded", "false");
    const place = element("div", { className: "fact", hidden: true });
    button.addEventListener("click", () => withData(() => {
      if (!place.childElementCount) {
        const code = codeOf(section.id);
        place.append(...(code.length ? code : [element("p", { className: "quiet", textContent: "No output has a call with sample values for this message." })]));
      }
      place.hidden = !place.hidden;
      button.setAttribute("aria-expanded", String(!place.hidden));
    }));
    drawing.after(element("div", { className: "tools" }, button), place);
  }

  const near = new IntersectionObserver((seen) => {
    for (const { target, isIntersecting } of seen) {
      if (isIntersecting) {
        near.unobserve(target);
        if (target.tagName === "SECTION") { draw(target); } else { equip(target); }
      }
    }
  }, { rootMargin: "400px" });
  main.querySelectorAll(".scroll > table:not(.bits)").forEach((table) => near.observe(table));
  main.querySelectorAll("section").forEach((section) => { if (section.querySelector(OF_A_FRAME)) { near.observe(section); } });

  // A link to a fact opens it.
  function arrive() {
    let target = null;
    try { target = document.getElementById(decodeURIComponent(location.hash.slice(1))); } catch { return; }
    if (target && target.tagName === "TR" && isOpenable(target)) {
      equip(target.closest("table"));
      open(target);
      target.scrollIntoView({ block: "start" });
    }
  }
  window.addEventListener("hashchange", arrive);
  arrive();
})();
