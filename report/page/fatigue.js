// Damage rate of welds along the pipe.
'use strict';
(function () {
  const data = Report.data;
  const fatigue = data.dynamic && data.dynamic.fatigue;
  if (!fatigue) return;
  const colours = Report.colours;
  const along = Report.along;
  const looks = [
    { colour: colours.pipe }, { colour: colours.second, dash: '5 3' }, { colour: colours.third, dash: '9 3' },
    { colour: colours.port, dash: '3 3' }, { colour: colours.dynamic },
  ];
  const spots = fatigue.spots.map((spot, i) => ({ ...spot, ...looks[i % looks.length] }));
  const words = (rate) => (rate > 0 ? rate.toExponential(2) : '0');

  Report.fatigue = function (panel, part) {
    const until = part === 'overbend' ? data.overbend_end : data.whole_end;
    const shown = d3.range(fatigue.s.length).filter((i) => fatigue.s[i] <= until + 1e-9);
    const most = d3.max(spots, (spot) => d3.max(shown, (i) => spot.rate[i])) || 0;
    // Powers of ten are said once, at the axis.
    const power = most > 0 ? Math.floor(Math.log10(most)) : 0;
    const factor = 10 ** -power;
    const kind = { name: 'Damage per hour', unit: power === 0 ? '-' : `1e${power}`, zero: true };
    const title = `Damage rate, ${part === 'overbend' ? 'overbend' : 'whole line'}`;
    const { frame, end, overbend } = along.frame_of(panel, kind, part, 0, (most || 1) * factor, Report.indices(until), title);
    for (const spot of spots) {
      along.curve(frame, shown.map((i) => [fatigue.s[i], spot.rate[i] * factor]), spot.colour, spot.dash, 1.9);
    }
    Report.legend(frame, spots.map((spot) => ({ text: `${spot.name}, ${spot.curve}`, colour: spot.colour, dash: spot.dash })));
    if (!overbend) along.touchdown(frame, end);
    along.hover(frame, end, (s) => {
      const i = Math.min(d3.bisectLeft(fatigue.s, s), fatigue.s.length - 1);
      return spots.map((spot) => `${spot.name} ${words(spot.rate[i])} per hour`).join(', ');
    });
  };
})();
