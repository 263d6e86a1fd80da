// The table of students can be searched and sorted; without this script it is all there, in the order of the roster.
"use strict";
(() => {
  const table = document.querySelector("table.students");
  if (!table) return;
  const body = table.tBodies[0], rows = [...body.rows];
  const form = document.querySelector("form.search"), box = form.querySelector("input"), count = form.querySelector("output");
  const words = new Map(rows.map(row => [row, row.textContent.toLowerCase().replace(/\s+/g, " ")]));

  function search() {
    const wanted = box.value.toLowerCase().split(",").map(each => each.trim().replace(/\s+/g, " ")).filter(Boolean);
    let found = 0;
    for (const row of rows) {
      row.hidden = !wanted.every(each => words.get(row).includes(each));
      found += !row.hidden;
    }
    count.textContent = wanted.length ? `${found} of ${rows.length}` : "";
  }

  function button(cell, label, act) {
    const made = document.createElement("button");
    made.type = "button";
    made.append(...cell.childNodes);
    if (label) made.setAttribute("aria-label", label);
    made.addEventListener("click", act);
    cell.append(made);
  }

  const value = (row, at) => row.cells[at].dataset.value ?? row.cells[at].textContent;
  const compare = new Intl.Collator(undefined, { numeric: true }).compare;
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, at) => button(head, "", () => {
    const numbers = head.classList.contains("number");
    const before = head.getAttribute("aria-sort");
    const upwards = before ? before === "descending" : !numbers;
    heads.forEach(each => each.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", upwards ? "ascending" : "descending");
    const order = (a, b) => numbers ? value(a, at) - value(b, at) : compare(value(a, at), value(b, at));
    rows.sort((a, b) => upwards ? order(a, b) : order(b, a));
    body.append(...rows);
  }));

  for (const cell of document.querySelectorAll("[data-find]")) {
    button(cell, `${cell.textContent}: ${cell.dataset.find}, show the students`, () => {
      box.value = cell.dataset.find;
      search();
      box.focus();
      document.getElementById("students").scrollIntoView();
    });
  }
  box.addEventListener("input", search);
  form.addEventListener("submit", event => event.preventDefault());
  form.hidden = false;
})();
