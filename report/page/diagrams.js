// Diagrams along the pipe: tension, moment, stress, strain.
'use strict';
(function () {
  const data = Report.data;
  const st = data.stations;
  const colours = Report.colours;
  const along = Report.along;

  const kinds = {
    tension: { key: 'effective_tension', name: 'Effective tension', axis: 'Tension',
               more: [{ key: 'wall_tension', name: 'wall tension', colour: colours.second, dash: '6 4' }], own: 'effective tension' },
    moment: { key: 'bending_moment', name: 'Bending moment', zero: true, own: 'magnitude',
              more: [{ key: 'vertical_moment', name: 'vertical part, sagging +', colour: colours.third, dash: '9 3' },
                     { key: 'lateral_moment', name: 'lateral part, to port +', colour: colours.second, dash: '5 3', mark: 'lateral' }] },
    bending: { key: 'bending_stress', name: 'Bending stress', zero: true, yield: true },
    mises: { key: 'von_mises', name: 'von Mises stress', zero: true, yield: true },
    strain: { key: 'strain', name: 'Strain', zero: true },
  };

  for (const kind of Object.values(kinds)) Object.assign(kind, data.shown[kind.key]);  // unit, factor, digits

  // The extremes of the regions that lie in the range.
  function marks(frame, kind, end) {
    const tension = kind.key === 'effective_tension';
    if (tension && data.touchdown.s <= end) {
      const value = Report.at('effective_tension', data.touchdown.s) * kind.factor;
      Report.mark(frame, data.touchdown.s, value, `${Report.shown(Report.at('effective_tension', data.touchdown.s), 'N', 1)} at touchdown`, colours.pipe);
    }
    // The tension of the sagbend is largest where it begins, which tells nothing.
    for (const region of tension && data.overbend ? ['overbend'] : ['overbend', 'tower', 'sagbend']) {
      const extreme = data[region] && data[region][kind.key];
      if (!extreme || extreme.s > end) continue;
      const value = extreme.value * kind.factor;
      const text = `${Report.fixed(value, kind.digits)} ${kind.unit} at ${Report.shown(extreme.s, 'm', 1)} (${extreme.place})`;
      Report.mark(frame, extreme.s, value, text, colours.pipe);
    }
  }

  // The largest of the other curves that ask for it, where it is more than a trifle of the first.
  function more_marks(frame, kind, indices) {
    for (const more of (kind.more || []).filter((m) => m.mark)) {
      const far = d3.greatest(indices, (i) => Math.abs(st[more.key][i]));
      if (Math.abs(st[more.key][far]) < 0.1 * d3.max(indices, (i) => st[kind.key][i])) continue;
      const value = st[more.key][far] * kind.factor;
      Report.mark(frame, st.s[far], value, `${more.mark} ${Report.fixed(value, kind.digits)} ${kind.unit} at ${Report.shown(st.s[far], 'm', 1)}`, more.colour);
    }
  }

  Report.diagram = function (panel, name, part) {
    const kind = kinds[name];
    const indices = Report.indices(part === 'overbend' ? data.overbend_end : data.whole_end);
    const curves = [kind.key, ...(kind.more || []).map((m) => m.key)];
    const lo = d3.min(curves, (key) => d3.min(indices, (i) => st[key][i])) * kind.factor;
    const hi = d3.max(curves, (key) => d3.max(indices, (i) => st[key][i])) * kind.factor;
    const { frame, range, end, overbend } = along.frame_of(panel, kind, part, lo, hi, indices, `${kind.name}, ${part === 'overbend' ? 'overbend' : 'whole line'}`);
    const points = (key) => indices.map((i) => [st.s[i], st[key][i] * kind.factor]);
    for (const more of kind.more || []) along.curve(frame, points(more.key), more.colour, more.dash, 1.6);
    along.curve(frame, points(kind.key), colours.pipe, null, 2.2);
    if (kind.yield) along.yield_line(frame, kind, indices, range[1]);
    if (kind.more) Report.legend(frame, [{ text: kind.own, colour: colours.pipe }, ...kind.more.map((m) => ({ text: m.name, colour: m.colour, dash: m.dash }))]);
    marks(frame, kind, end);
    more_marks(frame, kind, indices);
    if (!overbend) along.touchdown(frame, end);
    along.hover(frame, end, (s) => `${Report.fixed(Report.at(kind.key, s) * kind.factor, kind.digits)} ${kind.unit} at ${Report.shown(s, 'm', 1)}`);
  };
})();
