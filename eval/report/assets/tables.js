// SPDX-License-Identifier: BSD-3-Clause
// Tables are sorted by a column when its head is pressed: ascending, descending, as they were.

const nextOrder = {
  none: 'ascending',
  ascending: 'descending',
  descending: 'none'
};

// A cell as a key: its number where it is one, null for a dash.
function sortKey(cell) {
  const text = cell.textContent;
  if (text === '–') return null;
  return cell.classList.contains('number') ? parseFloat(text) : text;
}

// Dashes last in either order; numbers before texts.
function compareKeys(a, b, sign) {
  if (a === null || b === null) return (a === null) - (b === null);
  if (typeof a !== typeof b) return typeof a === 'number' ? -1 : 1;
  return sign * (typeof a === 'number' ? a - b : a.localeCompare(b, 'en', {numeric: true}));
}

function sortedRows(rows, column, order) {
  if (order === 'none') return rows;
  const keys = new Map(rows.map((row) => [row, sortKey(row.cells[column])]));
  const sign = order === 'ascending' ? 1 : -1;
  return [...rows].sort((a, b) => compareKeys(keys.get(a), keys.get(b), sign));
}

function makeSortable(table) {
  const heads = [...table.tHead.rows[0].cells];
  const rows = [...table.tBodies[0].rows];
  const sortBy = (column) => {
    const order = nextOrder[heads[column].getAttribute('aria-sort')];
    heads.forEach((head, i) => head.setAttribute('aria-sort', i === column ? order : 'none'));
    table.tBodies[0].append(...sortedRows(rows, column, order));
  };
  heads.forEach((head, column) => {
    const button = element('button', {type: 'button', textContent: head.textContent});
    button.addEventListener('click', () => sortBy(column));
    head.replaceChildren(button);
    head.setAttribute('aria-sort', 'none');
  });
}

function makeTablesSortable() {
  document.querySelectorAll('figure.table table').forEach(makeSortable);
}
