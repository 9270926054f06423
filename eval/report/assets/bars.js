// SPDX-License-Identifier: BSD-3-Clause
// Bars that lie: stacked times of the stages, and the errors with and without the normal term.

const barHeight = 24, barStep = 34;

// Where bars go, with the axis under them: rows of labels on the left, values from 0 to `most`.
function barFrame(svg, labels, most, width, unit) {
  const left = labelWidth(labels, width), height = labels.length * barStep + 44;
  svg.attr('viewBox', [0, 0, width, height]);
  const x = d3.scaleLinear([0, most], [left, width - 70]);
  const bottom = labels.length * barStep + 6;
  svg.append('g')
      .attr('transform', `translate(0,${bottom})`)
      .call(d3.axisBottom(x).ticks(Math.max(width / 110, 2)));
  svg.append('text').attr('class', 'quiet').attr('x', width - 48).attr('y', bottom + 17).text(unit);
  const label = svg.selectAll('text.name')
                    .data(labels)
                    .join('text')
                    .attr('class', 'name')
                    .attr('y', (_, i) => i * barStep + barHeight / 2 + 8)
                    .attr('x', left - 8)
                    .attr('text-anchor', 'end');
  cutText(label, (text) => text, left - 8);
  return x;
}

const total = (bar) => d3.sum(bar.milliseconds);

// The stacked parts of all bars: where each starts and ends.
function stackedParts(item) {
  return item.bars
      .flatMap((bar, row) => {
        let start = 0;
        return bar.milliseconds.map((value, stage) => {
          const part = {row, stage, engine: bar.engine, value, start, end: start + value};
          start = part.end;
          return part;
        });
      })
      .filter((part) => part.value > 0);
}

function drawStages(svg, item, most, width) {
  const x = barFrame(svg, item.bars.map((bar) => bar.engine), most, width, 'ms');
  const at = (value) => x(Math.min(value, most));
  const bars = svg.selectAll('rect.bar')
                   .data(stackedParts(item).filter((part) => part.start < most))
                   .join('rect')
                   .attr('class', 'bar')
                   .attr('x', (part) => at(part.start))
                   .attr('y', (part) => part.row * barStep + 4)
                   .attr('width', (part) => at(part.end) - at(part.start))
                   .attr('height', barHeight)
                   .style('fill', (part) => colour(part.stage));
  withTip(bars, (part) => `${part.engine}\n${item.stages[part.stage]}: ${milliseconds(part.value)} ms`);
  svg.selectAll('text.total')
      .data(item.bars)
      .join('text')
      .attr('class', 'total')
      .attr('x', (bar) => at(total(bar)) + 6)
      .attr('y', (_, i) => i * barStep + barHeight / 2 + 8)
      .text((bar) => `${total(bar) > most * 1.001 ? '» ' : ''}${milliseconds(total(bar))}`);
}

// The longest bar that can be read together with the shortest; less than all when another is far longer.
function zoomedMost(totals) {
  const shortest = d3.min(totals.filter((value) => value > 0));
  return d3.max(totals.filter((value) => value <= 10 * shortest));
}

report.draw.stages = (figure, item) => {
  if (item.bars.length === 0) return;
  const totals = item.bars.map(total), longest = d3.max(totals), zoomed = zoomedMost(totals);
  const used =
      item.stages.map((name, i) => [name, i]).filter(([, i]) => item.bars.some((b) => b.milliseconds[i] > 0));
  figure.append(legend(used.map(([name, i]) => [name, colour(i)])));
  const addScale = (most, text) => {
    const panel = element('div', {className: 'panel bars'}, element('figcaption', {textContent: text}));
    figure.append(panel);
    drawAtWidth(panel, (width) => drawStages(freshSvg(panel, width, 10, text), item, most, width));
  };
  const far = longest > 3 * zoomed;
  addScale(longest, far ? 'All on one scale:' : '');
  if (far) {
    const times = Number((longest / zoomed).toPrecision(2));
    addScale(zoomed, `The same, enlarged ${times} times; bars marked » go on to the right:`);
  }
};

report.draw.ablations = (figure, item) => {
  if (item.bars.length === 0) return;
  const panel = element('div', {className: 'panel bars'});
  figure.append(panel);
  drawAtWidth(panel, (width) => {
    const svg = freshSvg(panel, width, 10, item.caption);
    const x = barFrame(
        svg, item.bars.map((bar) => bar.run), d3.max(item.bars, (bar) => bar.value), width, item.unit);
    svg.selectAll('rect.bar')
        .data(item.bars)
        .join('rect')
        .attr('class', 'bar')
        .attr('x', x(0))
        .attr('y', (_, i) => i * barStep + 4)
        .attr('height', barHeight)
        .style('fill', (_, i) => colour(i))
        .attr('width', (bar) => x(bar.value) - x(0));
    svg.selectAll('text.total')
        .data(item.bars)
        .join('text')
        .attr('class', 'total')
        .attr('x', (bar) => x(bar.value) + 6)
        .attr('y', (_, i) => i * barStep + barHeight / 2 + 8)
        .text((bar) => milliseconds(bar.value));
  });
};
