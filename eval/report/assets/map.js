// SPDX-License-Identifier: BSD-3-Clause
// Maps from above: two panels of one scale, each with an estimate over the truth.

function drawTruth(svg, layer, x, y) {
  const shapes = drawObjects(svg, layer.objects, 'true-object', x, y);
  withTip(shapes, (object) => `true ${object.category}: ${object.id}`);
  drawPath(svg, layer.trajectory, x, y, 'true');
}

function drawEstimate(svg, layer, truth, x, y) {
  const error = (object) => object.error_m === null ? 'no true object' : `${object.error_m.toFixed(3)} m off`;
  drawPath(svg, layer.trajectory, x, y, '');
  const shapes = drawObjects(svg, layer.objects, 'object', x, y)
                     .style('color', (object) => categoryColour(object.category))
                     .classed('unmatched', (object) => object.error_m === null && truth);
  withTip(shapes, (object) => `${object.id}\n${object.category}${truth ? `, ${error(object)}` : ''}`);
  drawErrors(svg, layer, truth, x, y);
  drawNames(svg, layer.objects, x, y);
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
  const layer = map.estimates[panel.layer];
  const svg = freshSvg(panel.node, width, height, `${map.sequence} from above: ${layer.name}`);
  const [x, y] = mapScales(map, width, height);
  const scales = [transform.rescaleX(x), transform.rescaleY(y)];
  drawGrid(svg, ...scales, width, height);
  if (map.truth) drawTruth(svg, map.truth, ...scales);
  drawEstimate(svg, layer, map.truth, ...scales);
}

function mapLegend(map) {
  const seen = new Set(layersOf(map).flatMap((layer) => layer.objects.map((object) => object.category)));
  const outlines = [...seen].sort().map((name) => [name, categoryColour(name), 'outline']);
  const truth = [
    ['true path', 'var(--truth)', 'line dashed'],
    ['true object', 'var(--truth)'],
    ['from the true centre to the estimated', 'var(--error)', 'line'],
  ];
  return legend([['estimated path', 'var(--path)', 'line'], ...outlines, ...(map.truth ? truth : [])]);
}

// The panels move together, by wheel and by dragging. Returns the button that shows the whole map again.
function linkZoom(panels, draw) {
  // Fingers scroll the page, which a map would fill on a small screen.
  const inDrawing = () => !d3.event.button && d3.event.target.closest('svg');
  const zoom = d3.zoom().scaleExtent([0.5, 20]).touchable(false).filter(inDrawing).on('zoom', () => {
    d3.selectAll(panels.map((panel) => panel.node)).property('__zoom', d3.event.transform);
    draw(d3.event.transform);
  });
  panels.forEach((panel) => d3.select(panel.node).call(zoom));
  const reset = element('button', {type: 'button', textContent: 'whole map'});
  reset.addEventListener('click', () => d3.select(panels[0].node).call(zoom.transform, d3.zoomIdentity));
  return reset;
}

report.draw.maps = (figure, map) => {
  if (map.estimates.length === 0) return;
  let transform = d3.zoomIdentity, width = 0;
  const draw = () => panels.forEach((panel) => drawPanel(panel, map, width, transform));
  const panels = map.estimates.slice(0, 2).map((_, layer) => mapPanel(map, layer, draw));
  const reset = linkZoom(panels, (moved) => {
    transform = moved;
    draw();
  });
  figure.append(
      mapLegend(map), element('div', {className: 'panels map'}, ...panels.map((panel) => panel.node)),
      element('div', {className: 'controls'}, reset, 'Wheel and drag to look closer; point at an object.'));
  drawAtWidth(panels[0].node, (newWidth) => {
    width = newWidth;
    draw();
  });
};
