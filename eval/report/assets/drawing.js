// SPDX-License-Identifier: BSD-3-Clause
// What the maps and scenes share.

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
