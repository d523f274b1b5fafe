// Tables can be sorted by each column, filtered, and copied as CSV. Without this script they are as they stand.
"use strict";
(() => {
  const FILTERED = 6;  // a table with fewer rows is seen at a glance
  const CHOICES = ["Access", "Unit", "Restart"];
  const FORMULA = /^[=+\-@\t\r\n]/;
  const NUMBER = /^[-+]?[0-9]+(\.[0-9]+)?$/;
  const MOST_OPEN = 8;  // a section with more groups folds them
  const main = document.getElementById("content");
  let serial = 0;

  function element(tag, properties) { return Object.assign(document.createElement(tag), properties); }

  function lineOf(node) {
    const copy = node.cloneNode(true);
    copy.querySelectorAll("sup").forEach((mark) => mark.remove());
    copy.querySelectorAll("br").forEach((end) => end.replaceWith("\n"));
    copy.querySelectorAll("li").forEach((item) => item.prepend("\n"));
    return copy.textContent.split("\n").map((line) => line.trim()).filter(Boolean);
  }

  // A row with those that belong to it: elements stay below the row that they are elements of.
  function groupsOf(table) {
    const groups = [];
    for (const row of table.tBodies[0].rows) {
      if (row.classList.contains("opened")) { continue; }
      if (row.classList.contains("element") && groups.length) {
        groups[groups.length - 1].push(row);
      } else {
        groups.push([row]);
      }
    }
    return groups;
  }

  // ---- sorting ----

  // Numbers stand before texts, and cells without anything at the end.
  function sortKey(group, column) {
    const text = (lineOf(group[0].cells[column])[0] || "").split("..")[0];
    const value = /^0x[0-9a-f]+$/i.test(text) ? parseInt(text, 16) : parseFloat(text);
    return { rank: text === "" ? 2 : Number.isNaN(value) ? 1 : 0, value, text };
  }

  function compared(a, b) {
    if (a.rank !== b.rank) { return a.rank - b.rank; }
    return a.rank === 0 && a.value !== b.value ? a.value - b.value : a.text.localeCompare(b.text, "en", { numeric: true });
  }

  function sort(table, groups, heading, column) {
    const direction = { ascending: "descending", descending: "" }[heading.getAttribute("aria-sort")] ?? "ascending";
    for (const other of table.tHead.rows[0].cells) { other.removeAttribute("aria-sort"); }
    let order = groups;
    if (direction) {
      heading.setAttribute("aria-sort", direction);
      const sign = direction === "ascending" ? 1 : -1;
      const keyed = groups.map((group) => ({ group, key: sortKey(group, column) }));
      order = keyed.sort((a, b) => (a.key.rank === 2 || b.key.rank === 2 ? 1 : sign) * compared(a.key, b.key))
        .map((entry) => entry.group);
    }
    table.tBodies[0].append(...order.flat());
    table.dispatchEvent(new Event("arranged", { bubbles: true }));
  }

  // ---- filtering ----

  const valueOf = (row, column) => row.cells[column] ? lineOf(row.cells[column]).join(" ") : "";

  function choice(title, column, groups, apply) {
    const values = [...new Set(groups.map((group) => valueOf(group[0], column)).filter(Boolean))].sort();
    if (values.length < 2) { return null; }
    const select = element("select", { onchange: null });
    select.append(new Option(`any ${title.toLowerCase()}`, ""), ...values.map((value) => new Option(value, value)));
    select.setAttribute("aria-label", title);
    select.addEventListener("change", apply);
    return { select, column };
  }

  function filters(table, headings, groups, tools) {
    const texts = new Map(groups.map((group) => [group, group.map((row) => row.textContent).join(" ").toLowerCase()]));
    const count = element("span", { className: "quiet" });
    const word = element("input", { type: "search", placeholder: "rows with \u2026" });
    const choices = [];
    word.setAttribute("aria-label", `Rows of ${table.caption.textContent} with`);
    count.setAttribute("role", "status");

    function apply() {
      const words = word.value.toLowerCase().split(/\s+/).filter(Boolean);
      let visible = 0;
      for (const group of groups) {
        const fits = words.every((part) => texts.get(group).includes(part))
          && choices.every(({ select, column }) => !select.value || valueOf(group[0], column) === select.value);
        group.forEach((row) => { row.hidden = !fits; });
        visible += fits ? 1 : 0;
      }
      table.dispatchEvent(new Event("arranged", { bubbles: true }));
      count.textContent = visible < groups.length ? `${visible} of ${groups.length} rows` : "";
    }

    headings.forEach((title, column) => {
      const made = CHOICES.includes(title) ? choice(title, column, groups, apply) : null;
      if (made) { choices.push(made); }
    });
    word.addEventListener("input", apply);
    tools.append(word, ...choices.map(({ select }) => select), count);
    table.addEventListener("reveal", () => {
      word.value = "";
      choices.forEach(({ select }) => { select.value = ""; });
      apply();
    });
  }

  // ---- CSV ----

  // A text that a spreadsheet would take for a formula has an apostrophe before it.
  function csvCell(text) {
    const guarded = FORMULA.test(text) && !NUMBER.test(text) ? `'${text}` : text;
    return /[",\r\n]/.test(guarded) ? `"${guarded.replace(/"/g, '""')}"` : guarded;
  }

  function csvOf(table, headings) {
    const rows = [...table.tBodies[0].rows].filter((row) => !row.hidden && !row.classList.contains("opened"))
      .map((row) => [...row.cells].map((cell) => lineOf(cell).join("; ")));
    return [headings, ...rows].map((row) => row.map(csvCell).join(",") + "\r\n").join("");
  }

  function offer(block, tools, text) {
    let field = block.querySelector("textarea");
    if (!field) {
      field = element("textarea", { readOnly: true, rows: 8 });
      field.setAttribute("aria-label", "The rows as CSV, to copy");
      tools.after(field);
    }
    field.value = text;
    field.focus();
    field.select();
  }

  async function copy(block, table, tools, headings, button) {
    const text = csvOf(table, headings);
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "Copied";
      setTimeout(() => { button.textContent = "Copy as CSV"; }, 2000);
    } catch {
      offer(block, tools, text);  // the browser has no clipboard here, or forbids it
    }
  }

  // ---- a table ----

  function equip(block, table) {
    const cells = [...table.tHead.rows[0].cells];
    const headings = cells.map((cell) => cell.textContent);
    const groups = groupsOf(table);
    const tools = element("div", { className: "tools" });
    if (groups.length >= FILTERED) { filters(table, headings, groups, tools); }
    const button = element("button", { type: "button", textContent: "Copy as CSV" });
    button.addEventListener("click", () => copy(block, table, tools, headings, button));
    tools.append(button);
    block.before(tools);
    if (groups.length < 2) { return; }
    cells.forEach((cell, column) => {
      const sorter = element("button", { type: "button", textContent: cell.textContent });
      sorter.addEventListener("click", () => sort(table, groups, cell, column));
      cell.replaceChildren(sorter);
    });
  }

  // What scrolls can be reached by the keyboard.
  function reach(block) {
    const name = block.querySelector("caption, svg");
    if (!name) { return; }
    name.id = name.id || `name-${serial += 1}`;
    block.tabIndex = 0;
    block.setAttribute("role", "group");
    block.setAttribute("aria-labelledby", name.id);
  }

  // ---- what is folded ----

  function fold(summary, ...nodes) {
    const folded = element("details", {});
    folded.append(element("summary", {}), ...nodes);
    folded.firstChild.append(summary);
    folded.addEventListener("toggle", () => reachAll());
    return folded;
  }

  // The tables of an example are folded: its strips of bytes say most, and all tables together make most of a long page.
  for (const section of document.querySelectorAll("section[id^='examples/']")) {
    section.append(fold("Byte by byte", ...section.querySelectorAll(":scope > .scroll")));
  }

  // The groups of a long section are folded below their headings, so that the page is its own table of contents.
  for (const section of document.querySelectorAll("main > section")) {
    const groups = [...section.querySelectorAll(":scope > section")];
    if (groups.length <= MOST_OPEN) { continue; }
    const folds = groups.map((group) => fold(...group.children));
    groups.forEach((group, number) => group.append(folds[number]));
    const tools = element("div", { className: "tools" });
    const button = element("button", { type: "button", textContent: `Open all ${folds.length} groups` });
    button.addEventListener("click", () => {
      const open = folds.some((group) => !group.open);
      folds.forEach((group) => { group.open = open; });
      button.textContent = `${open ? "Close" : "Open"} all ${folds.length} groups`;
    });
    tools.append(button);
    groups[0].before(tools);
  }
  window.addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((node) => { node.open = true; }));

  // A table gets its tools when it comes near the screen: most of a long page is never seen.
  const blocks = [...document.querySelectorAll(".scroll")];
  const near = new IntersectionObserver((seen) => {
    for (const { target, isIntersecting } of seen) {
      if (isIntersecting) {
        near.unobserve(target);
        const table = target.querySelector("table:not(.bits)");
        if (table) { equip(target, table); }
      }
    }
  }, { rootMargin: "400px" });
  blocks.forEach((block) => near.observe(block));
  const reachAll = () => blocks.filter((block) => block.scrollWidth > block.clientWidth || block.scrollHeight > block.clientHeight).forEach(reach);
  window.addEventListener("resize", reachAll);
  reachAll();

  // A link to a row that a filter hides ends the filter; a link into a group opens it.
  function arrive() {
    let target = null;
    try { target = document.getElementById(decodeURIComponent(location.hash.slice(1))); } catch { return; }
    if (!target || !main.contains(target)) { return; }
    if (target.closest("[hidden]")) { target.closest("table").dispatchEvent(new Event("reveal")); }
    for (let fold = target.querySelector(":scope > details") || target; fold; fold = fold.parentElement.closest("details")) {
      if (fold.tagName === "DETAILS") { fold.open = true; }
    }
    target.scrollIntoView();
  }
  window.addEventListener("hashchange", arrive);
  arrive();
})();
