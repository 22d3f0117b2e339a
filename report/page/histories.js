// Time histories and their spectra.
'use strict';
(function () {
  const data = Report.data;
  if (!data.dynamic) return;
  const colours = Report.colours;
  const { duration, build_up, histories, spectra } = data.dynamic;
  const kHalf = 480;

  const unit_of = (q) => (q.unit ? ` [${q.unit}]` : '');

  const { time_unit, band, build_up_shade, shade, level_line } = Report.in_time(build_up, duration);

  function statistics(history) {
    const spread = history.over_time;
    const text = (value) => Report.fixed(value, history.digits);
    return `${text(spread.min)} to ${text(spread.max)}, mean ${text(spread.mean)}, std ${text(spread.std)}`;
  }

  // As much of the statistics as finds room.
  function small_title(history) {
    const head = `${history.title}${unit_of(history)}`;
    const text = (value) => Report.fixed(value, history.digits);
    const spread = history.over_time;
    const all = [`${head}: ${statistics(history)}`, `${head}: ${text(spread.min)} to ${text(spread.max)}, std ${text(spread.std)}`, `${head}: ${text(spread.min)} to ${text(spread.max)}`];
    return all.find((words) => Report.measured(words, 15) < kHalf - 62) || head;
  }

  function draw(panel, history, small) {
    const top = history.lowest + 4095 * history.quantum;
    let lo = history.lowest;
    let hi = top;
    if (history.shade) { lo = Math.min(lo, history.shade[0]); hi = Math.max(hi, history.shade[1]); }
    if (history.static !== null) { lo = Math.min(lo, history.static); hi = Math.max(hi, history.static); }
    const room = 0.08 * (hi - lo);
    const title = small ? small_title(history) : `${history.title}: ${statistics(history)}${history.unit ? ' ' + history.unit : ''}`;
    const frame = Report.frame(panel, {
      width: small ? kHalf : undefined, height: small ? 190 : 250, left: small ? 62 : 78, x: [-build_up / time_unit.seconds, duration / time_unit.seconds], y: [lo - room, hi + room], y_digits: history.digits, x_ticks: small ? 6 : 10,
      title, x_label: `Time from the end of the build-up [${time_unit.name}]`, y_label: small ? '' : unit_of(history).trim(),
    });
    frame.svg.classed('small', small);
    build_up_shade(frame);
    if (history.shade) shade(frame, history.shade);
    const line = band(frame, history, { line: colours.dynamic, area: colours.history });
    if (history.slow) band(frame, history.slow, { line: colours.second, area: colours.second });
    if (history.static !== null) {
      if (!line) level_line(frame, history.static, '#fff', null, 3.5);
      level_line(frame, history.static, colours.accent, '7 4');
      if (!small) Report.legend(frame, [...(history.slow ? [{ text: 'slow part', colour: colours.second }] : []), { text: `static ${Report.fixed(history.static, history.digits)}`, colour: colours.accent, dash: '7 4' }]);
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
