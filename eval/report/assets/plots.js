// SPDX-License-Identifier: BSD-3-Clause
// What the plots share.

// The colour of the i-th of several things, as a CSS value.
const colour = (i) => `var(--c${i % 8})`;

// A category has one colour in all figures: in the alphabet's order over all maps and scenes.
const categories = [
  ...new Set([
    ...report.data.maps.flatMap(
        (map) => [map.truth, ...map.estimates].flatMap((layer) => layer ? layer.objects : [])),
    ...report.data.scenes.flatMap((scene) => scene.objects),
  ].map((object) => object.category))
].sort();
const categoryColour = (category) => colour([1, 2, 3, 5, 6, 4][categories.indexOf(category) % 6]);

// Calls draw(width) now and whenever the node's width has changed.
function drawAtWidth(node, draw) {
  let drawn = 0;
  const update = () => {
    const width = Math.round(node.clientWidth);
    if (width === 0 || width === drawn) return;
    drawn = width;
    draw(width);
  };
  new ResizeObserver(update).observe(node);
  update();
}

// An empty drawing of that size in place of what the node held.
function freshSvg(node, width, height, label) {
  d3.select(node).select('svg').remove();
  return d3.select(node)
      .append('svg')
      .attr('viewBox', [0, 0, width, height])
      .attr('role', 'img')
      .attr('aria-label', label);
}

// Milliseconds with three digits that say something.
const milliseconds = (value) => value === 0 ? '0' : Number(value.toPrecision(3)).toString();

// The room that the longest text takes, at about 6.5 a letter, but not more than a third of the width.
const labelWidth = (texts, width) => Math.min(width / 3, 12 + 6.5 * d3.max(texts, (text) => text.length));

// A text that is cut where the room ends; the whole one is its title.
function cutText(selection, text, room) {
  selection
      .text((item) => {
        const whole = text(item), letters = Math.floor(room / 6.5);
        return whole.length <= letters ? whole : `${whole.slice(0, Math.max(letters - 1, 1))}…`;
      })
      .append('title')
      .text(text);
}
