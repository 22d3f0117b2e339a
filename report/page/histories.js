// Quantities in time and their spectra.
'use strict';
(function () {
  const data = Report.data;
  if (!data.dynamic) return;
  const colours = Report.colours;
  const { duration, build_up, histories, spectra } = data.dynamic;
  const kHalf = 480;

  const unit_of = (q) => (q.unit ? ` [${q.unit}]` : '');

  // Hours and minutes where seconds would be long numbers.
  const time_unit = duration > 7200 ? { name: 'min', seconds: 60 } : { name: 's', seconds: 1 };

  // Whether it is drawn as a line is what it tells.
  function band(frame, history) {
    const count = history.low.length;
    const time = (k) => (-build_up + (k + 0.5) * (duration + build_up) / count) / time_unit.seconds;
    const value = (level) => history.lowest + history.quantum * level;
    const area = d3.area().defined((k) => history.low[k] !== null && history.high[k] !== null)
      .x((k) => frame.x(time(k))).y0((k) => frame.y(value(history.low[k]))).y1((k) => frame.y(value(history.high[k])));
    // Where each stretch is hardly more than a point the band is a line, and is drawn as one.
    const all = d3.range(count);
    const line = d3.median(all, (k) => history.high[k] - history.low[k]) < 60;
    const colour = line ? colours.dynamic : colours.history;
    frame.plot.append('path').attr('d', area(all)).attr('fill', colour).attr('stroke', colour).attr('stroke-width', line ? 1.4 : 0.9).attr('stroke-linejoin', 'round');
    return line;
  }

  function build_up_shade(frame) {
    if (build_up <= 0) return;
    const x0 = frame.x(-build_up / time_unit.seconds);
    const x1 = frame.x(0);
    frame.back.append('rect').attr('x', x0).attr('width', x1 - x0).attr('y', frame.margin.top).attr('height', frame.inner_height).attr('fill', '#eceff2');
    frame.over.append('line').attr('x1', x1).attr('x2', x1).attr('y1', frame.margin.top).attr('y2', frame.height - frame.margin.bottom).attr('stroke', colours.soft).attr('stroke-dasharray', '2 3');
  }

  function level_line(frame, value, colour, dash, width = 1.5) {
    frame.plot.append('line').attr('x1', frame.margin.left).attr('x2', frame.width - frame.margin.right).attr('y1', frame.y(value)).attr('y2', frame.y(value))
      .attr('stroke', colour).attr('stroke-width', width).attr('stroke-dasharray', dash);
  }

  function statistics(history) {
    const spread = history.over_time;
    const text = (value) => Report.fixed(value, history.digits);
    return `${text(spread.min)} to ${text(spread.max)}, mean ${text(spread.mean)}, std ${text(spread.std)}`;
  }

  function draw(panel, history, small) {
    const top = history.lowest + 4095 * history.quantum;
    let lo = history.lowest;
    let hi = top;
    if (history.shade) { lo = Math.min(lo, history.shade[0]); hi = Math.max(hi, history.shade[1]); }
    if (history.static !== null) { lo = Math.min(lo, history.static); hi = Math.max(hi, history.static); }
    // What moves less than the last digit shown is a level line.
    const least = 10 ** -history.digits;
    const room = 0.08 * (hi - lo) + (hi - lo < least ? least : 0);
    const title = small ? `${history.title}${unit_of(history)}: ${statistics(history)}` : `${history.title}: ${statistics(history)}${history.unit ? ' ' + history.unit : ''}`;
    const frame = Report.frame(panel, {
      width: small ? kHalf : undefined, height: small ? 190 : 250, left: small ? 62 : 78, x: [-build_up / time_unit.seconds, duration / time_unit.seconds], y: [lo - room, hi + room], x_ticks: small ? 6 : 10,
      title, x_label: `Time from the end of the build-up [${time_unit.name}]`, y_label: small ? '' : unit_of(history).trim(),
    });
    frame.svg.classed('small', small);
    build_up_shade(frame);
    if (history.shade) {
      const [low, high] = history.shade;
      frame.back.append('rect').attr('x', frame.margin.left).attr('width', frame.width - frame.margin.left - frame.margin.right)
        .attr('y', frame.y(high)).attr('height', frame.y(low) - frame.y(high)).attr('fill', '#cfe8cf');
    }
    const line = band(frame, history);
    if (history.static !== null) {
      if (!line) level_line(frame, history.static, '#fff', null, 3.5);
      level_line(frame, history.static, colours.accent, '7 4');
      Report.legend(frame, [{ text: `static ${Report.fixed(history.static, history.digits)}`, colour: colours.accent, dash: '7 4' }]);
    }
    if (lo < 0 && hi > 0) frame.back.append('line').attr('x1', frame.margin.left).attr('x2', frame.width - frame.margin.right).attr('y1', frame.y(0)).attr('y2', frame.y(0)).attr('stroke', '#8794a0');
  }

  Report.history = function (panel, group) {
    const small = panel.classList.contains('multiples');
    for (const history of histories.filter((h) => h.group === group)) draw(panel, history, small);
  };

  const kPeriods = [2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 60, 120];

  // Periods on top of a frequency axis, as many as find room.
  function period_axis(frame, end) {
    let last = Infinity;
    const axis = frame.svg.append('g');
    for (const period of kPeriods) {
      const x = frame.x(1 / period);
      if (1 / period > end || x - frame.margin.left < 12 || last - x < 26) continue;
      last = x;
      axis.append('line').attr('x1', x).attr('x2', x).attr('y1', frame.margin.top - 4).attr('y2', frame.margin.top).attr('stroke', '#8794a0');
      axis.append('text').attr('class', 'soft tick-text').attr('x', x).attr('y', frame.margin.top - 7).attr('text-anchor', 'middle').text(period);
    }
    axis.append('text').attr('class', 'soft tick-text').attr('x', frame.margin.left - 8).attr('y', frame.margin.top - 7).attr('text-anchor', 'end').text('T [s]');
  }

  Report.spectra = function (panel) {
    // One frequency scale for all of them, so that they can be laid side by side.
    const end = d3.max(spectra, (q) => q.frequency[q.frequency.length - 1]);
    for (const q of spectra) {
      const peak = d3.greatest(d3.range(q.frequency.length), (i) => q.density[i]);
      const [f, d] = [q.frequency[peak], q.density[peak]];
      const frame = Report.frame(panel, {
        width: kHalf, height: 210, left: 68, lane: 16, x: [0, end], y: [0, 1.12 * d], x_ticks: 6,
        title: `${q.title} [${q.unit ? q.unit + '\u00b2' : '1'}/Hz]${f > 0 ? `, peak at ${Report.fixed(1 / f, 1)} s` : ''}`, x_label: 'Frequency [Hz]', y_label: '',
      });
      frame.svg.classed('small', true);
      const indices = d3.range(q.frequency.length);
      const area = d3.area().x((i) => frame.x(q.frequency[i])).y0(frame.y(0)).y1((i) => frame.y(q.density[i]));
      frame.plot.append('path').attr('d', area(indices)).attr('fill', colours.band);
      frame.plot.append('path').attr('d', area.lineY1()(indices)).attr('fill', 'none').attr('stroke', colours.dynamic).attr('stroke-width', 1.4);
      period_axis(frame, end);
    }
  };
})();
