// Curves of several results in one frame.
'use strict';
(function () {
  const overlay = Report.data.overlay;
  if (!overlay) return;
  // Distinct for people who see no red or no green (Okabe and Ito 2008); dashes tell them apart in print.
  const kColours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#000000'];
  const kDashes = [null, '7 4', '2 3', '9 3 2 3'];

  function extent(values) {
    const [lo, hi] = d3.extent(values);
    const room = 0.06 * (hi - lo) || 0.06 * Math.abs(hi) || 1;
    return [lo - (lo >= 0 && lo < room ? lo : room), hi + room];
  }

  Report.overlay = function (panel) {
    const names = overlay.names.map((name, k) => ({ text: name.length > 24 ? '\u2026' + name.slice(-23) : name, colour: kColours[k % kColours.length], dash: kDashes[k % kDashes.length] }));
    for (const one of overlay.figures) {
      const points = one.curves.flatMap((curve) => curve.points);
      if (points.length === 0) continue;
      const x = d3.extent(points, (p) => p[0]);
      if (x[0] === x[1]) x[1] += 1;
      // A row of the key for every two names, above the plot.
      const rows = Math.ceil(names.length / 2);
      const frame = Report.frame(panel, { width: 480, height: 250, left: 72, lane: 22 * rows, x, y: extent(points.map((p) => p[1])), x_ticks: 6, x_label: one.x_label, y_label: one.y_label, title: one.title });
      frame.svg.classed('small', true);
      for (const curve of one.curves) {
        const name = names[curve.folder];
        frame.plot.append('path').attr('d', d3.line((p) => frame.x(p[0]), (p) => frame.y(p[1]))(curve.points)).attr('fill', 'none').attr('stroke', name.colour).attr('stroke-dasharray', name.dash).attr('stroke-width', 1.8);
      }
      for (let row = 0; row < rows; ++row) Report.legend(frame, names.slice(2 * row, 2 * row + 2), 22 * (row + 1));
    }
  };
})();
