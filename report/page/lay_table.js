// Curves of a lay table, each over what is varied.
'use strict';
(function () {
  const table = Report.data.lay_table;
  if (!table) return;
  const colours = [Report.colours.pipe, Report.colours.second];

  function extent(panel) {
    const all = panel.series.flatMap((one) => one.points.map((p) => p[1]));
    if (panel.limit !== null) all.push(panel.limit);
    const [lo, hi] = d3.extent(all);
    const room = 0.08 * (hi - lo) || 0.08 * Math.abs(hi) || 1;
    return [lo >= 0 ? Math.max(0, lo - room) : lo - room, hi + room];
  }

  // Where every check is passed, as far as the figure goes.
  function shade(frame, [x0, x1]) {
    if (table.least === null && table.largest === null) return;
    const [from, to] = [table.least ?? x0, table.largest ?? x1].map((x) => frame.x(Math.min(Math.max(x, x0), x1)));
    frame.back.append('rect').attr('x', from).attr('width', Math.max(to - from, 0)).attr('y', frame.margin.top)
      .attr('height', frame.inner_height).attr('fill', '#e6f2ea');
  }

  Report.lay_table = function (panel) {
    const x = d3.extent(table.panels.flatMap((one) => one.series.flatMap((s) => s.points.map((p) => p[0]))));
    if (x[0] === x[1]) { x[0] -= 0.5; x[1] += 0.5; }
    for (const one of table.panels) {
      const frame = Report.frame(panel, { width: 480, height: 230, left: 68, x, y: extent(one), x_ticks: 6, x_label: table.axis, y_label: '', title: one.title });
      frame.svg.classed('small', true);
      shade(frame, x);
      if (one.limit !== null) {
        frame.plot.append('line').attr('x1', frame.x(x[0])).attr('x2', frame.x(x[1])).attr('y1', frame.y(one.limit)).attr('y2', frame.y(one.limit))
          .attr('stroke', Report.colours.accent).attr('stroke-dasharray', '6 4').attr('stroke-width', 1.4);
      }
      one.series.forEach((series, k) => {
        const path = d3.line((p) => frame.x(p[0]), (p) => frame.y(p[1]));
        frame.plot.append('path').attr('d', path(series.points)).attr('fill', 'none').attr('stroke', colours[k]).attr('stroke-width', 2);
        frame.plot.selectAll(null).data(series.points).join('circle').attr('cx', (p) => frame.x(p[0])).attr('cy', (p) => frame.y(p[1])).attr('r', 2.2).attr('fill', colours[k]);
      });
      if (one.series.length > 1) Report.legend(frame, one.series.map((series, k) => ({ text: series.name, colour: colours[k] })));
    }
  };
})();
