// The page of a version can be compared with another one: what has changed stands in a table, and at the facts.
"use strict";
(() => {
  const page = document.getElementById("search").dataset.page;
  const menu = document.getElementById("versions");
  if (!page || !menu || !window.fieldspecFacts) { return; }
  const header = document.querySelector("main > header");

  function element(tag, properties = {}, ...children) {
    const node = Object.assign(document.createElement(tag), properties);
    node.append(...children);
    return node;
  }

  // The steps that lead from one version to another one along the lines, the oldest first; null where none do.
  function steps(data, from, to) {
    const ways = [[from, []]];
    const seen = new Set([from]);
    while (ways.length) {
      const [at, taken] = ways.shift();
      if (at === to) { return taken; }
      for (const step of data.steps) {
        const next = step[0] === at ? step[1] : -1;
        if (next >= 0 && !seen.has(next)) {
          seen.add(next);
          ways.push([next, [...taken, step]]);
        }
      }
    }
    return null;
  }

  // The innermost element of the page that a path belongs to.
  function targetOf(path) {
    for (let rest = path; rest; rest = rest.slice(0, Math.max(0, rest.lastIndexOf("/")))) {
      const target = document.getElementById(rest);
      if (target) { return target; }
    }
    return null;
  }

  function clear() {
    document.querySelectorAll(".difference, #differences").forEach((node) => node.remove());
  }

  function row(data, [path, effect, message], at) {
    const target = targetOf(path);
    const version = data.pages[at][1];
    const fact = target ? element("a", { href: `#${encodeURI(target.id)}`, textContent: path })
      : element("a", { href: `${encodeURIComponent(data.pages[at][0])}.html#${encodeURI(path)}`, textContent: path });
    if (target && target.id === path) {
      const place = target.tagName === "TR" ? target.querySelector("th[scope=row]") || target.cells[0] : target.querySelector("h3, h2");
      place.append(element("span", { className: "difference", textContent: `${version}: ${message}` }));
    }
    return element("tr", {}, element("td", { className: "short", textContent: version }), element("td", { className: "short", textContent: effect }),
      element("td", { className: "wide", textContent: message }), element("td", {}, fact));
  }

  function compare(data) {
    clear();
    const here = window.fieldspecFacts.pageNumber();
    const other = Number(menu.value);
    if (menu.value === "" || other === here) { return; }
    const older = Math.max(here, other), newer = Math.min(here, other);  // the newest one is the first
    const taken = steps(data, older, newer);
    const section = element("section", { id: "differences" });
    section.append(element("h2", { textContent: `From ${data.pages[older][1]} to ${data.pages[newer][1]}` }));
    if (!taken) {
      section.append(element("p", { textContent: "No line of versions leads from one to the other." }));
    } else {
      const rows = taken.flatMap(([, at, changes]) => changes.map((change) => row(data, change, at)));
      const titles = ["With", "Effect", "Change", "Fact"].map((title) => element("th", { scope: "col", textContent: title }));
      const table = element("table", {}, element("caption", { textContent: `${rows.length} changes; the facts below are marked` }),
        element("thead", {}, element("tr", {}, ...titles)), element("tbody", {}, ...rows));
      section.append(element("div", { className: "scroll", tabIndex: 0, role: "group", ariaLabel: "Changes" }, table));
    }
    header.after(section);
  }

  menu.addEventListener("change", () => window.fieldspecFacts.whenLoaded((content) => compare(content)));
  menu.closest("p").hidden = false;
})();
