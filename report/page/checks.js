// How far the code checks are used along the pipe.
'use strict';
(function () {
  const data = Report.data;
  if (!data.checks) return;
  const colours = Report.colours;
  const along = Report.along;
  const checks = data.checks;
  const kinds = [
    { key: 'api', name: 'API RP 1111', colour: colours.third, dash: '9 3' },
    { key: 'stress', name: 'stress', colour: colours.second, dash: '5 3' },
    { key: 'load', name: 'DNV load', colour: colours.dynamic },
    { key: 'strain', name: 'DNV strain', colour: colours.pipe },
    { key: 'laying', name: 'laying strain', colour: colours.port, dash: '3 3' },
  ];

  Report.utilisation = function (panel, part) {
    const until = part === 'overbend' ? data.overbend_end : data.whole_end;
    const shown = d3.range(checks.s.length).filter((i) => checks.s[i] <= until + 1e-9);
    const used = kinds.filter((kind) => shown.some((i) => checks[kind.key][i] > 0));
    const most = d3.max(used, (kind) => d3.max(shown, (i) => checks[kind.key][i])) || 0;
    const kind = { name: 'Utilisation', unit: '-', zero: true };
    const title = `Utilisation, ${part === 'overbend' ? 'overbend' : 'whole line'}`;
    const { frame, end, overbend } = along.frame_of(panel, kind, part, 0, Math.max(most, 1), Report.indices(until), title);
    // A check that is not made at a station leaves a gap there.
    for (const { key, colour, dash } of used) {
      let run = [];
      const flush = () => { if (run.length > 1) along.curve(frame, run, colour, dash, 1.9); run = []; };
      for (const i of shown) {
        if (checks[key][i] > 0) run.push([checks.s[i], checks[key][i]]); else flush();
      }
      flush();
    }
    along.curve(frame, [[0, 1], [end, 1]], colours.accent, '8 4', 1.3);
    along.level_name(frame, 1, 'full capacity');
    Report.legend(frame, used.slice().reverse().map((k) => ({ text: k.name, colour: k.colour, dash: k.dash })));
    const worst = d3.greatest(shown, (i) => checks.governing[i]);
    Report.mark(frame, checks.s[worst], checks.governing[worst], `${Report.fixed(checks.governing[worst], 3)} at ${Report.shown(checks.s[worst], 'm', 1)}`, colours.pipe);
    if (!overbend) along.touchdown(frame, end);
    along.hover(frame, end, (s) => {
      const i = Math.min(d3.bisectLeft(checks.s, s), checks.s.length - 1);
      return used.filter((k) => checks[k.key][i] > 0).map((k) => `${k.name} ${Report.fixed(checks[k.key][i], 3)}`).join(', ');
    });
  };
})();
