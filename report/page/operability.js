// Charts of operability: limit over an axis, rose by direction, workability by month.
'use strict';
(function () {
  const all = Report.data.study && Report.data.study.operability;
  if (!all) return;
  // Distinct for people who see no red or no green (Okabe and Ito 2008), with dashes to tell them apart in print.
  const kColours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#000000'];
  const kDashes = [null, '7 4', '2 3', '9 3 2 3'];
  const numbers = (axis) => axis.values.length === axis.words.length && axis.values.every((v) => v !== null);
  const is_heading = (axis) => axis.name.endsWith('[deg]') && axis.words.length > 2;
  const heading = all.axes.findIndex(is_heading);
  const shown = (cell) => (cell.beyond ? all.largest : cell.limit);
  const told = (cell, words) => `${words}\n${cell.beyond ? `over ${all.largest}` : cell.limit === null ? `below ${all.least}` : cell.limit}${cell.governing ? `\nabove it: ${cell.governing}` : ''}`;

  // The axis of the chart: the one with most values that is no direction; else the first.
  function across() {
    const fit = all.axes.map((axis, i) => i).filter((i) => i !== heading && numbers(all.axes[i]));
    fit.sort((a, b) => all.axes[b].words.length - all.axes[a].words.length);
    return fit.length > 0 ? fit[0] : 0;
  }

  function words_of(cell, skip) {
    return all.axes.map((axis, i) => (i === skip ? '' : `${axis.name.replace(/ \[.*/, '')} ${axis.words[cell.at[i]]}`)).filter((text) => text).join(', ');
  }

  const style = (k) => ({ colour: kColours[k % kColours.length], dash: kDashes[Math.floor(k / kColours.length) % kDashes.length] });

  // Names with their lines below the chart, as many in a row as there is room.
  function key(svg, width, top, names) {
    let [x, y] = [70, top];
    names.forEach((name, k) => {
      const wide = Report.measured(name, 14) + 50;
      if (x + wide > width - 16) { x = 70; y += 22; }
      svg.append('line').attr('x1', x).attr('x2', x + 26).attr('y1', y - 5).attr('y2', y - 5).attr('stroke', style(k).colour).attr('stroke-dasharray', style(k).dash).attr('stroke-width', 2.2);
      svg.append('text').attr('x', x + 32).attr('y', y).text(name);
      x += wide;
    });
    return y + 12;
  }

  Report.operability_chart = function (panel) {
    const axis = across();
    const at = numbers(all.axes[axis]) ? all.axes[axis].values : d3.range(all.axes[axis].words.length);
    const lines = d3.groups(all.cells, (cell) => words_of(cell, axis));
    const x = d3.extent(at);
    if (x[0] === x[1]) { x[0] -= 0.5; x[1] += 0.5; }
    const frame = Report.frame(panel, { height: 380, x, y: [0, 1.06 * all.largest], x_label: all.axes[axis].name, y_label: all.over, right: 30 });
    frame.plot.append('line').attr('x1', frame.x(x[0])).attr('x2', frame.x(x[1])).attr('y1', frame.y(all.largest)).attr('y2', frame.y(all.largest)).attr('stroke', Report.colours.steel).attr('stroke-dasharray', '3 3');
    lines.forEach(([words, cells], k) => {
      const seen = cells.filter((cell) => cell.decided && shown(cell) !== null).sort((a, b) => at[a.at[axis]] - at[b.at[axis]]);
      frame.plot.append('path').attr('d', d3.line((c) => frame.x(at[c.at[axis]]), (c) => frame.y(shown(c)))(seen)).attr('fill', 'none').attr('stroke', style(k).colour).attr('stroke-dasharray', style(k).dash).attr('stroke-width', 2);
      for (const cell of cells) {
        const px = frame.x(at[cell.at[axis]]);
        if (!cell.decided || shown(cell) === null) {  // not even the least value passes
          frame.over.append('text').attr('x', px).attr('y', frame.y(0) - 6).attr('text-anchor', 'middle').style('fill', style(k).colour).text('\u00d7').append('title').text(told(cell, words_of(cell, -1)));
        } else {
          frame.over.append(cell.beyond ? 'path' : 'circle').attr('fill', style(k).colour).call((mark) => {
            if (cell.beyond) mark.attr('d', 'M-5,2 L5,2 L0,-7 Z').attr('transform', `translate(${px},${frame.y(all.largest)})`);
            else mark.attr('cx', px).attr('cy', frame.y(cell.limit)).attr('r', 3.6);
          }).append('title').text(told(cell, words_of(cell, -1)));
        }
      }
    });
    const bottom = key(frame.svg, frame.width, frame.height + 14, lines.map(([words]) => words || all.over));
    frame.svg.append('text').attr('class', 'soft').attr('x', 70).attr('y', bottom + 8).text('\u25b2 the largest value of all passes   \u00d7 not even the least passes, or not decided');
    frame.svg.attr('viewBox', `0 0 ${frame.width} ${bottom + 18}`);
  };

  // Directions clockwise from north on top; of the other axes every combination has a line.
  Report.operability_rose = function (panel) {
    const axis = all.axes[heading];
    const [size, radius] = [640, 220];
    const [cx, cy] = [size / 2, 260];
    const r = d3.scaleLinear([0, all.largest], [0, radius]);
    const svg = d3.select(panel).append('svg').attr('viewBox', `0 0 ${size} 600`).attr('role', 'img').attr('aria-label', 'rose').style('min-width', '0').style('max-width', '760px').style('margin', '0 auto');
    const point = (cell) => { const a = axis.values[cell.at[heading]] * Math.PI / 180; const d = r(shown(cell) ?? 0); return [cx + d * Math.sin(a), cy - d * Math.cos(a)]; };
    const circles = r.ticks(4).filter((v) => v > 0);
    for (const v of circles) {
      svg.append('circle').attr('cx', cx).attr('cy', cy).attr('r', r(v)).attr('fill', 'none').attr('stroke', '#d5dce3');
    }
    axis.values.forEach((degrees) => {
      const a = degrees * Math.PI / 180;
      svg.append('line').attr('x1', cx).attr('y1', cy).attr('x2', cx + radius * Math.sin(a)).attr('y2', cy - radius * Math.cos(a)).attr('stroke', '#e3e8ed');
      svg.append('text').attr('class', 'soft').attr('text-anchor', 'middle').attr('x', cx + (radius + 20) * Math.sin(a)).attr('y', cy - (radius + 20) * Math.cos(a) + 5).text(`${Report.fixed(degrees, 0)}\u00b0`);
    });
    const lines = d3.groups(all.cells, (cell) => words_of(cell, heading));
    lines.forEach(([, cells], k) => {
      const order = cells.filter((cell) => cell.decided).sort((a, b) => axis.values[a.at[heading]] - axis.values[b.at[heading]]);
      const gaps = order.map((c, i) => (axis.values[order[(i + 1) % order.length].at[heading]] - axis.values[c.at[heading]] + 360) % 360);
      const closed = Math.max(...gaps) < 120 && order.length > 2;
      svg.append('path').attr('d', d3.line().curve(closed ? d3.curveLinearClosed : d3.curveLinear)(order.map(point))).attr('fill', 'none').attr('stroke', style(k).colour).attr('stroke-dasharray', style(k).dash).attr('stroke-width', 2.2);
      for (const cell of order) svg.append('circle').attr('cx', point(cell)[0]).attr('cy', point(cell)[1]).attr('r', 3.4).attr('fill', style(k).colour).append('title').text(told(cell, words_of(cell, -1)));
    });
    // Levels are written between two directions, where no line of the rose runs.
    const turn = Math.PI / 180 * (axis.values.length > 1 ? 0.5 * (axis.values[0] + axis.values[1]) : 15);
    for (const v of circles) {
      svg.append('text').attr('class', 'halo').attr('x', cx + r(v) * Math.sin(turn)).attr('y', cy - r(v) * Math.cos(turn) + 4).attr('text-anchor', 'middle').style('font-size', '12px').text(v);
    }
    const bottom = key(svg, size, 556, lines.map(([words]) => words || all.over));
    svg.append('text').attr('class', 'soft').attr('x', 70).attr('y', 530).text(`${axis.name}; ${all.over}`);
    svg.attr('viewBox', `0 0 ${size} ${bottom + 6}`);
  };

  Report.workability = function (panel) {
    const names = ['Jan', 'Feb', 'Mar', 'Apr', 'May', 'Jun', 'Jul', 'Aug', 'Sep', 'Oct', 'Nov', 'Dec'];
    const frame = Report.frame(panel, { height: 300, x: [0, 12], y: [0, 100], x_tick_values: [], x_label: `year: ${Report.fixed(all.year, 1)} %`, y_label: 'workable [%]' });
    all.months.forEach((value, i) => {
      frame.plot.append('rect').attr('x', frame.x(i + 0.15)).attr('width', frame.x(0.7) - frame.x(0)).attr('y', frame.y(value)).attr('height', Math.max(frame.y(0) - frame.y(value), 0)).attr('fill', Report.colours.pipe);
      frame.over.append('text').attr('class', 'halo').attr('text-anchor', 'middle').attr('x', frame.x(i + 0.5)).attr('y', frame.y(Math.min(value, 94)) - 5).text(Report.fixed(value, 0));
      frame.svg.append('text').attr('class', 'soft').attr('text-anchor', 'middle').attr('x', frame.x(i + 0.5)).attr('y', frame.height - 32).text(names[i]);
    });
    frame.plot.append('line').attr('x1', frame.x(0)).attr('x2', frame.x(12)).attr('y1', frame.y(all.year)).attr('y2', frame.y(all.year)).attr('stroke', Report.colours.accent).attr('stroke-dasharray', '6 4').attr('stroke-width', 1.6);
  };
})();
