// The tensioner off, controlled and constant: histories of tension and travel in one diagram.
'use strict';
(function () {
  const data = Report.data.comparison;
  if (!data || data.of !== 'tensioner') return;
  const { build_up, duration, close_from, range, limit, runs } = data;
  const { time_unit, band, build_up_shade, shade, level_line } = Report.in_time(build_up, duration);
  const looks = {
    off: { colour: '#d08a2e', width: 1.6 },
    controlled: { colour: Report.colours.pipe, width: 1.8 },
    constant: { colour: '#1b2733', width: 1.1, dash: '5 3' },
  };
  const states = [
    { text: 'holds', colour: '#dfe5ea' }, { text: 'delay', colour: '#f0c24b' }, { text: 'pays out', colour: '#3c9d6b' },
    { text: 'hauls in', colour: '#8a5bb0' }, { text: 'at limit', colour: Report.colours.accent },
  ];
  const kStrip = 14;  // height of the strip of states

  function bounds_of(kind, close) {
    const of_run = (run) => {
      if (close) return d3.extent(run.close[kind]);
      const history = run[kind];
      return [history.lowest, history.lowest + 4095 * history.quantum];
    };
    const all = runs.flatMap(of_run);
    if (kind === 'tension' && range) all.push(...range);
    if (kind === 'travel') all.push(0);
    return d3.extent(all);
  }

  function shade_range(frame) {
    if (!range) return;
    shade(frame, range);
    for (const bound of range) level_line(frame, bound, '#5fa37f', null, 0.9);
  }

  // Whether it comes into view.
  function mark_limit(frame) {
    const [lo, hi] = frame.y.domain();
    const seen = [-limit, limit].filter((end) => limit && end > lo && end < hi);
    for (const end of seen) level_line(frame, end, Report.colours.accent, '2 3', 1.2);
    return seen.length > 0;
  }

  // What the controlled one did, below the curves.
  function strip(frame) {
    const run = runs.find((one) => one.name === 'controlled');
    if (!run) return [];
    const seen = new Set();
    const [first, last] = frame.x.domain().map((t) => t * time_unit.seconds);
    const top = frame.height - frame.margin.bottom - kStrip;
    for (const [from, to, state] of run.states) {
      if (to <= first || from >= last) continue;
      seen.add(state);
      const x0 = frame.x(Math.max(from, first) / time_unit.seconds);
      const x1 = frame.x(Math.min(to, last) / time_unit.seconds);
      frame.plot.append('rect').attr('x', x0).attr('width', x1 - x0).attr('y', top).attr('height', kStrip).attr('fill', states[state].colour)
        .append('title').text(`${states[state].text}: ${Report.fixed(from, 1)} to ${Report.fixed(to, 1)} s`);
    }
    frame.over.append('line').attr('x1', frame.margin.left).attr('x2', frame.width - frame.margin.right).attr('y1', top).attr('y2', top).attr('stroke', '#8794a0');
    return states.filter((_, state) => seen.has(state)).map((one) => ({ ...one, block: true, edge: '#8794a0' }));
  }

  function curve(frame, run, kind, close) {
    const look = looks[run.name];
    if (!close && !look.dash) { band(frame, run[kind], { line: look.colour, area: look.colour }); return; }
    const history = run[kind];
    const count = history.low.length;
    const at = (k) => (-build_up + (k + 0.5) * (duration + build_up) / count) / time_unit.seconds;
    const middle = (k) => history.lowest + history.quantum * 0.5 * (history.low[k] + history.high[k]);
    const points = close ? run.close.time.map((t, k) => [t / time_unit.seconds, run.close[kind][k]])
                         : d3.range(count).map((k) => [at(k), middle(k)]);
    frame.plot.append('path').attr('d', d3.line().x((p) => frame.x(p[0])).y((p) => frame.y(p[1]))(points)).attr('fill', 'none')
      .attr('stroke', look.colour).attr('stroke-width', look.width).attr('stroke-dasharray', look.dash || null).attr('stroke-linejoin', 'round');
  }

  const axes = { tension: `Tension [${Report.unit('N').name}]`, travel: `Travel, positive when paid out [${Report.unit('m').name}]` };

  Report.compared_tensioner = function (panel, part) {
    const [kind, view] = part.split('_');
    const close = view === 'close';
    const [lo, hi] = bounds_of(kind, close);
    const room = 0.07 * (hi - lo || 1);
    const height = 380;
    const below = room + (hi - lo + 2 * room) * kStrip / (height - 130);  // the strip stands there
    const bounded = kind === 'travel' && limit ? `; limit ${Report.fixed(limit, 2)} ${Report.unit('m').name} either way` : '';
    const frame = Report.frame(panel, {
      height, lane: 22, y: [lo - below, hi + room], x: [close ? close_from : -build_up, duration].map((t) => t / time_unit.seconds),
      title: (close ? `From ${Report.fixed(close_from, 0)} s to the end` : 'Whole run') + bounded, x_label: `Time from the end of the build-up [${time_unit.name}]`, y_label: axes[kind],
    });
    if (!close) build_up_shade(frame);
    if (kind === 'tension') shade_range(frame);
    for (const run of runs) curve(frame, run, kind, close);
    const entries = runs.map((run) => ({ text: run.name, ...looks[run.name] }));
    if (kind === 'tension' && range) entries.push({ text: 'operational range', colour: '#cfe8cf', block: true, edge: '#5fa37f' });
    if (kind === 'travel' && mark_limit(frame)) entries.push({ text: 'limit', colour: Report.colours.accent, dash: '2 3' });
    Report.legend(frame, entries);
    Report.legend(frame, strip(frame), 22);
    frame.over.append('text').attr('class', 'soft').attr('x', frame.margin.left).attr('y', 42).text('Strip below: state of the controlled tensioner');
  };
})();
