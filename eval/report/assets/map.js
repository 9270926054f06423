// SPDX-License-Identifier: BSD-3-Clause
// Maps from above: two panels of one scale, each with an estimate over the truth.

const centreOf = (object) => [d3.mean(object.footprint, (p) => p[0]), d3.mean(object.footprint, (p) => p[1])];
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

// The true centre that an estimated object's error is measured from: the nearest of its category that is not
// farther away than the error, which is measured in space.
function trueCentre(object, truth) {
  if (object.error_m === null || !truth) return null;
  const centre = centreOf(object);
  const near = truth.objects.filter((other) => other.category === object.category).map(centreOf)
      .filter((other) => distance(other, centre) <= object.error_m + 0.002);
  return d3.min(near, (other) => distance(other, centre)) === undefined ? null :
      near.reduce((a, b) => distance(a, centre) <= distance(b, centre) ? a : b);
}

// Scales from metres to the panel, the same on both axes, with everything in view.
function mapScales(map, width, height) {
  const layers = [map.truth, ...map.estimates].filter(Boolean);
  const points = layers.flatMap((l) => [...l.trajectory, ...l.objects.flatMap((o) => o.footprint)]);
  const [x0, x1] = d3.extent(points, (p) => p[0]), [y0, y1] = d3.extent(points, (p) => p[1]);
  const pixels = Math.min((width - 40) / Math.max(x1 - x0, 0.5), (height - 60) / Math.max(y1 - y0, 0.5));
  const x = (x0 + x1) / 2, y = (y0 + y1) / 2, w = width / 2 / pixels, h = height / 2 / pixels;
  return [d3.scaleLinear([x - w, x + w], [0, width]), d3.scaleLinear([y - h, y + h], [height, 0])];
}

function drawGrid(svg, x, y, width, height) {
  const [step] = [0.1, 1, 5, 10, 50].filter((s) => x(s) - x(0) >= 30).concat(100);
  const lines = (scale) => d3.range(Math.ceil(d3.min(scale.domain()) / step), d3.max(scale.domain()) / step);
  const grid = svg.append('g').style('stroke', 'var(--faint)');
  grid.selectAll('.v').data(lines(x)).join('path').attr('d', (i) => `M${x(i * step)},0V${height}`);
  grid.selectAll('.h').data(lines(y)).join('path').attr('d', (i) => `M0,${y(i * step)}H${width}`);
  const bar = svg.append('g').attr('class', 'scale').attr('transform', `translate(14,${height - 14})`);
  bar.append('path').attr('d', `M0,-5V0H${x(step) - x(0)}V-5`).style('fill', 'none').style('stroke', 'var(--ink)')
      .style('stroke-width', 1.5);
  bar.append('text').attr('class', 'halo').attr('y', -9).text(`${step} m`);
}

const outline = (object, x, y) => `M${object.footprint.map((p) => [x(p[0]), y(p[1])]).join('L')}Z`;

// A triangle on the object's front.
function frontMark(object, x, y) {
  const [cx, cy] = centreOf(object), [fx, fy] = object.front;
  const reach = d3.max(object.footprint, (p) => (p[0] - cx) * fx + (p[1] - cy) * fy);
  const corners = [[reach, 0.35], [reach, -0.35], [reach * 1.4, 0]];
  return `M${corners.map(([a, b]) => [x(cx + a * fx - b * reach * fy), y(cy + a * fy + b * reach * fx)]).join('L')}Z`;
}

// With a dot where it starts.
function drawPath(svg, points, x, y, name, stroke) {
  const [start] = points;
  if (start) svg.append('circle').attr('r', 3.5).attr('cx', x(start[0])).attr('cy', y(start[1])).style('fill', stroke);
  return svg.append('path').attr('class', name).attr('d', d3.line().x((p) => x(p[0])).y((p) => y(p[1]))(points))
      .style('fill', 'none').style('stroke', stroke).style('stroke-width', 2);
}

function drawTruth(svg, layer, x, y) {
  const objects = svg.append('g').attr('class', 'truth').style('fill', 'var(--truth)');
  const shapes = objects.selectAll('path').data(layer.objects).join('path').style('fill-opacity', 0.28)
      .attr('d', (object) => outline(object, x, y) + frontMark(object, x, y));
  withTip(shapes, (object) => `true ${object.category}: ${object.id}`);
  drawPath(svg, layer.trajectory, x, y, 'true path', 'var(--truth)').attr('stroke-dasharray', '5 4');
}

const errorText = (object) => object.error_m === null ? 'no true object' : `${object.error_m.toFixed(3)} m off`;

function drawEstimate(svg, layer, truth, x, y) {
  drawPath(svg, layer.trajectory, x, y, 'path', 'var(--path)');
  const objects = svg.append('g').attr('class', 'objects');
  const shapes = objects.selectAll('path').data(layer.objects).join('path').attr('class', 'object')
      .attr('d', (object) => outline(object, x, y) + frontMark(object, x, y))
      .style('stroke', (object) => categoryColour(object.category)).style('stroke-width', 2)
      .style('stroke-dasharray', (object) => object.error_m === null && truth ? '4 3' : null)
      .style('fill', (object) => categoryColour(object.category)).style('fill-opacity', 0.12);
  withTip(shapes, (object) => `${object.id}\n${object.category}${truth ? `, ${errorText(object)}` : ''}`);
  const pairs = layer.objects.map((o) => [centreOf(o), trueCentre(o, truth)]).filter(([, other]) => other);
  svg.append('g').selectAll('path').data(pairs).join('path').attr('class', 'error')
      .attr('d', ([a, b]) => `M${x(b[0])},${y(b[1])}L${x(a[0])},${y(a[1])}`)
      .style('stroke', 'var(--error)').style('stroke-width', 3).style('stroke-linecap', 'round');
  drawNames(svg, layer.objects, x, y);
}

// Above or below the object, where its front is not.
function drawNames(svg, objects, x, y) {
  const level = ({footprint, front}) => {
    const [top, bottom] = d3.extent(footprint, (p) => y(p[1]));
    return front[1] > 0 ? bottom + 12 : top - 4;
  };
  svg.append('g').selectAll('text').data(objects).join('text').attr('class', 'halo').attr('text-anchor', 'middle')
      .attr('font-size', 11).style('pointer-events', 'none').attr('x', (object) => x(centreOf(object)[0]))
      .attr('y', level).text((object) => object.id);
}

// One panel; `layer` is what of the map's estimates it shows at first.
function mapPanel(map, layer, draw) {
  const controls = element('div', {className: 'controls'});
  const panel = {node: element('div', {className: 'panel'}, controls), layer};
  controls.append(choice('', map.estimates.map((estimate) => estimate.name), layer, (chosen) => {
    panel.layer = chosen;
    draw();
  }));
  return panel;
}

function drawPanel(panel, map, width, transform) {
  const height = Math.min(Math.max(width * 0.8, 280), 560);
  const [x, y] = mapScales(map, width, height);
  const svg = freshSvg(panel.node, width, height, `${map.sequence} from above: ${map.estimates[panel.layer].name}`);
  const scales = [transform.rescaleX(x), transform.rescaleY(y)];
  drawGrid(svg, ...scales, width, height);
  if (map.truth) drawTruth(svg, map.truth, ...scales);
  drawEstimate(svg, map.estimates[panel.layer], map.truth, ...scales);
}

function mapLegend(map) {
  const seen = new Set([map.truth, ...map.estimates].filter(Boolean).flatMap((l) => l.objects.map((o) => o.category)));
  const truth = map.truth ? [['true path', 'var(--truth)', 'line dashed'], ['true object', 'var(--truth)'],
                             ['from the true centre to the estimated', 'var(--error)', 'line']] : [];
  return legend([['estimated path', 'var(--path)', 'line'],
                 ...[...seen].sort().map((name) => [name, categoryColour(name), 'outline']), ...truth]);
}

report.draw.maps = (figure, map) => {
  if (map.estimates.length === 0) return;
  let transform = d3.zoomIdentity, width = 0;
  const draw = () => panels.forEach((panel) => drawPanel(panel, map, width, transform));
  const panels = map.estimates.slice(0, 2).map((_, layer) => mapPanel(map, layer, draw));
  const area = element('div', {className: 'panels map'}, ...panels.map((panel) => panel.node));
  // Fingers scroll the page, which a map would fill on a small screen.
  const inDrawing = () => !d3.event.button && d3.event.target.closest('svg');
  const zoom = d3.zoom().scaleExtent([0.5, 20]).touchable(false).filter(inDrawing).on('zoom', () => {
    transform = d3.event.transform;
    d3.selectAll(panels.map((panel) => panel.node)).property('__zoom', transform);  // the panels move together
    draw();
  });
  const reset = element('button', {type: 'button', textContent: 'whole map'});
  reset.addEventListener('click', () => d3.select(panels[0].node).call(zoom.transform, d3.zoomIdentity));
  figure.append(mapLegend(map), area,
                element('div', {className: 'controls'}, reset, 'Wheel and drag to look closer; point at an object.'));
  drawAtWidth(panels[0].node, (newWidth) => {
    width = newWidth;
    draw();
  });
  panels.forEach((panel) => d3.select(panel.node).call(zoom));
};
