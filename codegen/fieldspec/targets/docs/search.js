// The search box of every page. The data is in files beside the pages, each a call of `fieldspecSearch.add`; they are
// loaded when the box is first used. Results are links, so that they can be opened in any way that the browser offers.
"use strict";
(() => {
  const MOST = 40;  // results on the screen
  const AROUND = 70;  // characters of a text on each side of a match
  const EXACT = 0, BARE = 1, PREFIX = 2, WORD = 3, TEXT = 4, CONTEXT = 5, NONE = 6;

  // Words for the kinds of facts, besides the titles of their sections.
  const KINDS = {
    registers: "register address", tables: "record address", parameters: "parameter pnu", words: "telegram word",
    messages: "message command function code telegram", codes: "alarm fault warning exception code", flags: "bit flag",
    enums: "value enum", lookups: "table", limits: "limit", errata: "erratum", notes: "note", tasks: "task"
  };

  const panel = document.getElementById("search");
  const box = document.getElementById("query");
  const list = document.getElementById("results");
  const status = document.getElementById("found");
  const sources = panel.dataset.sources.split(" ");
  const page = panel.dataset.page;
  const entries = [];
  let waiting = null;  // the number of files that are not here yet; null before the box is used

  const folded = (text) => text.normalize("NFKC").toLowerCase().replace(/[_\s]+/g, " ").trim();

  // ---- numbers: 0x7E6, 7E6h, 16#7E6, $7E6 and 2022 are the same address ----

  const HEXADECIMAL = /^(?:(?:0x|16#|\$|&h)([0-9a-f]{1,16})|([0-9][0-9a-f]{0,15})h)$/;

  function number(text) {
    const match = HEXADECIMAL.exec(text);
    if (match) { return parseInt(match[1] || match[2], 16); }
    return /^[0-9]{1,15}$/.test(text) ? parseInt(text, 10) : NaN;
  }

  // A key is a number, an interval 0x10..0x13, either of them repeated (+distance*count), or a text.
  function parsedKey(text) {
    const [span, repeated] = text.split("+");
    const [low, high] = span.split("..");
    const first = number(low);
    if (Number.isNaN(first)) { return { text, first: NaN, last: NaN, distance: 0, count: 1 }; }
    const last = high === undefined ? first : number(high);
    const [distance, count] = repeated ? repeated.split("*").map(Number) : [0, 1];
    return { text: low, first, last, distance, count };
  }

  function keyLevel(key, value, bare, text) {
    if (key.text === text || key.first === value && !key.distance) { return EXACT; }
    if (key.count > 1 && value >= key.first) {
      const element = Math.min(Math.floor((value - key.first) / key.distance), key.count - 1);
      const offset = value - key.first - element * key.distance;
      if (offset <= key.last - key.first) { return offset === 0 ? EXACT : BARE; }
    }
    if (value > key.first && value <= key.last || bare === key.first) { return BARE; }
    return text.length > 2 && key.text.startsWith(text) ? PREFIX : NONE;
  }

  // ---- ranking: exact numbers and names, then beginnings of names, words in names, texts, and where the fact stands ----

  const beginsWord = (text, token) => text.startsWith(token) || text.includes(` ${token}`);

  function termOf(text) {
    const bare = /^[0-9a-f]{2,8}$/.test(text) ? parseInt(text, 16) : NaN;
    return { text, value: number(text), bare };
  }

  function levelOf(entry, term) {
    let level = NONE;
    for (const key of entry.keys) { level = Math.min(level, keyLevel(key, term.value, term.bare, term.text)); }
    for (const name of entry.names) {
      if (level === EXACT) { return EXACT; }
      if (name === term.text) { return EXACT; }
      if (name.startsWith(term.text)) {
        level = Math.min(level, PREFIX);
      } else if (name.includes(` ${term.text}`)) {
        level = Math.min(level, WORD);
      } else if (name.includes(term.text)) {
        level = Math.min(level, TEXT);
      }
    }
    if (level < TEXT) { return level; }
    if (entry.text.includes(term.text)) { return TEXT; }
    return level < NONE ? level : beginsWord(entry.context, term.text) ? CONTEXT : NONE;
  }

  // The rank of an entry for a whole query, the smallest first; null where some word is nowhere. The name of a list
  // beside an exact number, as in `alarm 3`, means just that fact.
  function rankOf(entry, terms, whole) {
    const levels = terms.map((term) => levelOf(entry, term));
    const best = Math.min(...levels);
    if (levels.includes(NONE)) { return null; }
    const isList = (level, term) => best === EXACT && level === CONTEXT && beginsWord(entry.list, term.text);
    const sum = levels.reduce((total, level, at) => total + (isList(level, terms[at]) ? EXACT : level), 0);
    if (terms.length > 1 && entry.names.includes(whole)) { return [EXACT, 0]; }
    return best < CONTEXT ? [best, sum] : null;
  }

  function matches(query) {
    const whole = folded(query);
    const terms = whole.split(" ").filter(Boolean).map(termOf);
    if (!terms.length) { return []; }
    const result = [];
    for (const entry of entries) {
      const rank = rankOf(entry, terms, whole);
      if (rank) { result.push({ entry, rank, terms }); }
    }
    return result.sort((a, b) => a.rank[0] - b.rank[0] || a.rank[1] - b.rank[1]
      || (a.entry.device === b.entry.device ? a.entry.order - b.entry.order : a.entry.device < b.entry.device ? -1 : 1));
  }

  // ---- typing errors: a word that nothing has is read as the nearest word of a name ----

  // The edits between two words, a swap of neighbours counting as one; more than `most` are not counted.
  function edits(a, b, most) {
    if (Math.abs(a.length - b.length) > most) { return most + 1; }
    let before = [], last = Array.from({ length: b.length + 1 }, (_, column) => column);
    for (let row = 1; row <= a.length; row += 1) {
      const next = [row];
      for (let column = 1; column <= b.length; column += 1) {
        const cost = Number(a[row - 1] !== b[column - 1]);
        next[column] = Math.min(last[column] + 1, next[column - 1] + 1, last[column - 1] + cost);
        if (row > 1 && column > 1 && a[row - 1] === b[column - 2] && a[row - 2] === b[column - 1]) {
          next[column] = Math.min(next[column], before[column - 2] + 1);
        }
      }
      if (Math.min(...next) > most) { return most + 1; }
      before = last;
      last = next;
    }
    return last[b.length];
  }

  function corrected(query) {
    const known = new Set(entries.flatMap((entry) => entry.names).flatMap((name) => name.split(" ")));
    const nearest = (word) => {
      let best = word, least = word.length < 4 ? 0 : word.length < 8 ? 1 : 2;
      if (!Number.isNaN(number(word)) || entries.some((entry) => levelOf(entry, termOf(word)) < NONE)) { return word; }
      for (const other of known) {
        const count = edits(word, other, least);
        if (count <= least && other.length > 2) { best = other; least = count - 1; }
      }
      return best;
    };
    return folded(query).split(" ").map(nearest).join(" ");
  }

  // ---- a pasted frame leads to the frame labs ----

  const FRAME = /^(?:(?:0x)?[0-9a-f]{2}(?:[\s,:-]+(?:0x)?[0-9a-f]{2}){3,}|(?:[0-9a-f]{2}){6,}|:(?:[0-9a-f]{2}){4,}(?:\\r\\n)?)$/i;

  function labs(query) {
    if (!FRAME.test(query.trim())) { return []; }
    const hrefs = [...document.querySelectorAll("a[href*='lab.html']")].map((link) => link.getAttribute("href"));
    return [...new Set(hrefs)].map((href) => {
      const link = element("a", "");
      const [file, state] = href.split("#");
      const values = new URLSearchParams(state);
      values.set("frames", query.trim());
      link.href = `${file}#${values}`;
      const device = href.includes("/") ? `, ${decodeURIComponent(href.split("/")[0])}` : "";
      link.append(element("span", "Explain this frame", "hit"), element("span", `frame lab${device}`, "quiet"));
      const node = document.createElement("li");
      node.append(link);
      return node;
    });
  }

  // ---- data ----

  function add(data) {
    const folder = data.folder;
    const here = folder === "" ? data.pages.findIndex((row) => row[0] === page) : -1;
    for (const [kind, section, start, rows] of data.groups) {
      for (const [end, names, keys, text, versions] of rows) {
        const labels = names.split("\n");
        const at = here >= 0 && (!versions || versions >> here & 1) ? here : versions ? 31 - Math.clz32(versions & -versions) : 0;
        const anchor = [start, end === 0 ? labels[0] : end].filter(Boolean).join("/");
        const file = at === here ? "" : `${folder}${encodeURIComponent(data.pages[at][0])}.html`;
        const only = versions && at !== here
          ? data.pages.filter((row, bit) => versions >> bit & 1).map((row) => row[1]).join(", ") : "";
        entries.push({
          link: `${file}#${encodeURI(anchor)}`,
          labels,
          language: data.language,
          where: [sources.length > 1 ? data.name : "", labels.every((label) => section.includes(label)) ? kind : section].filter(Boolean).join(" \u203a "),
          only,
          numbers: keys || "",
          prose: text || "",
          names: labels.map(folded),
          keys: keys ? keys.toLowerCase().split(" ").map(parsedKey) : [],
          text: text ? folded(text) : "",
          list: folded(section),
          context: folded(`${data.name} ${data.id} ${kind} ${KINDS[kind] || ""} ${section} ${start.replace(/\//g, " ")}`),
          device: data.id,
          order: entries.length
        });
      }
    }
  }

  function load() {
    if (waiting !== null) { return; }
    waiting = sources.length;
    for (const source of sources) {
      const script = document.createElement("script");
      script.src = source;
      script.onload = () => { waiting -= 1; apply(); };
      script.onerror = () => { status.textContent = `The search data ${source} cannot be read.`; };
      document.head.append(script);
    }
  }

  // ---- the panel ----

  function element(tag, text, style, language) {
    const node = document.createElement(tag);
    node.textContent = text;
    if (style) { node.className = style; }
    if (language) { node.lang = language; }
    return node;
  }

  // The part of a text around the first match of a word, or its beginning.
  function excerpt(entry, terms) {
    const lower = entry.prose.toLowerCase();
    const at = Math.max(0, ...terms.map((term) => lower.indexOf(term.text)));
    const first = at > AROUND ? entry.prose.indexOf(" ", at - AROUND) + 1 : 0;
    const part = entry.prose.slice(first, first + 3 * AROUND);
    return (first ? "\u2026" : "") + part + (first + part.length < entry.prose.length ? "\u2026" : "");
  }

  function item({ entry, terms }) {
    const link = document.createElement("a");
    link.href = entry.link;
    const head = element("span", "", "hit");
    head.append(element("code", entry.labels[0]));
    for (const label of entry.labels.slice(1)) { head.append(" ", element("i", label, "", entry.language)); }
    if (entry.only) { head.append(" ", element("span", `only ${entry.only}`, "badge")); }
    const numbers = entry.numbers.replace(/\+(\d+)\*(\d+)/g, " and $2 elements").replace("and 1 elements", "");
    link.append(head, element("span", [numbers, entry.where].filter(Boolean).join(" \u00b7 "), "quiet"));
    if (entry.prose) { link.append(element("span", excerpt(entry, terms))); }
    const node = document.createElement("li");
    node.append(link);
    return node;
  }

  function apply() {
    const query = box.value;
    const frames = labs(query);
    let hits = frames.length ? [] : matches(query);
    let read = "";
    if (!hits.length && !frames.length && waiting === 0 && query.trim()) {
      read = corrected(query);
      hits = read === folded(query) ? [] : matches(read);
    }
    list.replaceChildren(...frames, ...hits.slice(0, MOST).map(item));
    list.hidden = !list.children.length;
    const count = list.children.length === 1 ? "1 result" : `${frames.length + hits.length} results`;
    const whole = `${count}${waiting ? " so far" : ""}${hits.length && read ? ` for ${read}` : ""}`;
    status.textContent = !query.trim() ? "" : hits.length > MOST ? `${whole}, the first ${MOST} here` : whole;
  }

  function close() {
    box.value = "";
    apply();
  }

  function move(event, step) {
    const stops = [box, ...list.querySelectorAll("a")];
    const at = stops.indexOf(document.activeElement);
    if (at < 0 || stops.length < 2) { return; }
    event.preventDefault();
    stops[Math.min(Math.max(at + step, 0), stops.length - 1)].focus();
  }

  const isTyping = (node) => node.matches("input, textarea, select") || node.isContentEditable;

  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) { return; }
    const within = panel.contains(document.activeElement);
    if (event.key === "/" && !isTyping(document.activeElement)) {
      event.preventDefault();
      box.focus();
      box.select();
    } else if (event.key === "Escape" && within) {
      close();
      box.focus();
    } else if (within && event.key === "ArrowDown") {
      move(event, 1);
    } else if (within && event.key === "ArrowUp") {
      move(event, -1);
    } else if (event.key === "Enter" && document.activeElement === box && !list.hidden) {
      event.preventDefault();
      list.querySelector("a").click();
    }
  });
  box.addEventListener("focus", load);
  box.addEventListener("input", () => { load(); apply(); });
  list.addEventListener("click", (event) => {
    if (!event.ctrlKey && !event.metaKey && !event.shiftKey && event.target.closest("a")) { close(); }
  });

  // ---- links to facts ----

  // A link to a fact that the page does not have searches for its name.
  function arrive() {
    let anchor = location.hash.slice(1);
    try { anchor = decodeURIComponent(anchor); } catch { /* it is not an escape, but text */ }
    if (!anchor || anchor.includes("=")) { return; }  // with values it is the state of a page, not a fact
    const target = document.getElementById(anchor);
    if (target) {
      target.tabIndex = -1;
      target.focus({ preventScroll: true });
      return;
    }
    box.value = anchor.split("/").pop().replace(/_/g, " ");
    load();
    apply();
    box.focus();
  }

  window.fieldspecSearch = {
    add(data) {
      const source = document.currentScript.getAttribute("src");
      add({ ...data, folder: source.slice(0, source.lastIndexOf("/") + 1) });
    }
  };
  window.addEventListener("hashchange", arrive);
  panel.hidden = false;
  arrive();
  if (box.value) { load(); }
})();
