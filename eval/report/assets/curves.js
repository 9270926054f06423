// SPDX-License-Identifier: BSD-3-Clause
// Time against something that grows: medians as lines, bands between the 10th and 90th percentile.

const dashes = ['', '7 4', '2 3', '10 3 2 3'];
const margin = {
  top: 12,
  right: 20,
  bottom: 42,
  left: 58
};

function timeScale(points, height, logarithmic) {
  const most = d3.max(points, (p) => Math.max(p.median, p.p90));
  const least = d3.min(points, (p) => Math.min(p.median, p.p10));
  const range = [height - margin.bottom, margin.top];
  // Times of nothing have no logarithm; they lie on the lower edge.
  if (logarithmic) return d3.scaleLog([Math.max(least, most * 1e-5), most], range).nice().clamp(true);
  return d3.scaleLinear([0, most], range).nice();
}

// Whole powers of ten alone, where there are enough: all others would be a dense grid.
function timeTicks(y, logarithmic) {
  const powers = logarithmic ? y.ticks().filter((value) => Number.isInteger(Math.log10(value))) : [];
  return d3.axisLeft(y).ticks(6, '~g').tickValues(powers.length > 2 ? powers : null);
}

// Sizes that grow by factors.
function growthScale(points, width) {
  const [least, most] = d3.extent(points, (p) => p.x), range = [margin.left, width - margin.right];
  const scale = least > 0 && most > 100 * least ? d3.scaleLog() : d3.scaleLinear();
  return scale.domain([least, most]).range(range).nice();
}

function drawAxes(svg, item, x, yAxis, width, height) {
  svg.append('g')
      .attr('transform', `translate(0,${height - margin.bottom})`)
      .call(d3.axisBottom(x).ticks(Math.max(width / 90, 3), '~s'));
  svg.append('g')
      .attr('transform', `translate(${margin.left},0)`)
      .call(yAxis.tickSize(margin.left + margin.right - width))
      .call((axis) => axis.select('.domain').remove());
  svg.append('text')
      .attr('class', 'quiet')
      .attr('x', (width + margin.left) / 2)
      .attr('y', height - 6)
      .attr('text-anchor', 'middle')
      .text(item.x_label);
  svg.append('text')
      .attr('class', 'quiet')
      .attr('transform', `translate(13,${height / 2}) rotate(-90)`)
      .attr('text-anchor', 'middle')
      .text(item.y_label);
}

function drawCurve(svg, curve, index, x, y) {
  const band = d3.area().x((p) => x(p.x)).y0((p) => y(p.p10)).y1((p) => y(p.p90));
  const line = d3.line().x((p) => x(p.x)).y((p) => y(p.median));
  svg.append('path').attr('class', 'band').attr('d', band(curve.points)).style('fill', colour(index));
  svg.append('path')
      .attr('class', 'curve')
      .attr('d', line(curve.points))
      .style('stroke', colour(index))
      .attr('stroke-dasharray', dashes[index % 4]);
  const dots = svg.append('g')
                   .selectAll('circle')
                   .data(curve.points)
                   .join('circle')
                   .attr('r', 4)
                   .attr('cx', (p) => x(p.x))
                   .attr('cy', (p) => y(p.median))
                   .style('fill', colour(index));
  withTip(
      dots,
      (p) => `${curve.name} at ${p.x}\nmedian ${milliseconds(p.median)} ms\n` +
          `p10 ${milliseconds(p.p10)}, p90 ${milliseconds(p.p90)} ms`);
}

report.draw.curves = (figure, item) => {
  const panel = element('div', {className: 'panel curves'});
  const points = item.curves.flatMap((curve) => curve.points);
  if (points.length === 0) return;
  let logarithmic = d3.max(points, (p) => p.median) > 30 * d3.min(points, (p) => p.median);
  const draw = (width) => {
    const height = Math.min(380, Math.max(240, width * 0.5));
    const svg = freshSvg(panel, width, height, `${item.y_label} against ${item.x_label}`);
    const x = growthScale(points, width);
    const y = timeScale(points, height, logarithmic);
    drawAxes(svg, item, x, timeTicks(y, logarithmic), width, height);
    item.curves.forEach((curve, i) => drawCurve(svg, curve, i, x, y));
  };
  const redraw = (checked) => {
    logarithmic = checked;
    draw(panel.clientWidth);
  };
  const names = item.curves.map((curve, i) => [curve.name, colour(i), i % 4 ? 'line dashed' : 'line']);
  if (names.length > 1) figure.append(legend(names));
  figure.append(
      element('div', {className: 'controls'}, checkbox('logarithmic times', logarithmic, redraw)), panel);
  drawAtWidth(panel, draw);
};
