// What stands in the three-dimensional views: sea, vessel, ramp, stinger, rollers, pipe.
'use strict';
(function () {
  const data = Report.data;
  const st = data.stations;
  const { cross, unit, add, hand, dot } = Report.vector;
  const kLayer = { bed: 0, under: 1, water: 2, behind: 3, things: 4, before: 5 };
  const stress_colour = d3.scaleSequential([0, d3.max(st.von_mises) * Report.unit('Pa').factor], (t) => d3.interpolateViridis(0.88 - 0.83 * t));
  const point = (i) => hand([st.x[i], st.y[i], st.z[i]]);

  function sea(painter, x0, x1, wide) {
    const bed = (x, y) => [x, y, Report.bed(x)];
    const along = Report.bed_places(x0, x1);
    painter.face(kLayer.bed, [...along.map((x) => bed(x, -wide)), ...along.slice().reverse().map((x) => bed(x, wide))], 'fill="#efe8d8" stroke="#cfc3a6"');
    const step = d3.tickStep(x0, x1, 10);
    for (const x of d3.range(Math.ceil(x0 / step) * step, x1, step)) painter.line(kLayer.bed, [bed(x, -wide), bed(x, wide)], 'stroke="#d9ceb4" stroke-width="0.8"', 1e6);
    for (const y of d3.range(Math.ceil(-wide / step) * step, wide, step)) painter.line(kLayer.bed, along.map((x) => bed(x, y)), 'stroke="#d9ceb4" stroke-width="0.8"', 1e6);
    painter.face(kLayer.water, [[x0, -wide, 0], [x1, -wide, 0], [x1, wide, 0], [x0, wide, 0]], 'fill="#7fb2d6" fill-opacity="0.16" stroke="#7fb2d6" stroke-width="0.8"');
  }

  // A translucent box between two heights of the hull: faces turned away first, faces towards the eye last.
  function hull_box(painter, low, high, layers, opacity) {
    const corner = (i, j, k) => hand(Report.hull_corner(i, j, k, low, high));
    const faces = [[[-1, -1, -1], [-1, 1, -1], [-1, 1, 1], [-1, -1, 1]], [[1, -1, -1], [1, 1, -1], [1, 1, 1], [1, -1, 1]], [[-1, -1, -1], [1, -1, -1], [1, -1, 1], [-1, -1, 1]],
      [[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]], [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1]], [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]];
    const middle = hand(data.vessel.origin);
    for (const face of faces) {
      const points = face.map((c) => corner(...c));
      const centre = [0, 1, 2].map((k) => d3.mean(points, (p) => p[k]));
      const outward = add(centre, [middle[0], middle[1], middle[2] + (low + high) / 2], -1);
      const front = dot(outward, painter.camera.towards_eye) > 0;
      painter.face(front ? layers[1] : layers[0], points, `fill="#93a3b1" fill-opacity="${front ? opacity : 2 * opacity}" stroke="#66757f" stroke-width="0.9" stroke-linejoin="round"`);
    }
  }

  function hull(painter, opacity) {
    const v = data.vessel;
    hull_box(painter, -v.draught, 0, [kLayer.under, kLayer.under], opacity);
    hull_box(painter, 0, v.depth - v.draught, [kLayer.behind, kLayer.before], opacity);
  }

  // Schematic chords and posts under the boxes of ramp and stinger.
  function structure(painter, layer, width, shown) {
    for (const on of [false, true]) {
      const boxes = shown.filter((b) => b.stinger === on);
      if (boxes.length === 0) continue;
      const chord = (across, down) => boxes.flatMap((b) => [-0.5, 0.5].map((k) => hand(add(Report.below_box(b, k * b.length, down), [0, across, 0]))));
      const deep = on ? 1.9 : 0.9;
      const chords = [[1, 0.6], [-1, 0.6], [0.8, deep], [-0.8, deep]].map(([a, d]) => chord(a, d));
      const style = `stroke="#76838f" stroke-width="${width}" stroke-linecap="round"`;
      const thin = `stroke="#97a3ad" stroke-width="${0.65 * width}"`;
      for (const c of chords) for (let i = 1; i < c.length; ++i) painter.line(layer, [c[i - 1], c[i]], style);
      for (let i = 0; i < chords[0].length; ++i) {
        painter.line(layer, [chords[0][i], chords[1][i]], style);
        painter.line(layer, [chords[0][i], chords[2][i]], thin);
        painter.line(layer, [chords[1][i], chords[3][i]], thin);
        painter.line(layer, [chords[2][i], chords[3][i]], thin);
        if (i > 0) {
          painter.line(layer, [chords[2][i - 1], chords[0][i]], thin);
          painter.line(layer, [chords[3][i - 1], chords[1][i]], thin);
        }
      }
    }
  }

  // Two unit vectors across an axis.
  function across(axis) {
    const helper = Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
    const a = unit(cross(helper, axis));
    return [a, cross(axis, a)];
  }

  function ring(centre, [a, b], radius, sides) {
    return d3.range(sides).map((k) => {
      const angle = 2 * Math.PI * k / sides;
      const normal = add(a.map((v) => v * Math.cos(angle)), b, Math.sin(angle));
      return { normal, p: add(centre, normal, radius) };
    });
  }

  function tube(painter, layer, from, to, radius, sides, frames, colour) {
    const first = ring(from, frames[0], radius, sides);
    const second = ring(to, frames[1], radius, sides);
    for (let k = 0; k < sides; ++k) {
      const m = (k + 1) % sides;
      painter.shaded(layer, [first[k].p, first[m].p, second[m].p, second[k].p], unit(add(first[k].normal, first[m].normal)), colour);
    }
    return [first, second];
  }

  function roller(painter, layer, r) {
    const axis = unit(hand(r.axis));
    const centre = add(hand(r.p), hand(r.normal), -r.radius);
    const frame = across(axis);
    const ends = [add(centre, axis, -r.face / 2), add(centre, axis, r.face / 2)];
    const colour = r.reaction > 0 ? '#e8741a' : '#aab4bd';
    const rings = tube(painter, layer, ends[0], ends[1], r.radius, 12, [frame, frame], colour);
    painter.shaded(layer, rings[0].map((c) => c.p), axis.map((v) => -v), colour);
    painter.shaded(layer, rings[1].map((c) => c.p), axis, colour);
  }

  // The pipe as a body, coloured by stress. Long stretches are cut so that painting order stays right.
  function pipe_body(painter, layer, s0, s1) {
    const cuts = d3.range(s0, s1, 0.5);
    const at = (s) => hand(['x', 'y', 'z'].map((c) => Report.at(c, s)));
    for (let i = 1; i < cuts.length; ++i) {
      const a = at(cuts[i - 1]);
      const b = at(cuts[i]);
      const frame = across(unit(add(b, a, -1)));
      tube(painter, layer, a, b, data.pipe_outer_diameter / 2, 12, [frame, frame], stress_colour(Report.at('von_mises', cuts[i]) * Report.unit('Pa').factor));
    }
  }

  function pipe_line(painter, s_end, width) {
    const indices = Report.indices(s_end);
    for (let k = 1; k < indices.length; ++k) {
      const a = point(indices[k - 1]);
      const b = point(indices[k]);
      const layer = a[2] + b[2] < 0 ? kLayer.under : kLayer.things;
      painter.line(layer, [a, b], `stroke="${stress_colour(st.von_mises[indices[k]] * Report.unit('Pa').factor)}" stroke-width="${width}" stroke-linecap="round"`, 1e5);
    }
    const shadow = indices.map((i) => { const p = point(i); return [p[0], p[1], Report.bed(p[0])]; });
    painter.line(kLayer.bed, shadow, 'stroke="#a08f68" stroke-width="1.2" stroke-dasharray="5 3"', 2e6);
  }

  function all_rollers(painter, layer, boxes) {
    for (const box of boxes) for (const row of box.rows) for (const r of row.rollers) roller(painter, layer, r);
  }

  Report.whole_scene = function (camera) {
    const painter = new Report.Painter(camera);
    const indices = Report.indices(data.whole_end);
    const bow = Report.hull_corner(1, 0, 1, 0, 0)[0];
    const x1 = d3.max(indices, (i) => st.x[i]);
    const wide = Math.max(0.7 * data.vessel.beam, 1.4 * d3.max(indices, (i) => Math.abs(st.y[i])), 0.06 * (x1 - bow));
    sea(painter, bow - 10, x1 + 5, wide);
    hull(painter, 0.35);
    for (const on of [false, true]) {
      const boxes = data.supports.filter((b) => b.stinger === on);
      if (boxes.length === 0) continue;
      for (const side of [-0.8, 0.8]) {
        const rail = boxes.flatMap((b) => [-0.5, 0.5].map((k) => hand(add(Report.below_box(b, k * b.length, 0.4), [0, side, 0]))));
        painter.line(on ? kLayer.under : kLayer.things, rail, 'stroke="#55636f" stroke-width="1.6"');
      }
    }
    for (const box of data.supports) for (const row of box.rows) for (const r of row.rollers) roller(painter, r.p[2] < 0 ? kLayer.under : kLayer.things, r);
    pipe_line(painter, data.whole_end, 3);
    const touch = hand(data.touchdown.p);
    painter.text(touch, 'touchdown', 0, -36);
    painter.text(hand(data.tensioner), 'tensioner', 24, -46);
    painter.text(hand(Report.hull_corner(1, 0, 1, 0, data.vessel.depth - data.vessel.draught)), data.vessel.name, -6, -20);
    if (data.supports.some((b) => b.stinger)) painter.text(hand(data.tip.p), 'stinger', 50, -52);
    const fit = [];
    for (const x of [bow - 10, x1 + 5]) for (const y of [-wide, wide]) fit.push([x, y, Report.bed(x)], [x, y, 0]);
    fit.push(hand(Report.hull_corner(1, 1, 1, 0, data.vessel.depth - data.vessel.draught)));
    return { painter, fit };
  };

  Report.overbend_scene = function (camera, boxes, before, after) {
    const painter = new Report.Painter(camera);
    const s0 = Math.max(0, d3.min(boxes, (b) => b.s - b.length / 2) - before);
    const s1 = Math.min(data.whole_end, d3.max(boxes, (b) => b.s + b.length / 2) + after);
    if (boxes.length === data.supports.length) {
      const v = data.vessel;
      hull_box(painter, -v.draught, v.depth - v.draught, [kLayer.behind, kLayer.before], 0.1);
    }
    structure(painter, kLayer.things, boxes.length === data.supports.length ? 1.1 : 1.8, boxes);
    all_rollers(painter, kLayer.things, boxes);
    pipe_body(painter, kLayer.things, s0, s1);
    for (const box of boxes) painter.text(hand(box.p), box.name, -12, 44, 'end', true);
    const fit = boxes.flatMap((b) => [hand(add(b.p, [-b.length / 2, 1.5, -1])), hand(add(b.p, [b.length / 2, -1.5, 1.5]))]);
    for (const s of [s0, s1]) fit.push(hand(['x', 'y', 'z'].map((c) => Report.at(c, s))));
    return { painter, fit };
  };

  Report.stress_colour = stress_colour;
})();
