// Elevations and plan: the pipe in its plane, true to scale where rollers are to be seen.
'use strict';
(function () {
  const data = Report.data;
  const st = data.stations;
  const colours = Report.colours;

  // Corners of the hull's box in ship axes; signs: -1 or 1 along length (aft, fore), beam (starboard, port), height (keel, deck).
  Report.hull_corner = function (along, across, up, keel_z, deck_z) {
    const v = data.vessel;
    const local = [along * v.length / 2, across * v.beam / 2, up < 0 ? keel_z : deck_z];
    return [0, 1, 2].map((k) => v.origin[k] + local[0] * v.axes[0][k] + local[1] * v.axes[1][k] + local[2] * v.axes[2][k]);
  };

  // Places where the height of the seabed is known, between two; none of a plane but these two.
  Report.bed_places = function (x0, x1) {
    const inner = data.bed ? data.bed.heights.map((h) => h.x).filter((x) => x > x0 && x < x1) : [];
    return [x0, ...inner, x1];
  };

  // Height of the seabed below a place: of an uneven one between the heights known, else the plane through the bed under the stern shoe and under touchdown.
  Report.bed = function (x) {
    if (data.bed) {
      const heights = data.bed.heights;
      const i = Math.min(Math.max(d3.bisector((h) => h.x).left(heights, x), 1), heights.length - 1);
      const [a, b] = [heights[i - 1], heights[i]];
      return a.z + (b.z - a.z) * Math.min(Math.max((x - a.x) / (b.x - a.x || 1), 0), 1);
    }
    const touch = data.touchdown.p;
    const z0 = -data.water_depth;
    const z1 = touch[2] - data.pipe_outer_diameter / 2;
    return Math.abs(touch[0]) < 1 ? z0 : z0 + (z1 - z0) * x / touch[0];
  };

  // Frame of a box from its rollers: bed points below the rollers, for a schematic structure.
  Report.below_box = function (box, along, down) {
    const c = Math.cos(box.inclination);
    const s = Math.sin(box.inclination);
    return [box.p[0] + along * c - down * s, box.p[1], box.p[2] - along * s - down * c];
  };

  const polygon = (frame, points) => points.map((p) => `${frame.x(p[0]).toFixed(2)},${frame.y(p[1]).toFixed(2)}`).join(' ');

  function surroundings(frame) {
    const [x0, x1] = frame.x.domain();
    const [y0, y1] = frame.y.domain();
    const group = frame.plot.append('g');
    group.append('polygon').attr('points', polygon(frame, [[x0, 0], [x1, 0], [x1, y0], [x0, y0]])).attr('fill', '#eaf3f9').attr('opacity', 0.75);
    group.append('polygon').attr('points', polygon(frame, [...Report.bed_places(x0, x1).map((x) => [x, Report.bed(x)]), [x1, y0 - 1], [x0, y0 - 1]])).attr('fill', '#e4dac6');
    if (y1 > 0 && y0 < 0) {
      group.append('line').attr('x1', frame.x(x0)).attr('x2', frame.x(x1)).attr('y1', frame.y(0)).attr('y2', frame.y(0)).attr('stroke', '#6fa8cc').attr('stroke-width', 1.2);
    }
    const v = data.vessel;
    const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([along, up]) => Report.hull_corner(along, 0, up, -v.draught, v.depth - v.draught));
    group.append('polygon').attr('points', polygon(frame, corners.map((p) => [p[0], p[2]]))).attr('fill', '#c3ccd5').attr('fill-opacity', 0.55).attr('stroke', '#7b8794');
  }

  // Schematic structure: two chords below the boxes, posts at the boxes.
  function structure(frame) {
    for (const on of [false, true]) {
      const boxes = data.supports.filter((b) => b.stinger === on);
      if (boxes.length === 0) continue;
      const ends = (b, down) => [-0.5, 0.5].map((k) => Report.below_box(b, k * b.length, down)).map((p) => [p[0], p[2]]);
      const deep = on ? 1.9 : 0.9;
      const upper = boxes.flatMap((b) => ends(b, 0.55));
      const lower = boxes.flatMap((b) => ends(b, deep));
      for (const chord of [upper, lower]) {
        frame.plot.append('polyline').attr('points', polygon(frame, chord)).attr('fill', 'none').attr('stroke', '#9aa6b1').attr('stroke-width', 1.6);
      }
      upper.forEach((p, i) => {
        frame.plot.append('polyline').attr('points', polygon(frame, [p, lower[i], ...(i + 1 < upper.length ? [upper[i + 1]] : [])]))
          .attr('fill', 'none').attr('stroke', '#b4bec7').attr('stroke-width', 1);
      });
    }
  }

  function roller_shape(frame, roller, css) {
    const centre = [0, 1, 2].map((k) => roller.p[k] - roller.radius * roller.normal[k]);
    const fill = roller.reaction > 0 ? '#e08a3c' : '#c4ccd4';
    if (roller.position === 'bottom') {
      frame.plot.append('circle').attr('cx', frame.x(centre[0])).attr('cy', frame.y(centre[2])).attr('r', frame.x(roller.radius) - frame.x(0))
        .attr('fill', fill).attr('stroke', '#3d4a56').attr('stroke-width', 0.8);
      return;
    }
    const a = [roller.axis[0], roller.axis[2]];
    const length = Math.hypot(...a) || 1;
    const side = [-a[1] / length * roller.radius, a[0] / length * roller.radius];
    const corner = (k, m) => [centre[0] + k * a[0] * roller.face / 2 + m * side[0], centre[2] + k * a[1] * roller.face / 2 + m * side[1]];
    frame.plot.append('polygon').attr('points', polygon(frame, [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)]))
      .attr('fill', roller.reaction > 0 ? '#e08a3c' : css === 'front' ? 'none' : '#e2e7ec').attr('fill-opacity', css === 'front' ? 0.5 : 1)
      .attr('stroke', '#6b7986').attr('stroke-width', 0.7).attr('stroke-dasharray', css === 'front' ? '3 2' : null);
  }

  function rollers(frame, position, css) {
    for (const box of data.supports) for (const row of box.rows) for (const r of row.rollers) if (r.position === position) roller_shape(frame, r, css);
  }

  function path(frame, indices, dim) {
    return d3.line().x((i) => frame.x(st.x[i])).y((i) => frame.y(st[dim][i]))(indices);
  }

  // The pipe with its true diameters.
  function true_pipe(frame, indices) {
    const px = frame.x(1) - frame.x(0);
    const line = path(frame, indices, 'z');
    const stroke = (colour, width, opacity) => frame.plot.append('path').attr('d', line).attr('fill', 'none').attr('stroke', colour)
      .attr('stroke-width', width).attr('stroke-opacity', opacity).attr('stroke-linejoin', 'round');
    stroke('#3d4a56', data.pipe_outer_diameter * px + 1.2, 1);
    stroke('#dfe5ea', Math.max(data.pipe_outer_diameter * px - 0.6, 0.8), 1);
    stroke(colours.pipe, data.steel_outer_diameter * px, 0.5);
    if (data.pipe_outer_diameter * px > 14) {
      frame.plot.append('path').attr('d', line).attr('fill', 'none').attr('stroke', '#fff').attr('stroke-width', 1).attr('stroke-dasharray', '14 4 3 4');
    }
  }

  function box_names(frame) {
    const [x0, x1] = frame.x.domain();
    const px = frame.x(1) - frame.x(0);
    const names = [];
    for (const box of data.supports) {
      if (box.p[0] < x0 || box.p[0] > x1) continue;
      const name = { x: frame.x(box.p[0]) + 5, y: frame.y(pipe_above(box)) - 0.5 * data.pipe_outer_diameter * px - 10, text: box.name };
      const end = Report.measured(box.name, 13);
      const right = name.x + 0.57 * end;
      if (name.y - 0.82 * end > frame.margin.top + 2 && right < frame.width - 2) names.push(name);
    }
    Report.aslant_names(frame.over, names, -55, { size: 13, css: 'halo' });
  }

  // Height of the pipe's axis over the middle of a box: it need not rest there.
  function pipe_above(box) {
    const i = d3.range(1, st.count).find((k) => (st.x[k - 1] - box.p[0]) * (st.x[k] - box.p[0]) <= 0);
    if (i === undefined) return box.p[2];
    const t = (box.p[0] - st.x[i - 1]) / (st.x[i] - st.x[i - 1] || 1);
    return Math.max(box.p[2], st.z[i - 1] + t * (st.z[i] - st.z[i - 1]));
  }

  function water_name(frame) {
    const [y0, y1] = frame.y.domain();
    if (y0 > 0 || y1 < 0 || frame.y(0) < frame.margin.top + 16) return;
    frame.over.append('text').attr('class', 'soft').attr('text-anchor', 'end').attr('x', frame.width - frame.margin.right - 6).attr('y', frame.y(0) - 5)
      .style('font-size', '13px').text('mean water level');
  }

  // Reaction or separation beneath each bottom roller of the last box.
  function separations(frame) {
    for (const row of data.tip.rows) {
      const r = row.rollers.find((one) => one.position === 'bottom');
      if (!r) continue;
      const down = 2 * r.radius * (frame.x(1) - frame.x(0)) + 18;
      const text = r.reaction > 0 ? Report.shown(r.reaction, 'N', 1) : Report.shown(r.separation, 'section', 1);
      frame.over.append('text').attr('class', 'halo').attr('text-anchor', 'middle').attr('x', frame.x(r.p[0])).attr('y', frame.y(r.p[2]) + down)
        .style('font-size', '13px').style('fill', r.reaction > 0 ? '#a85200' : null).text(text);
    }
  }

  const labels = { x_label: 'X, astern of the stern shoe', x_si: 'm', y_label: 'Z, above the water', y_si: 'm' };

  function range_of(boxes, before, after) {
    const x = [d3.min(boxes, (b) => b.p[0] - b.length / 2) - before, d3.max(boxes, (b) => b.p[0] + b.length / 2) + after];
    const inside = d3.range(st.count).filter((i) => st.x[i] >= x[0] && st.x[i] <= x[1] && st.s[i] <= data.whole_end);
    return { x, z: [d3.min(inside, (i) => st.z[i]), d3.max(inside, (i) => st.z[i])] };
  }

  function true_scale(panel, title, range, below, above, detail) {
    const frame = Report.frame(panel, { ...labels, equal: true, most: detail ? 330 : 420, x: range.x, y: [range.z[0] - below, range.z[1] + above], title });
    surroundings(frame);
    structure(frame);
    rollers(frame, 'starboard', 'behind');
    rollers(frame, 'bottom', '');
    true_pipe(frame, Report.indices(data.whole_end));
    rollers(frame, 'port', 'front');
    box_names(frame);
    water_name(frame);
    if (detail) separations(frame);
    return frame;
  }

  Report.stinger_view = function (panel, part) {
    const stinger = data.supports.filter((b) => b.stinger);
    const boxes = part === 'overbend' || stinger.length === 0 ? data.supports : stinger;
    if (part === 'stinger' && stinger.length === 0) return;
    if (part === 'tip') {
      true_scale(panel, `Last box, ${data.tip.name}: at bottom rollers the reaction [${Report.unit('N').name}] or, without contact, the separation [${Report.unit('section').name}]`, range_of([data.tip], 1.5, 3), 2.2, 1.6, true);
    } else {
      const whole = part === 'overbend';
      const frame = true_scale(panel, whole ? 'Ramp and stinger' : 'Stinger', range_of(boxes, whole ? 3 : 2, 4), 3, whole ? 8 : 6, false);
      Report.legend(frame, [{ text: 'roller in contact', colour: '#e08a3c', block: true }, { text: 'without contact', colour: '#c4ccd4', block: true }]);
    }
  };

  Report.elevation = function (panel, part) {
    const overbend = part === 'overbend';
    const indices = Report.indices(overbend ? data.overbend_end : data.whole_end);
    const v = data.vessel;
    const bow = overbend ? st.x[0] - 4 : Math.min(st.x[0], Report.hull_corner(1, 0, 1, 0, 0)[0]) - 5;
    const last = st.x[indices[indices.length - 1]];
    const lowest = d3.min(indices, (i) => st.z[i]);
    const highest = Math.max(d3.max(indices, (i) => st.z[i]), overbend ? -1e9 : v.depth - v.draught);
    const room = 0.07 * (highest - lowest);
    const head = Math.max(1.6 * room, overbend ? 0 : 0.036 * (last - bow));  // for the word above the tensioner
    const frame = Report.frame(panel, { ...labels, equal: !overbend, height: 330, x: [bow, last + 0.02 * (last - bow)],
      y: [(overbend ? lowest : Math.min(lowest, d3.min(Report.bed_places(bow, last), Report.bed))) - room, highest + head],
      title: overbend ? 'Elevation, overbend (heights enlarged)' : 'Elevation, whole line (true to scale)' });
    surroundings(frame);
    if (overbend) {
      for (const box of data.supports) for (const row of box.rows) {
        frame.plot.append('circle').attr('cx', frame.x(row.p[0])).attr('cy', frame.y(row.p[2])).attr('r', 3)
          .attr('fill', row.reaction > 0 ? '#e08a3c' : '#fff').attr('stroke', '#3d4a56');
      }
    } else {
      frame.plot.append('polyline').attr('points', polygon(frame, data.supports.map((b) => [b.p[0], b.p[2]]))).attr('fill', 'none').attr('stroke', '#7b8794').attr('stroke-width', 3);
    }
    frame.plot.append('path').attr('d', path(frame, indices, 'z')).attr('fill', 'none').attr('stroke', colours.pipe).attr('stroke-width', 2.2);
    Report.keep_clear(frame, indices.map((i) => [frame.x(st.x[i]), frame.y(st.z[i])]));
    Report.mark(frame, data.tensioner[0], data.tensioner[2], 'tensioner', colours.pipe);
    if (overbend) {
      box_labels(frame);
      Report.legend(frame, [{ text: 'pipe axis', colour: colours.pipe }, { text: 'row in contact', colour: '#e08a3c', block: true }]);
    } else {
      const t = data.touchdown.p;
      Report.mark(frame, t[0], t[2], `touchdown, X = ${Report.shown(t[0], 'm', 1)}`, colours.accent);
      Report.label(frame, frame.x(0.6 * last), frame.y(0), 'mean water level', { css: 'soft', below: true });
    }
  };

  function box_labels(frame) {
    const names = data.supports.map((box) => ({ x: frame.x(box.p[0]) - 2, y: frame.y(box.p[2]) + 16, text: box.name }));
    Report.aslant_names(frame.over, names, -40, { anchor: 'end', css: 'soft halo' });
  }

  Report.plan = function (panel) {
    const indices = Report.indices(data.whole_end);
    const lo = d3.min(indices, (i) => st.y[i]);
    const hi = d3.max(indices, (i) => st.y[i]);
    const room = 0.12 * (hi - lo);
    const last = st.x[indices[indices.length - 1]];
    const frame = Report.frame(panel, { height: 280, x: [st.x[0] - 4, last], y: [lo - room, hi + 1.5 * room], ...labels, y_label: 'Y, to port', y_digits: 2,
      title: 'Plan, whole line (drift enlarged)' });
    frame.plot.append('line').attr('x1', frame.x(st.x[0])).attr('x2', frame.x(last)).attr('y1', frame.y(0)).attr('y2', frame.y(0)).attr('stroke', '#8794a0').attr('stroke-dasharray', '10 4 2 4');
    for (const box of data.supports) {
      frame.back.append('rect').attr('class', 'support').attr('x', frame.x(box.p[0] - box.length / 2)).attr('width', frame.x(box.length) - frame.x(0)).attr('y', frame.margin.top).attr('height', frame.inner_height);
    }
    frame.plot.append('path').attr('d', path(frame, indices, 'y')).attr('fill', 'none').attr('stroke', colours.pipe).attr('stroke-width', 2.2);
    Report.keep_clear(frame, indices.map((i) => [frame.x(st.x[i]), frame.y(st.y[i])]));
    const far = d3.greatest(indices, (i) => Math.abs(st.y[i]));
    Report.mark(frame, st.x[far], st.y[far], `${Report.shown(st.y[far], 'm', 2)} at X = ${Report.shown(st.x[far], 'm', 1)}`, colours.pipe);
    Report.mark(frame, data.touchdown.p[0], data.touchdown.p[1], `touchdown ${Report.shown(data.touchdown.p[1], 'm', 2)}`, colours.accent);
  };
})();
