// Lines by themselves: shape and tension along each.
'use strict';
(function () {
  const data = Report.data;
  if (!data.lines) return;
  const colours = Report.colours;

  function path(frame, points, colour, width, dash) {
    const pixels = points.map((p) => [frame.x(p[0]), frame.y(p[1])]);
    frame.plot.append('path').attr('d', d3.line()(pixels)).attr('fill', 'none').attr('stroke', colour).attr('stroke-width', width).attr('stroke-dasharray', dash || null);
    Report.keep_clear(frame, pixels);
  }

  // Horizontal distance along the plane through both ends, and height; a line whose ends stand above each other is seen from the south.
  function in_plane(line) {
    const [a, b] = [line.places[0], line.places[line.places.length - 1]];
    const far = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const way = far > 1e-6 ? [(b[0] - a[0]) / far, (b[1] - a[1]) / far] : [1, 0];
    return line.places.map((p) => [(p[0] - a[0]) * way[0] + (p[1] - a[1]) * way[1], p[2]]);
  }

  Report.line_shape = function (panel, part) {
    const line = data.lines[Number(part)];
    const points = in_plane(line);
    const [x, z] = [d3.extent(points, (p) => p[0]), d3.extent(points, (p) => p[1])];
    const bed = data.water_depth > 0 && z[0] < -0.6 * data.water_depth ? -data.water_depth : null;
    const low = bed === null ? z[0] : Math.min(z[0], bed);
    const high = z[1] > -0.4 * (z[1] - low) ? Math.max(z[1], 0) : z[1];
    const room = 0.08 * Math.max(x[1] - x[0], high - low, 1);
    const frame = Report.frame(panel, { equal: true, most: 400, x: [x[0] - room, x[1] + room], y: [low - room, high + room],
      x_label: 'Horizontal distance from the first end', x_si: 'm', y_label: 'Z, above the water', y_si: 'm', title: `${line.name}, true to scale` });
    const edge = [frame.margin.left, frame.width - frame.margin.right];
    const top = Math.max(frame.y(0), frame.margin.top);
    const bottom = frame.height - frame.margin.bottom;
    frame.back.append('rect').attr('x', edge[0]).attr('width', edge[1] - edge[0]).attr('y', top).attr('height', Math.max(bottom - top, 0)).attr('fill', '#f1f7fb');
    if (bed !== null) frame.back.append('rect').attr('x', edge[0]).attr('width', edge[1] - edge[0]).attr('y', frame.y(bed)).attr('height', bottom - frame.y(bed)).attr('fill', '#e4dac6');
    if (high >= 0) frame.plot.append('line').attr('x1', edge[0]).attr('x2', edge[1]).attr('y1', frame.y(0)).attr('y2', frame.y(0)).attr('stroke', '#6fa8cc');
    path(frame, points, colours.pipe, 2.4);
    Report.mark(frame, ...points[0], 'first end', colours.pipe);
    Report.mark(frame, ...points[points.length - 1], 'second end', colours.pipe);
  };

  Report.line_tension = function (panel, part) {
    const line = data.lines[Number(part)];
    const { tension, least, largest } = line;
    const [lo, hi] = d3.extent(data.moved ? [...tension, ...least, ...largest] : tension);
    const room = 0.12 * (hi - lo || 1e3);
    const frame = Report.frame(panel, { height: 280, x: [0, line.s[line.s.length - 1]], y: [lo - room, hi + room], x_label: 'Unstressed length from the first end', x_si: 'm', y_label: 'Effective tension', y_si: 'N', y_digits: 2,
      title: `${line.name}, effective tension` });
    if (data.moved) {
      const area = d3.area().x((i) => frame.x(line.s[i])).y0((i) => frame.y(least[i])).y1((i) => frame.y(largest[i]));
      frame.plot.append('path').attr('d', area(d3.range(line.s.length))).attr('fill', colours.band).attr('stroke', colours.history);
    }
    path(frame, line.s.map((s, i) => [s, tension[i]]), data.moved ? colours.accent : colours.pipe, 2, data.moved ? '7 4' : null);
    if (data.moved) Report.legend(frame, [{ text: 'range over time', colour: colours.band, edge: colours.history, block: true }, { text: 'at rest', colour: colours.accent, dash: '7 4' }]);
    const greatest = d3.greatestIndex(tension);
    Report.mark(frame, line.s[greatest], tension[greatest], `${Report.shown(tension[greatest], 'N', 2)}`, colours.pipe);
  };
})();
