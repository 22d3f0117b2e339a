// Along the pipe: what diagrams of tension, moment, stress and strain share.
'use strict';
(function () {
  const data = Report.data;
  const st = data.stations;
  const colours = Report.colours;

  // Room for the names of the boxes, written aslant above the plot.
  const kSlant = 50;
  const shortened = Report.shortened;
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
      if (overbend && middle - named > 17) {
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

  // points: [distance from the tensioner, value]
  function curve(frame, points, colour, dash, width) {
    const pixels = points.map(([s, value]) => [frame.x(s), frame.y(value)]);
    frame.plot.append('path').attr('d', d3.line()(pixels)).attr('fill', 'none').attr('stroke', colour).attr('stroke-width', width)
      .attr('stroke-linejoin', 'round').attr('stroke-dasharray', dash || null);
    Report.keep_clear(frame, pixels);
  }

  function yield_line(frame, kind, indices, hi) {
    const lowest = d3.min(indices, (i) => st.yield_stress[i]) * kind.factor;
    if (!(lowest > 0)) return;
    // A second scale in percent of yield, where one steel is all there is.
    if (d3.max(indices, (i) => st.yield_stress[i]) * kind.factor === lowest) {
      const percent = d3.scaleLinear([0, 100 * hi / lowest], [frame.y(0), frame.y(hi)]);
      frame.svg.append('g').attr('transform', `translate(${frame.width - frame.margin.right},0)`)
        .call(d3.axisRight(percent).ticks(5).tickSizeOuter(0));
      frame.svg.append('text').attr('class', 'soft').attr('text-anchor', 'middle')
        .attr('transform', `translate(${frame.width - 12},${frame.margin.top + frame.inner_height / 2}) rotate(-90)`).text('% of yield stress');
    }
    curve(frame, indices.map((i) => [st.s[i], st.yield_stress[i] * kind.factor]), colours.accent, '8 4', 1.3);
    if (lowest <= frame.y.domain()[1]) level_name(frame, lowest, `yield ${Report.fixed(lowest, 0)} ${kind.unit}`);
  }

  // The name of a level, at the end of its line and right above it.
  function level_name(frame, value, text) {
    const x = frame.width - frame.margin.right - 5;
    const y = frame.y(value) - 5;
    frame.over.append('text').attr('class', 'soft halo level').attr('text-anchor', 'end').attr('x', x).attr('y', y).style('fill', colours.accent).text(text);
    frame.used.push({ x0: x - Report.text_width(frame, text, 'soft') - 4, x1: x + 4, y0: y - 14, y1: y + 4 });
  }

  // What stands under the pointer; words(s) tells it.
  function hover(frame, end, words) {
    const group = frame.svg.append('g').attr('display', 'none').attr('pointer-events', 'none');
    group.append('line').attr('y1', frame.margin.top).attr('y2', frame.height - frame.margin.bottom).attr('stroke', colours.soft);
    const text = group.append('text').attr('class', 'halo').attr('y', frame.margin.top + 14);
    frame.svg.on('pointermove', (event) => {
      const s = frame.x.invert(d3.pointer(event)[0]);
      if (s < 0 || s > end) { group.attr('display', 'none'); return; }
      const px = frame.x(s);
      const right = px > 0.6 * frame.width;
      group.attr('display', null);
      group.select('line').attr('x1', px).attr('x2', px);
      text.attr('x', px + (right ? -8 : 8)).attr('text-anchor', right ? 'end' : 'start')
        .text(words(s));
    }).on('pointerleave', () => group.attr('display', 'none'));
  }

  // The range of values and the frame that holds them, bands of the boxes behind. `indices` are of data.stations.
  function frame_of(panel, kind, part, lo, hi, indices, title, above_yield = 1) {
    const overbend = part === 'overbend';
    const end = overbend ? data.overbend_end : data.whole_end;
    if (kind.zero) { lo = Math.min(lo, 0); hi = Math.max(hi, 0); }
    const yield_stress = kind.yield ? d3.max(indices, (i) => st.yield_stress[i]) * kind.factor : 0;
    if (yield_stress > 0 && hi > 0.5 * yield_stress) hi = Math.max(hi, yield_stress);
    const room = 0.1 * (hi - lo || 1);
    const range = [lo < 0 || !kind.zero ? lo - room : lo, hi + (hi === yield_stress ? above_yield : 2) * room];  // labels stand above the curve
    const frame = Report.frame(panel, {
      height: 284, x: [0, end], y: range, right: kind.yield ? 74 : 24, lane: overbend ? lane() : 0, title,
      x_label: 'Distance along the pipe from the tensioner', x_si: 'm', y_label: `${kind.axis || kind.name} [${kind.unit}]`, y_digits: kind.digits,
    });
    furniture(frame, overbend);
    if (lo < 0) frame.plot.append('line').attr('x1', frame.x(0)).attr('x2', frame.x(end)).attr('y1', frame.y(0)).attr('y2', frame.y(0)).attr('stroke', '#8794a0');
    return { frame, range, end, overbend };
  }

  Report.along = { frame_of, curve, touchdown, yield_line, level_name, hover };
})();
