// What a dynamic run did to the pipe, station by station: least, greatest, mean, and the static value.
'use strict';
(function () {
  const data = Report.data;
  if (!data.dynamic) return;
  const colours = Report.colours;
  const along = Report.along;
  const dynamic = data.dynamic;
  const s = dynamic.envelopes.s;

  const kinds = {
    envelope_tension: { key: 'effective_tension', name: 'Effective tension', axis: 'Tension' },
    envelope_moment: { key: 'bending_moment', name: 'Bending moment', zero: true },
    envelope_mises: { key: 'von_mises', name: 'von Mises stress', zero: true, yield: true },
    envelope_strain: { key: 'strain', name: 'Strain', zero: true },
  };

  for (const kind of Object.values(kinds)) Object.assign(kind, data.shown[kind.key]);  // unit, factor, digits

  function marks(frame, kind, end) {
    for (const region of ['overbend', 'tower', 'sagbend']) {
      const extreme = dynamic[region] && dynamic[region][kind.key];
      if (!extreme || extreme.s > end || extreme.value <= 0) continue;
      const value = extreme.value * kind.factor;
      Report.mark(frame, extreme.s, value, `${Report.fixed(value, kind.digits)} ${kind.unit} at ${Report.shown(extreme.s, 'm', 1)} (${extreme.place}), t = ${Report.fixed(extreme.time, 1)} s`, colours.dynamic);
    }
    if (kind.key !== 'effective_tension') return;
    const envelope = dynamic.envelopes.effective_tension;
    const most = d3.greatest(d3.range(s.length).filter((i) => s[i] <= end), (i) => envelope.max[i]);
    Report.mark(frame, s[most], envelope.max[most] * kind.factor, `${Report.fixed(envelope.max[most] * kind.factor, kind.digits)} ${kind.unit} at ${Report.shown(s[most], 'm', 1)}`, colours.dynamic);
  }

  function value_at(column, at) {
    const i = Math.min(Math.max(d3.bisectLeft(s, at), 1), s.length - 1);
    const t = (at - s[i - 1]) / (s[i] - s[i - 1] || 1);
    return column[i - 1] + Math.min(Math.max(t, 0), 1) * (column[i] - column[i - 1]);
  }

  Report.envelope = function (panel, name, part) {
    const kind = kinds[name];
    const envelope = dynamic.envelopes[kind.key];
    const until = part === 'overbend' ? data.overbend_end : data.whole_end;
    const shown = d3.range(s.length).filter((i) => s[i] <= until + 1e-9);
    const lo = d3.min(shown, (i) => Math.min(envelope.min[i], envelope.static[i])) * kind.factor;
    const hi = d3.max(shown, (i) => Math.max(envelope.max[i], envelope.static[i])) * kind.factor;
    const indices = Report.indices(until);
    const { frame, range, end, overbend } = along.frame_of(panel, kind, part, lo, hi, indices, `${kind.name}, ${part === 'overbend' ? 'overbend' : 'whole line'}`, 2.2);
    const points = (column) => shown.map((i) => [s[i], column[i] * kind.factor]);
    const band = d3.area().x((i) => frame.x(s[i])).y0((i) => frame.y(envelope.min[i] * kind.factor)).y1((i) => frame.y(envelope.max[i] * kind.factor));
    frame.plot.append('path').attr('d', band(shown)).attr('fill', colours.band);
    along.curve(frame, points(envelope.min), colours.dynamic, null, 0.9);
    along.curve(frame, points(envelope.max), colours.dynamic, null, 1.4);
    along.curve(frame, points(envelope.mean), colours.second, '6 3', 1.5);
    along.curve(frame, points(envelope.static), colours.pipe, null, 1.8);
    if (kind.yield) along.yield_line(frame, kind, indices, range[1]);
    Report.legend(frame, [
      { text: 'dynamic, min to max', colour: colours.band, block: true, edge: colours.dynamic },
      { text: 'mean', colour: colours.second, dash: '6 3' },
      { text: 'static', colour: colours.pipe },
    ]);
    marks(frame, kind, end);
    if (!overbend) along.touchdown(frame, end);
    along.hover(frame, end, (at) => {
      const number = (column) => Report.fixed(value_at(column, at) * kind.factor, kind.digits);
      return `${number(envelope.min)} to ${number(envelope.max)} ${kind.unit}, static ${number(envelope.static)}, at ${Report.shown(at, 'm', 1)}`;
    });
  };
  Report.envelope.kinds = kinds;
})();
