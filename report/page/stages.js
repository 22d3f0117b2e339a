// The stages of an operation on the line: all shapes in one figure, and results over the stages. A stage that is pointed
// at or chosen below the figure stands out in every panel.
'use strict';
(function () {
  if (!Report.data.stages) return;
  const m = Report.data.stages;
  const colours = Report.colours;
  const last = Math.max(m.list.length - 1, 1);
  const colour_of = (i) => d3.interpolateViridis(0.92 * (1 - i / last) * 0.93);
  const standing = (i) => m.list[i].line !== null;

  // What stands out now; whoever draws stages listens.
  const listeners = [];
  let chosen = null;
  let pointed = null;
  function tell() { for (const one of listeners) one(pointed === null ? chosen : pointed); }
  function point(i) { if (i !== pointed) { pointed = i; tell(); } }
  function choose(i) { chosen = chosen === i ? null : i; pointed = null; tell(); }

  const fixed = (value, digits, unit) => `${Report.fixed(value, digits)}${unit ? ` ${unit}` : ''}`;

  // A stage in a line of words.
  function words(i) {
    const stage = m.list[i];
    if (!standing(i)) return `Stage ${stage.name}: cannot be. ${stage.why}`;
    const parts = m.curves.filter((c) => c.key !== 'use' && c.values[i] !== null).slice(0, 6).map((c) => `${c.name.toLowerCase()} ${fixed(c.values[i], c.digits, c.unit)}`);
    const out = stage.out === null ? '' : `, ${m.out.toLowerCase()} ${Report.shown(stage.out, 'm', 1)}`;
    return `Stage ${stage.name}${out}: ${parts.join(', ')}${stage.use === null ? '' : `; utilisation ${fixed(stage.use, 2)}, ${stage.governing}`}`;
  }

  const shapes = {
    pipe: { width: 1.9, dash: null },
    head: { width: 6, dash: null },
    cable: { width: 1.4, dash: '6 3' },
  };

  const place = (stage, part) => (p) => (part === 'ground' ? [p[0] - stage.ahead, p[1]] : p);
  const points_of = (i, part) => m.list[i].line.flatMap((run) => run.points.map(place(m.list[i], part)));

  function bed_at(x) {
    const bed = m.bed;
    if (bed.length === 0) return null;
    if (x <= bed[0][0]) return bed[0][1];
    for (let k = 1; k < bed.length; ++k) {
      if (x <= bed[k][0]) return bed[k - 1][1] + (bed[k][1] - bed[k - 1][1]) * (x - bed[k - 1][0]) / (bed[k][0] - bed[k - 1][0]);
    }
    return bed[bed.length - 1][1];
  }

  const pixels = (frame, points) => points.map(([x, z]) => [frame.x(x), frame.y(z)]);
  const polygon = (frame, points) => pixels(frame, points).map((p) => p.map((v) => v.toFixed(2)).join(',')).join(' ');

  function surroundings(frame, part) {
    const [x0, x1] = frame.x.domain();
    const [y0, y1] = frame.y.domain();
    const group = frame.plot.append('g');
    group.append('rect').attr('x', frame.x(x0)).attr('width', frame.x(x1) - frame.x(x0)).attr('y', frame.y(Math.min(0, y1))).attr('height', Math.max(0, frame.y(y0) - frame.y(Math.min(0, y1)))).attr('fill', '#eaf3f9').attr('opacity', 0.75);
    const middle = m.bed.map((p) => p[0]).filter((x) => x > x0 && x < x1);
    const bed = [x0, ...middle, x1].map((x) => [x, bed_at(x)]);
    if (m.bed.length > 0) group.append('polygon').attr('points', polygon(frame, [...bed, [x1, y0 - 1], [x0, y0 - 1]])).attr('fill', '#e4dac6');
    if (y1 > 0 && y0 < 0) group.append('line').attr('x1', frame.x(x0)).attr('x2', frame.x(x1)).attr('y1', frame.y(0)).attr('y2', frame.y(0)).attr('stroke', '#6fa8cc').attr('stroke-width', 1.2);
    if (part === 'ground') return;
    if (m.hull.length > 0) group.append('polygon').attr('points', polygon(frame, m.hull)).attr('fill', '#c3ccd5').attr('fill-opacity', 0.55).attr('stroke', '#7b8794');
    for (const on of [false, true]) {
      const rows = m.supports.filter((box) => box.stinger === on).flatMap((box) => box.rows);
      if (rows.length > 1) group.append('polyline').attr('points', polygon(frame, rows)).attr('fill', 'none').attr('stroke', '#8794a0').attr('stroke-width', part === 'supports' ? 2 : 3);
      for (const row of part === 'supports' ? rows : []) group.append('circle').attr('cx', frame.x(row[0])).attr('cy', frame.y(row[1])).attr('r', 3).attr('fill', '#fff').attr('stroke', '#3d4a56');
    }
  }

  // Pipe and cable in one layer, heads in another above every line.
  function draw_stage(frame, layer, i, part, heads) {
    const group = layer.append('g').attr('class', 'stage');
    for (const run of m.list[i].line.filter((one) => (one.of === 'head') === heads)) {
      const { width, dash } = shapes[run.of];
      const stroke = (colour, wide) => group.append('path').attr('d', d3.line()(pixels(frame, run.points.map(place(m.list[i], part))))).attr('fill', 'none').attr('stroke', colour)
        .attr('stroke-width', wide).attr('stroke-dasharray', dash).attr('stroke-linejoin', 'round').attr('stroke-linecap', run.of === 'cable' ? 'round' : 'butt');
      if (heads) stroke('#fff', width + 2);
      stroke(colour_of(i), width);
    }
    return group;
  }

  // The stage whose line passes nearest to the pointer, within reach of it.
  function nearest(lines, x, y) {
    let best = null;
    let least = 14;
    for (const { i, px } of lines) {
      for (let k = 1; k < px.length; ++k) {
        const [ax, ay] = px[k - 1];
        const [dx, dy] = [px[k][0] - ax, px[k][1] - ay];
        const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
        const far = Math.hypot(x - ax - t * dx, y - ay - t * dy);
        if (far < least) { least = far; best = i; }
      }
    }
    return best;
  }

  // Below the figure: every stage with its colour, to be chosen; and the words of the one that stands out.
  function keys(panel) {
    const box = d3.select(panel).append('div').attr('class', 'stage-keys');
    const buttons = m.list.map((stage, i) => {
      const button = box.append('button').attr('type', 'button').attr('aria-pressed', 'false').property('disabled', !standing(i))
        .attr('title', words(i)).on('click', () => choose(i)).on('pointerenter', () => standing(i) && point(i)).on('pointerleave', () => point(null));
      button.append('i').style('background', standing(i) ? colour_of(i) : 'none');
      button.append('span').text(standing(i) ? stage.name : `${stage.name}: cannot be`);
      return button;
    });
    const told = d3.select(panel).append('p').attr('class', 'stage-told');
    listeners.push((now) => {
      buttons.forEach((button, i) => button.attr('aria-pressed', String(i === now)));
      told.text(now === null ? 'Point at a line or choose a stage to read its values.' : words(now));
    });
  }

  // Numbers of the stages beside their heads, where they find room.
  function number_heads(frame, part) {
    const taken = [];
    for (let i = 0; i < m.list.length; ++i) {
      const run = standing(i) && m.list[i].line.find((one) => one.of === 'head');
      if (!run) continue;
      const [x, y] = pixels(frame, [place(m.list[i], part)(run.points[Math.floor(run.points.length / 2)])])[0];
      if (x < frame.margin.left + 8 || x > frame.width - frame.margin.right - 8 || y > frame.height - frame.margin.bottom) continue;
      if (taken.some((p) => Math.abs(p[0] - x) < 17 && Math.abs(p[1] - y) < 14)) continue;
      taken.push([x, y]);
      frame.over.append('text').attr('class', 'halo mark').attr('text-anchor', 'middle').attr('x', x + 9).attr('y', y - 8).style('font-size', '12px').style('fill', colour_of(i)).text(i + 1);
    }
  }

  function frame_of(panel, part, shown) {
    const all = shown.flatMap((i) => points_of(i, part));
    const near = m.supports.flatMap((box) => box.rows);
    let x = d3.extent(all, (p) => p[0]);
    let z = d3.extent(all, (p) => p[1]);
    if (part === 'supports') {
      const [x0, x1] = d3.extent([...near, ...all.filter((p) => p[0] < near[0][0])], (p) => p[0]);
      x = [Math.max(x0, near[0][0] - 15) - 1, x1 + 0.35 * (x1 - x0)];
      const inside = all.filter((p) => p[0] >= x[0] && p[0] <= x[1]);
      z = d3.extent([...near, ...inside], (p) => p[1]);
    } else if (part === 'whole') {
      x = [Math.min(x[0], d3.min(m.hull, (p) => p[0]) ?? x[0]), x[1]];
      z = [Math.min(z[0], d3.min(m.bed, (p) => p[1]) ?? z[0]), Math.max(z[1], d3.max(m.hull, (p) => p[1]) ?? z[1], 0)];
    }
    const room = 0.06 * (z[1] - z[0] || 1);
    const titles = { whole: 'Seen from the barge (true to scale)', supports: 'Ramp and stinger (heights enlarged)', ground: 'Over ground: the place of the barge at the first stage is zero (true to scale)' };
    return Report.frame(panel, { equal: part !== 'supports', most: 460, height: 360, x: [x[0], x[1] + 0.01 * (x[1] - x[0])], y: [z[0] - room, z[1] + 1.4 * room],
      x_label: part === 'ground' ? 'X, astern of the stern shoe at the first stage' : 'X, astern of the stern shoe', x_si: 'm', y_label: 'Z, above the water', y_si: 'm', title: titles[part] });
  }

  Report.stages = function (panel, part) {
    const shown = d3.range(m.list.length).filter(standing);
    const frame = frame_of(panel, part, shown);
    surroundings(frame, part);
    const layers = [frame.plot.append('g'), frame.plot.append('g')];
    const groups = new Map(shown.map((i) => [i, layers.map((layer, k) => draw_stage(frame, layer, i, part, k === 1))]));
    const lines = shown.map((i) => ({ i, px: pixels(frame, points_of(i, part)) }));
    for (const { px } of lines) Report.keep_clear(frame, px);
    number_heads(frame, part);
    const present = (of) => shown.some((i) => m.list[i].line.some((run) => run.of === of));
    if (present('cable')) {
      const dark = '#41505e';
      Report.legend(frame, [{ text: 'pipe', colour: dark }, { text: 'head', colour: dark, width: 6 }, { text: 'cable', colour: dark, dash: '6 3', width: 1.4 }]);
    }
    frame.svg.on('pointermove', (event) => point(nearest(lines, ...d3.pointer(event)))).on('pointerleave', () => point(null))
      .on('click', (event) => { const i = nearest(lines, ...d3.pointer(event)); if (i !== null) choose(i); });
    listeners.push((now) => {
      for (const [i, of] of groups) for (const group of of) group.attr('opacity', now === null || i === now ? 1 : 0.22);
      if (groups.has(now)) for (const group of groups.get(now)) group.raise();
    });
    if (part === 'whole') keys(panel);
    tell();
  };

  // Over what the curves run: the length out where it changes one way at every stage, else the number of the stage.
  const outs = m.list.map((stage) => stage.out);
  const one_way = (sign) => outs.every((out, i) => out !== null && (i === 0 || sign * (out - outs[i - 1]) > 0));
  const by_length = m.list.length > 1 && (one_way(1) || one_way(-1));
  const at = (i) => (by_length ? outs[i] : i + 1);

  function curve_panel(panel, curve) {
    const known = d3.range(m.list.length).filter((i) => curve.values[i] !== null);
    let [lo, hi] = d3.extent(known, (i) => curve.values[i]);
    const shows_limit = curve.limit !== null && curve.limit < hi + 3 * Math.max(hi - lo, 0.1 * Math.abs(hi)) && curve.limit > lo - 3 * Math.max(hi - lo, 0.1 * Math.abs(lo));
    if (shows_limit) { lo = Math.min(lo, curve.limit); hi = Math.max(hi, curve.limit); }
    const room = 0.1 * (hi - lo);
    const [x0, x1] = d3.extent(d3.range(m.list.length), at);
    const side = 0.03 * (x1 - x0 || 1);
    const frame = Report.frame(panel, { width: 480, height: 220, left: 70, x: [x0 - side, x1 + side], y: [lo - room, hi + 1.6 * room], y_digits: curve.digits, x_ticks: 6, ...(by_length ? {} : { x_tick_values: d3.ticks(1, m.list.length, 6).filter(Number.isInteger), x_tick_format: d3.format('d') }),
      x_label: by_length ? m.out : 'Stage', x_si: by_length ? 'm' : undefined, y_label: '', title: `${curve.name}${curve.unit ? ` [${curve.unit}]` : ''}` });
    frame.svg.classed('small', true);
    if (shows_limit) {
      frame.plot.append('line').attr('x1', frame.margin.left).attr('x2', frame.width - frame.margin.right).attr('y1', frame.y(curve.limit)).attr('y2', frame.y(curve.limit))
        .attr('stroke', colours.accent).attr('stroke-dasharray', '8 4').attr('stroke-width', 1.3);
    }
    const line = d3.line().defined((i) => curve.values[i] !== null).x((i) => frame.x(at(i))).y((i) => frame.y(curve.values[i]));
    frame.plot.append('path').attr('d', line(d3.range(m.list.length))).attr('fill', 'none').attr('stroke', '#9aa6b1').attr('stroke-width', 1.5);
    const dots = known.map((i) => ({ i, dot: frame.over.append('circle').attr('cx', frame.x(at(i))).attr('cy', frame.y(curve.values[i])).attr('r', 3.4).attr('fill', colour_of(i)).attr('stroke', '#fff').attr('stroke-width', 0.7) }));
    const value = frame.over.append('text').attr('class', 'halo mark').attr('text-anchor', 'middle');
    frame.svg.on('pointermove', (event) => point(d3.least(known, (i) => Math.abs(frame.x(at(i)) - d3.pointer(event)[0])) ?? null)).on('pointerleave', () => point(null));
    listeners.push((now) => {
      for (const { i, dot } of dots) dot.attr('r', i === now ? 5.5 : 3.4);
      const has = now !== null && curve.values[now] !== null;
      value.attr('display', has ? null : 'none');
      if (has) value.attr('x', Math.min(Math.max(frame.x(at(now)), frame.margin.left + 26), frame.width - frame.margin.right - 26)).attr('y', Math.max(frame.y(curve.values[now]) - 9, frame.margin.top + 10)).text(Report.fixed(curve.values[now], curve.digits));
    });
  }

  Report.stage_curves = function (panel) {
    for (const curve of m.curves) curve_panel(panel, curve);
    tell();
  };
})();
