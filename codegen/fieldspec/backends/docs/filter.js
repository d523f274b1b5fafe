(function () {
  "use strict";
  var box = document.getElementById("filter");
  var count = document.getElementById("count");
  var main = document.getElementById("content");

  function lower(node) { return node.textContent.toLowerCase(); }
  function list(found) { return Array.prototype.slice.call(found); }

  // A unit is a section with what stands in it directly: its own text, and the rows of its tables.
  var units = list(main.querySelectorAll("section")).map(function (section) {
    var blocks = list(section.children).filter(function (child) { return child.tagName !== "SECTION"; });
    var tables = blocks.filter(function (child) { return child.querySelector("table:not(.bits)"); });
    var others = blocks.filter(function (child) { return tables.indexOf(child) < 0; });
    return {
      section: section,
      text: others.map(lower).join(" "),
      outer: blocks.length < section.children.length,
      tables: tables.map(function (block) {
        var rows = list(block.querySelectorAll("tbody > tr"));
        return { block: block, rows: rows.map(function (row) { return { row: row, text: lower(row) }; }) };
      })
    };
  });
  var links = list(document.querySelectorAll("nav li")).map(function (item) {
    return { item: item, section: document.getElementById(item.querySelector("a").getAttribute("href").slice(1)) };
  });

  function apply() {
    var words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
    var shown = 0, all = 0;
    units.forEach(function (unit) {
      var whole = words.every(function (word) { return unit.text.indexOf(word) >= 0; });
      var found = whole && !unit.outer;
      unit.tables.forEach(function (table) {
        var inside = 0;
        table.rows.forEach(function (entry) {
          var hit = whole || words.every(function (word) {
            return entry.text.indexOf(word) >= 0 || unit.text.indexOf(word) >= 0;
          });
          entry.row.hidden = !hit;
          inside += hit;
        });
        table.block.hidden = !inside;
        shown += inside;
        all += table.rows.length;
        found = found || inside > 0;
      });
      unit.section.hidden = !found;
    });
    // A section is there for what lies within it, too.
    units.slice().reverse().forEach(function (unit) {
      var outer = unit.section.parentElement;
      if (!unit.section.hidden && outer.tagName === "SECTION") { outer.hidden = false; }
    });
    links.forEach(function (link) { link.item.hidden = link.section.hidden; });
    count.textContent = words.length ? shown + " of " + all + " rows" : "";
  }

  function reveal() {
    var target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target && target.closest("[hidden]")) {
      box.value = "";
      apply();
      target.scrollIntoView();
    }
  }

  box.addEventListener("input", apply);
  window.addEventListener("hashchange", reveal);
  document.addEventListener("keydown", function (event) {
    if (event.key === "/" && document.activeElement !== box) { event.preventDefault(); box.focus(); box.select(); }
    if (event.key === "Escape" && document.activeElement === box) { box.value = ""; apply(); }
  });
  list(document.querySelectorAll(".scroll")).forEach(function (block) {
    if (block.scrollWidth > block.clientWidth) {
      block.tabIndex = 0;
      block.setAttribute("role", "region");
      block.setAttribute("aria-label", block.querySelector("caption").textContent);
    }
  });
  if (box.value) { apply(); }
})();
