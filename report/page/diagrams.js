// Diagrams along the pipe: tension, moment, stress, strain.
'use strict';
(function () {
  const data = Report.data;
  const st = data.stations;
  const colours = Report.colours;

  const kinds = {
    tension: { key: 'tension', extreme: 'tension', factor: 1e-3, unit: 'kN', digits: 1, name: 'Effective tension', axis: 'Tension', zero: true,
               more: [{ key: 'wall', name: 'wall tension', colour: colours.second, dash: '6 4' }], own: 'effective tension' },
    moment: { key: 'moment', extreme: 'moment', factor: 1e-3, unit: 'kN m', digits: 1, name: 'Bending moment', zero: true, own: 'magnitude',
              more: [{ key: 'vertical_moment', name: 'vertical part, sagging +', colour: colours.third, dash: '9 3' },
                     { key: 'lateral_moment', name: 'lateral part, to port +', colour: colours.second, dash: '5 3', mark: 'lateral' }] },
    bending: { key: 'bending', extreme: 'bending', factor: 1e-6, unit: 'MPa', digits: 1, name: 'Bending stress', zero: true, yield: true },
    mises: { key: 'mises', extreme: 'mises', factor: 1e-6, unit: 'MPa', digits: 1, name: 'von Mises stress', zero: true, yield: true },
    strain: { key: 'strain', extreme: 'strain', factor: 100, unit: '%', digits: 4, name: 'Strain', zero: true },
  };

  // Room for the names of the boxes, written aslant above the plot.
  const kSlant = 50;
  const shortened = (name) => (name.length > 16 ? name.slice(0, 15) + '\u2026' : name);
  function lane() {
    const letters = d3.max(data.supports, (box) => shortened(box.name).length) || 0;
    return letters > 0 ? Math.ceil(6.8 * letters * Math.sin(kSlant * Math.PI / 180)) + 8 : 0;
  }

  // Boxes as grey bands with their names.
  function furniture(frame, overbend) {
    const top = frame.margin.top;
    const bottom = frame.height - frame.margin.bottom;
    let named = -1e9;
    for (const box of data.supports) {
      const x0 = frame.x(box.s - box.length / 2);
      const x1 = frame.x(box.s + box.length / 2);
      frame.back.append('rect').attr('class', 'support').attr('x', x0).attr('y', top).attr('width', x1 - x0).attr('height', bottom - top);
      const middle = (x0 + x1) / 2;
      if (overbend && middle - named > 15) {
        named = middle;
        frame.over.append('text').attr('class', 'soft').attr('transform', `translate(${middle + 3},${top - 5}) rotate(${-kSlant})`)
          .style('font-size', '12.5px').text(shortened(box.name));
      }
    }
  }

  // A line with its name upright beside it, where no curve runs: called after the curves.
  function touchdown(frame, end) {
    if (data.touchdown.s > end) return;
    const top = frame.margin.top;
    const bottom = frame.height - frame.margin.bottom;
    const x = frame.x(data.touchdown.s);
    frame.over.append('line').attr('x1', x).attr('x2', x).attr('y1', top).attr('y2', bottom).attr('stroke', colours.soft).attr('stroke-dasharray', '2 3');
    const long = 66;
    const places = d3.range(top + 4, bottom - long - 3, 12).flatMap((y) => [-5, 14].map((dx) => ({ dx, x0: x + dx - 13, x1: x + dx + 3, y0: y, y1: y + long })));
    const clear = (b) => frame.used.every((u) => b.x1 < u.x0 || b.x0 > u.x1 || b.y1 < u.y0 || b.y0 > u.y1);
    const place = places.find(clear) || places[0];
    frame.used.push(place);
    frame.over.append('text').attr('class', 'soft').attr('transform', `translate(${x + place.dx},${place.y1}) rotate(-90)`).style('font-size', '12.5px').text('touchdown');
  }

  function curve(frame, indices, values, colour, dash, width) {
    const line = d3.line().x((i) => frame.x(st.s[i])).y((i) => frame.y(values(i)));
    frame.plot.append('path').attr('d', line(indices)).attr('fill', 'none').attr('stroke', colour).attr('stroke-width', width)
      .attr('stroke-linejoin', 'round').attr('stroke-dasharray', dash || null);
    Report.keep_clear(frame, indices.map((i) => [frame.x(st.s[i]), frame.y(values(i))]));
  }

  function yield_line(frame, kind, indices, hi) {
    const lowest = d3.min(indices, (i) => st.yield[i]) * kind.factor;
    if (!(lowest > 0)) return;
    // A second scale in percent of yield, where one steel is all there is.
    if (d3.max(indices, (i) => st.yield[i]) * kind.factor === lowest) {
      const percent = d3.scaleLinear([0, 100 * hi / lowest], [frame.y(0), frame.y(hi)]);
      frame.svg.append('g').attr('transform', `translate(${frame.width - frame.margin.right},0)`)
        .call(d3.axisRight(percent).ticks(5).tickSizeOuter(0));
      frame.svg.append('text').attr('class', 'soft').attr('text-anchor', 'middle')
        .attr('transform', `translate(${frame.width - 12},${frame.margin.top + frame.inner_height / 2}) rotate(-90)`).text('% of yield stress');
    }
    curve(frame, indices, (i) => st.yield[i] * kind.factor, colours.accent, '8 4', 1.3);
    Report.label(frame, frame.margin.left + 0.68 * frame.inner_width, frame.y(lowest), `yield ${Report.fixed(lowest, 0)} MPa`, { fill: colours.accent, css: 'soft', below: true });
  }

  // The extremes of the regions that lie in the range.
  function marks(frame, kind, end) {
    const tension = kind.key === 'tension';
    if (tension && data.touchdown.s <= end) {
      const value = Report.at('tension', data.touchdown.s) * kind.factor;
      Report.mark(frame, data.touchdown.s, value, `${Report.fixed(value, 1)} kN at touchdown`, colours.pipe);
    }
    // The tension of the sagbend is largest where it begins, which tells nothing.
    for (const region of tension && data.overbend ? ['overbend'] : ['overbend', 'sagbend']) {
      const extreme = data[region] && data[region][kind.extreme];
      if (!extreme || extreme.s > end) continue;
      const value = extreme.value * kind.factor;
      const text = `${Report.fixed(value, kind.digits)} ${kind.unit} at ${Report.fixed(extreme.s, 1)} m (${extreme.place})`;
      Report.mark(frame, extreme.s, value, text, colours.pipe);
    }
  }

  // The largest of the other curves that ask for it, where it is more than a trifle of the first.
  function more_marks(frame, kind, indices) {
    for (const more of (kind.more || []).filter((m) => m.mark)) {
      const far = d3.greatest(indices, (i) => Math.abs(st[more.key][i]));
      if (Math.abs(st[more.key][far]) < 0.1 * d3.max(indices, (i) => st[kind.key][i])) continue;
      const value = st[more.key][far] * kind.factor;
      Report.mark(frame, st.s[far], value, `${more.mark} ${Report.fixed(value, kind.digits)} ${kind.unit} at ${Report.fixed(st.s[far], 1)} m`, more.colour);
    }
  }

  function hover(frame, kind, indices) {
    const group = frame.svg.append('g').attr('display', 'none').attr('pointer-events', 'none');
    group.append('line').attr('y1', frame.margin.top).attr('y2', frame.height - frame.margin.bottom).attr('stroke', colours.soft);
    const text = group.append('text').attr('class', 'halo').attr('y', frame.margin.top + 14);
    frame.svg.on('pointermove', (event) => {
      const s = frame.x.invert(d3.pointer(event)[0]);
      if (s < st.s[indices[0]] || s > st.s[indices[indices.length - 1]]) { group.attr('display', 'none'); return; }
      const px = frame.x(s);
      const right = px > 0.6 * frame.width;
      group.attr('display', null);
      group.select('line').attr('x1', px).attr('x2', px);
      text.attr('x', px + (right ? -8 : 8)).attr('text-anchor', right ? 'end' : 'start')
        .text(`${Report.fixed(Report.at(kind.key, s) * kind.factor, kind.digits)} ${kind.unit} at ${Report.fixed(s, 1)} m`);
    }).on('pointerleave', () => group.attr('display', 'none'));
  }

  Report.diagram = function (panel, name, part) {
    const kind = kinds[name];
    const overbend = part === 'overbend';
    const end = overbend ? data.overbend_end : data.whole_end;
    const indices = Report.indices(end);
    const curves = [kind.key, ...(kind.more || []).map((m) => m.key)];
    let lo = d3.min(curves, (key) => d3.min(indices, (i) => st[key][i])) * kind.factor;
    let hi = d3.max(curves, (key) => d3.max(indices, (i) => st[key][i])) * kind.factor;
    if (kind.zero) { lo = Math.min(lo, 0); hi = Math.max(hi, 0); }
    const yield_stress = kind.yield ? d3.max(indices, (i) => st.yield[i]) * kind.factor : 0;
    if (yield_stress > 0 && hi > 0.5 * yield_stress) hi = Math.max(hi, yield_stress);
    const room = 0.1 * (hi - lo || 1);
    const range = [lo < 0 ? lo - room : lo, hi + (hi === yield_stress ? 1 : 2) * room];  // labels stand above the curve
    const frame = Report.frame(panel, {
      height: 284, x: [0, end], y: range, right: kind.yield ? 74 : 24, lane: overbend ? lane() : 0,
      title: `${kind.name}, ${overbend ? 'overbend' : 'whole line'}`,
      x_label: 'Distance along the pipe from the tensioner [m]', y_label: `${kind.axis || kind.name} [${kind.unit}]`,
    });
    furniture(frame, overbend);
    if (lo < 0) frame.plot.append('line').attr('x1', frame.x(0)).attr('x2', frame.x(end)).attr('y1', frame.y(0)).attr('y2', frame.y(0)).attr('stroke', '#8794a0');
    for (const more of kind.more || []) curve(frame, indices, (i) => st[more.key][i] * kind.factor, more.colour, more.dash, 1.6);
    curve(frame, indices, (i) => st[kind.key][i] * kind.factor, colours.pipe, null, 2.2);
    if (kind.yield) yield_line(frame, kind, indices, range[1]);
    if (kind.more) Report.legend(frame, [{ text: kind.own, colour: colours.pipe }, ...kind.more.map((m) => ({ text: m.name, colour: m.colour, dash: m.dash }))]);
    if (!overbend) touchdown(frame, end);
    marks(frame, kind, end);
    more_marks(frame, kind, indices);
    hover(frame, kind, indices);
  };
})();
