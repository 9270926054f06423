// SPDX-License-Identifier: BSD-3-Clause
// What a map from above is made of; x and y are scales from metres to pixels. Looks are in report.css.

const centreOf = (object) => [0, 1].map((axis) => d3.mean(object.footprint, (corner) => corner[axis]));
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
const layersOf = (map) => [map.truth, ...map.estimates].filter(Boolean);

// The true centre that an estimated object's error is measured from: the nearest of its category that is not
// farther away than the error, which is measured in space.
function trueCentre(object, truth) {
  if (object.error_m === null || !truth) return undefined;
  const centre = centreOf(object);
  return truth.objects.filter((other) => other.category === object.category)
      .map(centreOf)
      .filter((other) => distance(other, centre) <= object.error_m + 0.002)
      .sort((a, b) => distance(a, centre) - distance(b, centre))[0];
}

// The same scale on both axes, with all that is shown at first in view: a later layer may be far off.
function mapScales(map, width, height) {
  const shown = [...(map.truth ? [map.truth] : []), ...map.estimates.slice(0, 2)];
  const points = shown.flatMap((l) => [...l.trajectory, ...l.objects.flatMap((o) => o.footprint)]);
  const [x0, x1] = d3.extent(points, (p) => p[0]), [y0, y1] = d3.extent(points, (p) => p[1]);
  const pixels = Math.min((width - 40) / Math.max(x1 - x0, 0.5), (height - 60) / Math.max(y1 - y0, 0.5));
  const x = (x0 + x1) / 2, y = (y0 + y1) / 2, w = width / 2 / pixels, h = height / 2 / pixels;
  return [d3.scaleLinear([x - w, x + w], [0, width]), d3.scaleLinear([y - h, y + h], [height, 0])];
}

function drawGrid(svg, x, y, width, height) {
  const [step] = [0.1, 1, 5, 10, 50].filter((s) => x(s) - x(0) >= 30).concat(100);
  const lines = (scale) => {
    const [low, high] = d3.extent(scale.domain());
    return d3.range(Math.ceil(low / step), high / step).map((i) => scale(i * step));
  };
  const paths = [...lines(x).map((at) => `M${at},0V${height}`), ...lines(y).map((at) => `M0,${at}H${width}`)];
  svg.append('path').attr('class', 'grid').attr('d', paths.join(''));
  const bar = svg.append('g').attr('class', 'scale').attr('transform', `translate(14,${height - 14})`);
  bar.append('path').attr('d', `M0,-5V0H${x(step) - x(0)}V-5`);
  bar.append('text').attr('class', 'halo').attr('y', -9).text(`${step} m`);
}

// The footprint and a triangle on the object's front.
function objectShape(object, x, y) {
  const [cx, cy] = centreOf(object), [fx, fy] = object.front;
  const reach = d3.max(object.footprint, (p) => (p[0] - cx) * fx + (p[1] - cy) * fy);
  const mark = [[1, 0.35], [1, -0.35], [1.4, 0]].map(
      ([ahead, aside]) => [cx + reach * (ahead * fx - aside * fy), cy + reach * (ahead * fy + aside * fx)]);
  const closed = (points) => `M${points.map((p) => [x(p[0]), y(p[1])]).join('L')}Z`;
  return closed(object.footprint) + closed(mark);
}

// A path with a dot where it starts.
function drawPath(svg, points, x, y, name) {
  const line = d3.line().x((p) => x(p[0])).y((p) => y(p[1]));
  svg.append('path').attr('class', `path ${name}`).attr('d', line(points));
  const starts = svg.selectAll(null).data(points.slice(0, 1)).join('circle').attr('class', `start ${name}`);
  starts.attr('r', 3.5).attr('cx', (p) => x(p[0])).attr('cy', (p) => y(p[1]));
}

function drawObjects(svg, objects, name, x, y) {
  return svg.append('g')
      .selectAll('path')
      .data(objects)
      .join('path')
      .attr('class', name)
      .attr('d', (object) => objectShape(object, x, y));
}

// From the true centres to the estimated ones.
function drawErrors(svg, layer, truth, x, y) {
  const pairs = layer.objects.map((o) => [trueCentre(o, truth), centreOf(o)]).filter(([other]) => other);
  svg.append('g')
      .selectAll('path')
      .data(pairs)
      .join('path')
      .attr('class', 'error')
      .attr('d', (pair) => `M${pair.map((p) => [x(p[0]), y(p[1])]).join('L')}`);
}

// Above or below the object, where its front is not.
function drawNames(svg, objects, x, y) {
  const level = ({footprint, front}) => {
    const [top, bottom] = d3.extent(footprint, (p) => y(p[1]));
    return front[1] > 0 ? bottom + 12 : top - 4;
  };
  svg.append('g')
      .selectAll('text')
      .data(objects)
      .join('text')
      .attr('class', 'name halo')
      .attr('x', (object) => x(centreOf(object)[0]))
      .attr('y', level)
      .text((object) => object.id);
}
