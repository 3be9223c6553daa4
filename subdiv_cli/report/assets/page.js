"use strict";
// Sorts the table of masks by a column and filters it with its cards; without scripts the page is the same, unsorted.
const table = document.querySelector(".overview");
const rows = Array.from(table.tBodies[0].rows);
const heads = Array.from(table.tHead.rows[0].cells);

function compare(a, b) {
  const x = a.dataset.sort, y = b.dataset.sort;
  if (x === "" || y === "") return (x === "") - (y === "");
  const m = Number(x), n = Number(y);
  return Number.isNaN(m) || Number.isNaN(n) ? x.localeCompare(y) : m - n;
}

heads.forEach((head, column) => {
  head.querySelector("button").addEventListener("click", () => {
    const down = head.getAttribute("aria-sort") === "ascending";
    heads.forEach((other) => other.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    const sign = down ? -1 : 1;
    const sorted = rows.slice().sort((a, b) => {
      const x = a.cells[column], y = b.cells[column];
      const empty = (x.dataset.sort === "") !== (y.dataset.sort === "");
      return (empty ? 1 : sign) * compare(x, y);
    });
    table.tBodies[0].append(...sorted);
  });
});

const text = document.getElementById("text"), status = document.getElementById("status");
function filter() {
  const wanted = text.value.toLowerCase();
  for (const row of rows) {
    const fits = row.dataset.text.includes(wanted) && (!status.value || row.dataset.status === status.value);
    row.hidden = !fits;
    document.getElementById(row.dataset.card).hidden = !fits;
  }
}
text.addEventListener("input", filter);
status.addEventListener("change", filter);
document.querySelector(".find").hidden = false;
