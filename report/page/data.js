// The results of this page, and what is known of each diagram. Everything hangs on one name.
'use strict';
var Report = {};
(function () {
  const data = JSON.parse(document.getElementById('results-data').textContent);
  Report.data = data;

  // Of a model with a pipe.
  if (data.stations) {
    const st = data.stations;
    st.count = st.s.length;

    // The overbend: from the tensioner to a little beyond the last box, so that the pipe is seen leaving.
    if (data.supports.length > 0) {
      const last = data.supports[data.supports.length - 1];
      const reach = Math.max(...data.supports.map((b) => b.s + b.length / 2));
      data.overbend_end = Math.min(st.s[st.count - 1], reach + Math.max(5, 0.12 * reach));
      data.tip = last;
    }

    // The pipe laid on the seabed is the same all along; show enough of it to see that.
    const spans = data.bed ? data.bed.spans.filter((span) => span.largest_gap > 0.05) : [];
    const spanned = spans.length > 0 ? spans[spans.length - 1].s_to + 20 - data.touchdown.s : 0;
    const beyond = Math.max(30, 0.15 * data.touchdown.s, spanned);
    data.whole_end = Math.min(st.s[st.count - 1], data.touchdown.s + beyond);

    Report.indices = function (s_end) {
      return d3.range(st.count).filter((i) => st.s[i] <= s_end + 1e-9);
    };

    // Linear between stations.
    Report.at = function (column, s) {
      const i = Math.min(Math.max(d3.bisectLeft(st.s, s), 1), st.count - 1);
      const t = (s - st.s[i - 1]) / (st.s[i] - st.s[i - 1] || 1);
      return st[column][i - 1] + Math.min(Math.max(t, 0), 1) * (st[column][i] - st[column][i - 1]);
    };
  }

  // Units that people read, by the SI unit: {name, factor, more}; `section`: lengths of a cross-section and gaps.
  const units = JSON.parse(document.getElementById('shown-units').textContent);
  Report.unit = (si) => units[si];

  // A value [SI] as it is shown; `digits`: the decimals of metric values.
  Report.number = (value, si, digits) => Report.fixed(value * units[si].factor, Math.max(0, digits + units[si].more));
  Report.shown = (value, si, digits) => `${Report.number(value, si, digits)} ${units[si].name}`;

  // A box's name where room is short.
  Report.shortened = (name) => (name.length > 16 ? name.slice(0, 15) + '\u2026' : name);

  // Number as in the tables: fixed decimals and never "-0".
  Report.fixed = function (value, digits) {
    const text = value.toFixed(digits);
    return Number(text) === 0 ? (0).toFixed(digits) : text;
  };

  Report.colours = { pipe: '#0b5394', accent: '#b3261e', second: '#c77700', third: '#009e73', dynamic: '#6a3d9a', band: '#d9cce6', history: '#9c7fc4', port: '#d55e00', steel: '#7b8794', soft: '#5b6b7a' };
})();
