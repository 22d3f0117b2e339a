// Moorings: plan, profiles, offsets of the vessel, stages of an operation. World frame: x east, y north.
'use strict';
(function () {
  const data = Report.data;
  if (!data.moorings) return;
  const m = data.moorings;
  const rest = m.states[0];
  const colours = Report.colours;
  const line_colours = { hanging: '#00785a', bed: '#8fcbb6', slack: colours.second, parted: colours.accent };
  const kHull = { fill: '#c3ccd5', stroke: '#5d6a76' };

  // Ahead and to port of the hull as drawn, in the world.
  const ahead = [Math.sin(m.heading), Math.cos(m.heading)];
  const to_port = [-ahead[1], ahead[0]];
  const from_drawn = (surge, sway) => [surge * ahead[0] + sway * to_port[0], surge * ahead[1] + sway * to_port[1]];

  // Outline of the hull at its pose: a rounded bow tells where ahead is.
  function outline(state) {
    const middle = from_drawn(state.surge, state.sway);
    const turn = Math.atan2(ahead[1], ahead[0]) + state.yaw;
    const [l, b] = [m.length / 2, m.beam / 2];
    return [[-l, -b], [0.8 * l, -b], [l, -0.35 * b], [l, 0.35 * b], [0.8 * l, b], [-l, b]]
      .map(([x, y]) => [middle[0] + x * Math.cos(turn) - y * Math.sin(turn), middle[1] + x * Math.sin(turn) + y * Math.cos(turn)]);
  }

  const pixels = (frame, points) => points.map((p) => [frame.x(p[0]), frame.y(p[1])]);
  const polygon = (frame, points) => pixels(frame, points).map((p) => p.map((v) => v.toFixed(2)).join(',')).join(' ');

  function stroke(frame, points, colour, width, dash) {
    frame.plot.append('path').attr('d', d3.line()(pixels(frame, points))).attr('fill', 'none').attr('stroke', colour)
      .attr('stroke-width', width).attr('stroke-dasharray', dash || null).attr('stroke-linejoin', 'round');
  }

  const across = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

  // The part that hangs, from the fairlead, and the part from the first touchdown on.
  function parts(line) {
    const cut = line.shape.findIndex((p) => across(p, line.fairlead) >= line.touchdown - 0.5);
    return cut < 0 || line.on_bed <= 0 ? [line.shape, []] : [line.shape.slice(0, cut + 1), line.shape.slice(cut)];
  }

  function draw_line(frame, line) {
    if (line.parted) {
      stroke(frame, [line.fairlead, line.anchor], line_colours.parted, 1.2, '3 5');
      return;
    }
    const [hanging, bed] = parts(line);
    if (bed.length > 1) stroke(frame, bed, line_colours.bed, 2);
    stroke(frame, hanging, line.slack ? line_colours.slack : line_colours.hanging, 2.2, line.slack ? '6 4' : null);
    if (bed.length > 1) {
      frame.over.append('circle').attr('cx', frame.x(bed[0][0])).attr('cy', frame.y(bed[0][1])).attr('r', 2.6)
        .attr('fill', '#fff').attr('stroke', line_colours.hanging).attr('stroke-width', 1.3);
    }
  }

  function anchor(frame, line) {
    const [x, y] = [frame.x(line.anchor[0]), frame.y(line.anchor[1])];
    frame.over.append('path').attr('d', `M${x - 5} ${y + 4}L${x + 5} ${y + 4}L${x} ${y - 5}Z`).attr('fill', '#3d4a56');
    frame.used.push({ x0: x - 6, x1: x + 6, y0: y - 6, y1: y + 6 });
  }

  const tension_words = (line) => (line.parted ? 'parted' : line.slack ? 'slack' : Report.shown(line.tension, 'N', 1));

  // Name and tension outside the anchor, where the line does not run; above or below where it points north or south.
  function name_line(frame, line) {
    const way = [line.anchor[0] - line.fairlead[0], line.anchor[1] - line.fairlead[1]];
    const far = Math.hypot(...way) || 1;
    const [ux, uy] = [way[0] / far, -way[1] / far];
    const wide = Math.max(Report.text_width(frame, line.name, 'mark'), Report.text_width(frame, tension_words(line), 'soft'));
    const [px, py] = [frame.x(line.anchor[0]), frame.y(line.anchor[1])];
    const places = [];
    for (const out of [0, 20, 40]) {
      for (const [cx, cy] of [[ux, uy], [ux, 0], [0, uy < 0 ? -1 : 1], [-ux, uy]]) {
        const size = Math.hypot(cx, cy) || 1;
        const reach = [cx / size, cy / size];
        places.push([px + reach[0] * (12 + out) + (Math.abs(reach[0]) > 0.35 ? (reach[0] > 0 ? 0 : -wide) : -wide / 2),
                     py + reach[1] * (16 + out) + (reach[1] < -0.35 ? -18 : reach[1] > 0.35 ? 10 : -3)]);
      }
    }
    const box = ([x, y]) => ({ x0: x, x1: x + wide, y0: y - 12, y1: y + 20 });
    const inside = (b) => b.x0 >= frame.margin.left + 2 && b.x1 <= frame.width - frame.margin.right - 2 && b.y0 >= frame.margin.top && b.y1 <= frame.height - frame.margin.bottom - 2;
    const clear = (b) => frame.used.every((u) => b.x1 < u.x0 || b.x0 > u.x1 || b.y1 < u.y0 || b.y0 > u.y1);
    const place = places.find((p) => inside(box(p)) && clear(box(p))) || places.find((p) => inside(box(p))) || places[0];
    frame.used.push(box(place));
    const left = place[0] + wide < px;  // flush with the anchor
    const x = left ? place[0] + wide : place[0];
    const text = frame.over.append('text').attr('class', 'halo').attr('x', x).attr('y', place[1]).attr('text-anchor', left ? 'end' : 'start');
    text.append('tspan').attr('class', 'mark').text(line.name);
    text.append('tspan').attr('x', x).attr('dy', 17).style('fill', line.parted || line.slack ? line_colours.parted : '#41505e').text(tension_words(line));
  }

  function draw_hull(frame, state, options = {}) {
    if (!(m.length > 0)) return;
    frame.plot.append('polygon').attr('points', polygon(frame, outline(state))).attr('fill', options.fill || kHull.fill).attr('stroke', options.stroke || kHull.stroke)
      .attr('stroke-dasharray', options.dash || null).attr('stroke-width', 1.2);
  }

  // An arrow that points along an azimuth, clockwise from north.
  function arrow(group, x, y, azimuth, colour, text) {
    const [dx, dy] = [17 * Math.sin(azimuth), -17 * Math.cos(azimuth)];
    const head = d3.range(3).map((k) => [[dx, dy], [-0.45 * dy + 0.35 * dx, 0.45 * dx + 0.35 * dy], [0.45 * dy + 0.35 * dx, -0.45 * dx + 0.35 * dy]][k]);
    group.append('line').attr('x1', x - dx).attr('y1', y - dy).attr('x2', x + 0.4 * dx).attr('y2', y + 0.4 * dy).attr('stroke', colour).attr('stroke-width', 2.4);
    group.append('polygon').attr('points', head.map(([a, b]) => `${(x + a).toFixed(1)},${(y + b).toFixed(1)}`).join(' ')).attr('fill', colour);
    group.append('text').attr('class', 'halo').attr('x', x + 26).attr('y', y + 5).text(text);
  }

  const degrees = (angle) => `${Report.fixed(((angle * 180) / Math.PI % 360 + 360) % 360, 0)}\u00b0`;

  function directions(frame) {
    const group = frame.over.append('g');
    const x = frame.margin.left + 32;
    let y = frame.margin.top + 30;
    arrow(group, x, y, 0, '#1b2733', 'north');
    if (m.waves_from !== null) arrow(group, x, (y += 46), m.waves_from + Math.PI, '#2f7fb5', `waves from ${degrees(m.waves_from)}`);
    if (m.current_to !== null) arrow(group, x, (y += 46), m.current_to, '#6a3d9a', `current to ${degrees(m.current_to)}`);
    frame.used.push({ x0: frame.margin.left, x1: x + 150, y0: frame.margin.top, y1: y + 24 });
  }

  // A bar of a round length, about a sixth of the width.
  function scale_bar(frame) {
    const unit = Report.unit('m');
    const per_unit = Math.abs(frame.x(1) - frame.x(0)) / unit.factor;
    const wanted = frame.inner_width / 6 / per_unit;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const long = [5, 2, 1].map((k) => k * power).find((k) => k <= wanted);
    const x1 = frame.width - frame.margin.right - 14;
    const x0 = x1 - long * per_unit;
    const y = frame.height - frame.margin.bottom - 14;
    frame.over.append('path').attr('d', `M${x0} ${y - 5}V${y}H${x1}V${y - 5}`).attr('fill', 'none').attr('stroke', '#1b2733').attr('stroke-width', 1.6);
    frame.over.append('text').attr('class', 'halo').attr('text-anchor', 'middle').attr('x', (x0 + x1) / 2).attr('y', y - 8).text(`${long} ${unit.name}`);
    frame.used.push({ x0: x0 - 4, x1: x1 + 4, y0: y - 24, y1: y + 4 });
  }

  function objects(frame) {
    for (const object of m.objects) {
      stroke(frame, object.points, '#8a5a2b', 2.4, '9 4');
      const at = object.points[Math.floor(object.points.length / 2)];
      if (object.points.length < 2) frame.plot.append('circle').attr('cx', frame.x(at[0])).attr('cy', frame.y(at[1])).attr('r', 5).attr('fill', '#8a5a2b');
      Report.label(frame, frame.x(at[0]), frame.y(at[1]), object.name, { css: '', fill: '#6d4620' });
    }
  }

  function draw_pipe(frame) {
    if (m.pipe.length === 0) return;
    stroke(frame, m.pipe, colours.pipe, 3);
    const [x, y] = [frame.x(m.touchdown[0]), frame.y(m.touchdown[1])];
    frame.over.append('circle').attr('cx', x).attr('cy', y).attr('r', 4).attr('fill', '#fff').attr('stroke', colours.pipe).attr('stroke-width', 2);
    Report.keep_clear(frame, pixels(frame, m.pipe));
    Report.label(frame, x, y, 'pipe, touchdown', { css: '', fill: colours.pipe });
  }

  // What has to be seen: anchors, hull, pipe, objects as far as they lie between the anchors.
  function field() {
    const points = [...rest.lines.flatMap((line) => [line.anchor, line.fairlead]), ...outline(rest), ...m.pipe];
    return [d3.extent(points, (p) => p[0]), d3.extent(points, (p) => p[1])];
  }

  Report.mooring_plan = function (panel) {
    const [x, y] = field();
    const room = 0.1 * Math.max(x[1] - x[0], y[1] - y[0], 10);
    const frame = Report.frame(panel, { equal: true, most: 640, x: [x[0] - room, x[1] + room], y: [y[0] - room, y[1] + room], x_label: 'East', x_si: 'm', y_label: 'North', y_si: 'm', x_ticks: 8,
      title: 'Moorings in plan, true to scale' });
    objects(frame);
    for (const line of rest.lines) {
      draw_line(frame, line);
      Report.keep_clear(frame, pixels(frame, [line.fairlead, line.anchor]));
    }
    draw_hull(frame, rest);
    draw_pipe(frame);
    directions(frame);
    scale_bar(frame);
    rest.lines.forEach((line) => anchor(frame, line));
    rest.lines.forEach((line) => name_line(frame, line));
    Report.legend(frame, [{ text: 'hanging', colour: line_colours.hanging }, { text: 'on the bed', colour: line_colours.bed },
      ...(m.pipe.length > 0 ? [{ text: 'pipe', colour: colours.pipe, width: 3 }] : [])]);
  };

  // Lines whose profile is the same to the width of a stroke share one name.
  function alike(lines) {
    const groups = [];
    for (const line of lines) {
      const same = groups.find((g) => Math.abs(g[0].touchdown - line.touchdown) < 0.5 && Math.abs(across(g[0].anchor, g[0].fairlead) - across(line.anchor, line.fairlead)) < 0.5);
      if (same) same.push(line); else groups.push([line]);
    }
    return groups;
  }

  Report.mooring_profile = function (panel) {
    const lines = rest.lines.filter((line) => !line.parted && line.shape.length > 1);
    const profile = (line) => line.shape.map((p) => [across(p, line.fairlead), p[2]]);
    const far = d3.max(lines, (line) => across(line.anchor, line.fairlead));
    const low = d3.min(lines, (line) => d3.min(line.shape, (p) => p[2]));
    const high = Math.max(0, d3.max(lines, (line) => line.fairlead[2]));
    const frame = Report.frame(panel, { height: 300, x: [0, 1.03 * far], y: [low - 0.1 * (high - low), high + 0.08 * (high - low)],
      x_label: 'Horizontal distance from the fairlead', x_si: 'm', y_label: 'Z, above the water', y_si: 'm', title: 'Lines in profile; open circle: touchdown' });
    const water = frame.y(0);
    frame.back.append('rect').attr('x', frame.margin.left).attr('width', frame.inner_width).attr('y', water).attr('height', frame.height - frame.margin.bottom - water).attr('fill', '#f1f7fb');
    frame.plot.append('line').attr('x1', frame.margin.left).attr('x2', frame.width - frame.margin.right).attr('y1', water).attr('y2', water).attr('stroke', '#6fa8cc');
    for (const line of lines) stroke(frame, profile(line), line.slack ? line_colours.slack : line_colours.hanging, 1.5);
    for (const line of lines) Report.keep_clear(frame, pixels(frame, profile(line)));
    name_touchdowns(frame, alike(lines));
  };

  // A list at the upper right, where no line hangs, with leaders to the touchdowns: the nearest on top, so that none cross.
  function name_touchdowns(frame, groups) {
    groups.sort((a, b) => a[0].touchdown - b[0].touchdown);
    const right = frame.width - frame.margin.right - 8;
    const rows = groups.filter((_, k) => frame.margin.top + 26 + 19 * k < frame.height - frame.margin.bottom - 40);
    const words = rows.map((group) => group.map((one) => one.name).join(', '));
    const left = right - d3.max(words, (text) => Report.text_width(frame, text, 'soft')) - 6;
    rows.forEach((group, k) => {
      const line = group[0];
      const bed = parts(line)[1];
      const at = bed.length > 0 ? bed[0] : line.shape[line.shape.length - 1];
      const [x, y] = [frame.x(across(at, line.fairlead)), frame.y(at[2])];
      const up = Math.max(frame.margin.top, frame.y(0)) + 16 + 19 * k;
      frame.over.append('text').attr('class', 'soft halo').attr('x', left + 6).attr('y', up + 5).text(words[k]);
      frame.over.append('path').attr('d', `M${left} ${up}L${Math.min(left - 14, x + 60)} ${up}L${x} ${y - 4}`).attr('fill', 'none').attr('stroke', '#9aa6b1').attr('stroke-width', 0.9);
      frame.over.append('circle').attr('cx', x).attr('cy', y).attr('r', 3.2).attr('fill', '#fff').attr('stroke', line_colours.hanging).attr('stroke-width', 1.5);
    });
  }

  // Offsets: a cross where midship was drawn, a point per state, and of a dynamic run its ellipse and its range.
  function ellipse(frame, run) {
    const [mx, my] = [run.along.mean, run.across.mean];
    const [a, b, c] = [run.along.std ** 2, run.covariance, run.across.std ** 2];
    const angle = 0.5 * Math.atan2(2 * b, a - c);
    const root = Math.hypot((a - c) / 2, b);
    const radii = [Math.sqrt((a + c) / 2 + root), Math.sqrt(Math.max((a + c) / 2 - root, 0))];
    const at = (k, turn) => {
      const [u, v] = [k * radii[0] * Math.cos(turn), k * radii[1] * Math.sin(turn)];
      return start_frame(run, mx + u * Math.cos(angle) - v * Math.sin(angle), my + u * Math.sin(angle) + v * Math.cos(angle));
    };
    for (const k of [3, 2, 1]) {
      frame.plot.append('polygon').attr('points', polygon(frame, d3.range(0, 2 * Math.PI, Math.PI / 60).map((turn) => at(k, turn))))
        .attr('fill', colours.band).attr('fill-opacity', 0.3).attr('stroke', colours.dynamic).attr('stroke-width', 1);
      Report.keep_clear(frame, pixels(frame, d3.range(0, 2 * Math.PI, Math.PI / 20).map((turn) => at(k, turn))));
    }
    const corner = (along, port) => start_frame(run, run.along[along], run.across[port]);
    const box = [corner('min', 'min'), corner('max', 'min'), corner('max', 'max'), corner('min', 'max')];
    frame.plot.append('polygon').attr('points', polygon(frame, box)).attr('fill', 'none').attr('stroke', colours.dynamic).attr('stroke-dasharray', '6 4');
    return box;
  }

  // From where midship lay at the start of the run, along the axes of the hull as drawn.
  const start_frame = (run, along, port) => from_drawn(run.start_surge + along, run.start_sway + port);

  Report.mooring_offsets = function (panel, part) {
    const run = part === 'dynamic' ? data.dynamic.vessel : null;
    const states = run ? [rest] : m.states;
    const points = states.map((state) => from_drawn(state.surge, state.sway));
    const shown = [[0, 0], ...points];
    if (run) {
      for (const along of ['min', 'max']) for (const port of ['min', 'max']) shown.push(start_frame(run, run.along[along], run.across[port]));
      const reach = 3 * Math.max(run.along.std, run.across.std);
      for (const k of [-1, 1]) { shown.push(start_frame(run, run.along.mean + k * reach, run.across.mean)); shown.push(start_frame(run, run.along.mean, run.across.mean + k * reach)); }
    }
    const [x, y] = [d3.extent(shown, (p) => p[0]), d3.extent(shown, (p) => p[1])];
    const size = Math.max(x[1] - x[0], y[1] - y[0], 1e-3);
    const room = 0.14 * size;
    const frame = Report.frame(panel, { equal: true, most: 420, x: [x[0] - room, x[1] + room], y: [(y[0] + y[1] - Math.max(y[1] - y[0], 0.4 * size)) / 2 - room, (y[0] + y[1] + Math.max(y[1] - y[0], 0.4 * size)) / 2 + room],
      x_label: 'East of midship as drawn', x_si: 'm', y_label: 'North', y_si: 'm', title: run ? 'Offset of midship: ellipses of 1, 2 and 3 standard deviations, dashed: range of the run' : 'Offset of midship' });
    const [bx, by] = [frame.width - frame.margin.right - 46, frame.margin.top + 28];
    if (m.length > 0) {
      arrow(frame.over.append('g'), bx - 30, by, m.heading, '#5d6a76', 'bow');
      frame.used.push({ x0: bx - 52, x1: bx + 44, y0: by - 22, y1: by + 22 });
    }
    if (run) ellipse(frame, run);
    const cross = [frame.x(0), frame.y(0)];
    frame.over.append('path').attr('d', `M${cross[0] - 7} ${cross[1]}H${cross[0] + 7}M${cross[0]} ${cross[1] - 7}V${cross[1] + 7}`).attr('stroke', '#1b2733').attr('stroke-width', 1.6);
    frame.used.push({ x0: cross[0] - 8, x1: cross[0] + 8, y0: cross[1] - 8, y1: cross[1] + 8 });
    Report.label(frame, ...cross, 'as drawn', { css: 'soft' });
    states.forEach((state, i) => Report.mark(frame, points[i][0], points[i][1], i === 0 ? (run ? 'start of the run' : 'at rest') : state.name, i === 0 ? colours.pipe : colours.second));
    if (run) Report.mark(frame, ...start_frame(run, run.along.mean, run.across.mean), 'mean', colours.dynamic);
  };

  const kPalette = ['#0b5394', '#c77700', '#009e73', '#b3261e', '#6a3d9a', '#56b4e9', '#7b8794', '#8a5a2b', '#d55e00', '#117733', '#882255', '#332288'];

  // Tension of every line stage by stage, or tension and length over the advance of a pull-ahead.
  Report.mooring_stages = function (panel, part) {
    if (part === 'stages') stage_tensions(panel); else over_advance(panel, part);
  };

  const names_of = () => rest.lines.map((line) => line.name);

  // curves: a list of points per line; their names stand at the right end.
  function draw_curves(frame, curves, dots) {
    const ends = [];
    curves.forEach((points, k) => {
      if (points.length === 0) return;
      const colour = kPalette[k % kPalette.length];
      stroke(frame, points, colour, 1.8, k >= curves.length / 2 ? '7 3' : null);
      if (dots) for (const p of points) frame.plot.append('circle').attr('cx', frame.x(p[0])).attr('cy', frame.y(p[1])).attr('r', 3).attr('fill', colour);
      ends.push({ name: names_of()[k], colour, y: frame.y(points[points.length - 1][1]) });
    });
    name_ends(frame, ends);
  }

  function roomy(curves) {
    const [lo, hi] = d3.extent(curves.flat(), (p) => p[1]);
    const room = 0.08 * (hi - lo);
    return [lo - room, hi + room];
  }

  function stage_tensions(panel) {
    const words = m.states.map((state, i) => (i === 0 ? 'at rest' : state.name.length > 30 ? `${state.name.slice(0, 29)}\u2026` : state.name));
    const deep = 36 + Math.sin(24 * Math.PI / 180) * d3.max(words, (text) => Report.measured(text, 14));
    const curves = names_of().map((_, k) => d3.range(m.states.length).filter((i) => !m.states[i].lines[k].parted).map((i) => [i, m.states[i].lines[k].tension]));
    const frame = Report.frame(panel, { height: 300 + deep - 50, right: 210, x: [-0.25, m.states.length - 0.75], y: roomy(curves), bottom: deep, x_tick_values: [],
      x_label: '', y_label: 'Tension at the fairlead', y_si: 'N', y_digits: 1, title: 'Tension at the fairleads' });
    draw_curves(frame, curves, true);
    words.forEach((text, i) => {
      frame.over.append('text').attr('class', 'soft name').attr('text-anchor', 'end').attr('transform', `translate(${frame.x(i) + 4},${frame.height - frame.margin.bottom + 18}) rotate(-24)`).text(text);
    });
  }

  function over_advance(panel, part) {
    const value = part === 'tensions' ? (step, k) => step.tensions[k] : (step, k) => step.lengths[k] - m.steps[0].lengths[k];
    const curves = names_of().map((_, k) => m.steps.map((step) => [step.advance, value(step, k)]));
    const frame = Report.frame(panel, { height: 300, right: 210, x: d3.extent(m.steps, (step) => step.advance), y: roomy(curves), x_label: 'Advance of the vessel', x_si: 'm',
      ...(part === 'tensions' ? { y_label: 'Tension at the fairlead', y_si: 'N', y_digits: 1 } : { y_label: 'Length paid out', y_si: 'm', y_digits: 3 }), title: part === 'tensions' ? 'Tension at the fairleads' : 'Length paid out by the winches' });
    draw_curves(frame, curves, m.steps.length < 12);
  }

  const kOfPipe = {
    tension: ['Tension at the tensioner', 'N', 1],
    overbend: ['Overbend, largest bending stress', 'Pa', 1],
    sagbend: ['Sagbend, largest bending stress', 'Pa', 1],
    clearance: ['Clearance at the stinger tip', 'm', 3],
  };

  Report.move_pipe = function (panel) {
    for (const [key, [title, si, digits]] of Object.entries(kOfPipe)) {
      if (m.steps.some((step) => step.pipe[key] === null)) continue;
      const points = m.steps.map((step) => [step.advance, step.pipe[key]]);
      const frame = Report.frame(panel, { width: 480, height: 210, left: 68, x: d3.extent(points, (p) => p[0]), y: roomy([points]), y_si: si, y_digits: digits, x_ticks: 6, x_label: 'Advance of the vessel', x_si: 'm',
        y_label: '', title: `${title} [${Report.unit(si).name}]` });
      frame.svg.classed('small', true);
      stroke(frame, points, colours.pipe, 2);
    }
  };

  // Names at the right of their curves, pushed apart; those that end at one height share a line.
  function name_ends(frame, ends) {
    ends.sort((a, b) => a.y - b.y);
    const kApart = 15;
    const rows = [];
    for (const end of ends) rows.push({ ...end, at: Math.max(end.y, rows.length > 0 ? rows[rows.length - 1].at + kApart : frame.margin.top + 4) });
    for (let i = rows.length - 1, below = frame.height - frame.margin.bottom; i >= 0; --i) { rows[i].at = Math.min(rows[i].at, below); below = rows[i].at - kApart; }
    const x = frame.width - frame.margin.right;
    for (const row of rows) {
      frame.over.append('path').attr('d', `M${x} ${row.y}L${x + 14} ${row.at}`).attr('stroke', row.colour).attr('fill', 'none').attr('stroke-width', 0.8);
      frame.over.append('text').attr('x', x + 18).attr('y', row.at + 5).style('fill', row.colour).text(row.name);
    }
  }
  Report.name_ends = name_ends;
  Report.line_palette = kPalette;
})();
