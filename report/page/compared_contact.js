// Rollers against gap springs, impacts resolved against captured: bars side by side, box by box.
'use strict';
(function () {
  const data = Report.data.comparison;
  if (!data || data.of === 'tensioner') return;
  const { base, zero_line } = Report.row_bars;
  const looks = [{ colour: Report.colours.pipe, rows: '#9fc3e6' }, { colour: Report.colours.second, rows: null }];

  const kinds = {
    share: { key: 'contact_share', title: 'Fraction of time in contact', axis: '% of time', rows: 'row_contact_share', top: 110, ticks: [0, 25, 50, 75, 100] },
    peak: { key: 'peak_reaction', title: 'Peak reaction', rows: 'row_peak_force', before: true },
    dent: { key: 'dent_depth', title: 'Dent depth of bare steel under the largest force', name: 'Dent depth' },
    load: { key: 'line_load', title: 'Line load on the coating under the largest force', name: 'Line load' },
  };

  for (const kind of Object.values(kinds)) {
    Object.assign(kind, data.shown[kind.key]);  // unit, factor, digits
    kind.axis = kind.axis || `${kind.name || kind.title} [${kind.unit}]`;
  }

  function bar(frame, x0, x1, value, colour) {
    return frame.plot.append('rect').attr('x', frame.x(x0)).attr('width', frame.x(x1) - frame.x(x0)).attr('y', frame.y(value))
      .attr('height', Math.max(frame.y(0) - frame.y(value), 0)).attr('fill', colour);
  }

  // Each row's own value, on the bar of its box; one alone says what the bar does.
  function rows_of(frame, values, kind, x0, x1, colour) {
    if (!values || values.length < 2 || !colour) return;
    const wide = (x1 - x0) / values.length;
    values.forEach((value, k) => frame.over.append('circle').attr('cx', frame.x(x0 + (k + 0.5) * wide)).attr('cy', frame.y(value * kind.factor)).attr('r', 3.4)
      .attr('fill', colour).attr('stroke', '#12395f').attr('stroke-width', 0.9));
  }

  Report.compared_contact = function (panel, part) {
    const kind = kinds[part];
    const hi = d3.max(data.boxes, (box) => d3.max(box.runs, (run) => run[kind.key])) * kind.factor || 1;
    const { frame } = base(panel, { height: 300, y: [0, kind.top || 1.14 * hi], y_ticks: kind.ticks, title: kind.title, y_label: kind.axis, words: 'Support boxes, from the tensioner astern' });
    data.boxes.forEach((box, b) => {
      const [first, last] = Report.data.supports[b].slot;
      const wide = (last - first - 0.2) / box.runs.length;
      box.runs.forEach((run, k) => {
        const x0 = first + 0.1 + k * wide;
        const x1 = x0 + 0.94 * wide;
        const value = run[kind.key] * kind.factor;
        bar(frame, x0, x1, value, looks[k].colour).append('title').text(`${box.name}, ${data.runs[k].name}: ${Report.fixed(value, kind.digits)} ${kind.unit}`);
        if (value <= 0) frame.over.append('text').attr('text-anchor', 'middle').attr('x', frame.x(0.5 * (x0 + x1))).attr('y', frame.y(0) - 4).style('fill', looks[k].colour).text('\u00d7');
        if (kind.before) frame.plot.append('line').attr('x1', frame.x(x0)).attr('x2', frame.x(x1)).attr('y1', frame.y(run.static_reaction * kind.factor)).attr('y2', frame.y(run.static_reaction * kind.factor)).attr('stroke', '#fff').attr('stroke-width', 2);
        if (kind.rows) rows_of(frame, run[kind.rows], kind, x0, x1, looks[k].rows);
      });
    });
    zero_line(frame);
    const entries = data.runs.map((run, k) => ({ text: run.words, colour: looks[k].colour, block: true }));
    if (kind.rows && data.boxes.some((box) => box.runs[0][kind.rows].length > 1)) entries.push({ text: 'bottom roller of each row', colour: looks[0].rows, dot: true });
    Report.legend(frame, entries);
  };
})();
