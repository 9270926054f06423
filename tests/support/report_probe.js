// SPDX-License-Identifier: BSD-3-Clause
// Appended to a page by a test: uses the page as a reader does and leaves what it saw in <pre id="probe">.
'use strict';

const all = (selector, root = document) => [...root.querySelectorAll(selector)];
const texts = (nodes) => nodes.map((node) => node.textContent);
const within = (plot, selector) => all(`[data-plot="${plot}"]`).map((figure) => all(selector, figure).length);
const tableCells = () =>
    all('figure.table table').map((table) => all('tbody tr', table).map((row) => texts([...row.cells])));

// What a table's column shows, and its head says, after each of three presses.
function sortedByPressing(table, column) {
  const head = all('th', table)[column];
  return [1, 2, 3].map(() => {
    head.querySelector('button').click();
    return [head.getAttribute('aria-sort'), texts(all(`tbody td:nth-child(${column + 1})`, table))];
  });
}

function coloursOf(canvas) {
  const copy = Object.assign(document.createElement('canvas'), {width: 200, height: 150}).getContext('2d');
  copy.drawImage(canvas, 0, 0, 200, 150);
  return new Set(new Uint32Array(copy.getImageData(0, 0, 200, 150).data.buffer)).size;
}

function enlargedPicture() {
  all('.gallery button')[1].click();
  const dialog = document.querySelector('dialog');
  const seen = [dialog.open, dialog.querySelector('img').alt];
  dialog.close();
  return seen;
}

// Whether each panel of the first map has moved: after the wheel over one of them, after "whole map".
function movedByWheel() {
  const figure = document.querySelector('[data-plot="maps"]');
  const paths = () => all('path.path', figure).map((path) => path.getAttribute('d'));
  const before = paths();
  const moved = () => paths().map((d, i) => d !== before[i]);
  figure.querySelector('svg').dispatchEvent(
      new WheelEvent('wheel', {bubbles: true, cancelable: true, deltaY: -200, clientX: 300, clientY: 0}));
  const wheel = moved();
  figure.querySelector('.map + .controls button').click();
  return [wheel, moved()];
}

// Chooses the second sequence of the 3D view, where there is a choice.
function otherScene() {
  const select = document.querySelector('[data-plot="scenes"] select');
  if (!select) return null;
  select.selectedIndex = 1;
  select.dispatchEvent(new Event('change'));
  return all('canvas').map(coloursOf);
}

// Drawn: the picture was understood, and has room on the page. The background is that of the dark scheme.
function plots() {
  document.documentElement.dataset.theme = 'dark';
  const seen = all('.plots img').map((img) => ({
                                       alt: img.alt,
                                       drawn: img.naturalWidth === 900 && img.clientWidth > 200,
                                       background: getComputedStyle(img).backgroundColor,
                                     }));
  document.documentElement.dataset.theme = 'auto';
  return seen;
}

function backgrounds() {
  return [1, 2].map(() => {
    document.getElementById('theme').click();
    return getComputedStyle(document.body).backgroundColor;
  });
}

document.querySelector('[data-plot="scenes"]').scrollIntoView({behavior: 'instant'});  // which starts it
setTimeout(() => {
  const seen = {
    cells: tableCells(),
    plots: plots(),
    panels: within('maps', 'svg'),
    objects: within('maps', 'path.object'),
    errors: within('maps', 'path.error'),
    canvases: all('canvas').map(coloursOf),
    scene: document.querySelector('[data-plot="scenes"]').textContent,
    sorted: sortedByPressing(document.querySelector('figure.table table'), 4),
    moved: movedByWheel(),
    other: otherScene(),
    enlarged: enlargedPicture(),
    backgrounds: backgrounds(),
    overflow: document.documentElement.scrollWidth - document.documentElement.clientWidth,
  };
  const json = JSON.stringify(seen).replace(/[<>&]/g, (c) => `\\u00${c.charCodeAt(0).toString(16)}`);
  console.log('the probe has seen the page');
  document.body.append(Object.assign(document.createElement('pre'), {id: 'probe', textContent: json}));
}, 1500);
