// What diagrams over time share.
'use strict';
(function () {
  // [s]; the build-up ends at 0.
  Report.in_time = function (build_up, duration) {
    // Minutes where seconds would be long numbers.
    const time_unit = duration > 7200 ? { name: 'min', seconds: 60 } : { name: 's', seconds: 1 };

    // Whether it is drawn as a line is what it tells. colours: {line, area}
    function band(frame, history, colours) {
      const count = history.low.length;
      const time = (k) => (-build_up + (k + 0.5) * (duration + build_up) / count) / time_unit.seconds;
      const value = (level) => history.lowest + history.quantum * level;
      const area = d3.area().defined((k) => history.low[k] !== null && history.high[k] !== null)
        .x((k) => frame.x(time(k))).y0((k) => frame.y(value(history.low[k]))).y1((k) => frame.y(value(history.high[k])));
      // Where each stretch is hardly more than a point the band is a line, and is drawn as one.
      const all = d3.range(count);
      const line = d3.median(all.filter((k) => history.low[k] !== null), (k) => history.high[k] - history.low[k]) < 60;
      const colour = line ? colours.line : colours.area;
      frame.plot.append('path').attr('d', area(all)).attr('fill', colour).attr('stroke', colour).attr('stroke-width', line ? 1.4 : 0.9).attr('stroke-linejoin', 'round');
      return line;
    }

    function build_up_shade(frame) {
      if (build_up <= 0) return;
      const x0 = frame.x(-build_up / time_unit.seconds);
      const x1 = frame.x(0);
      frame.back.append('rect').attr('x', x0).attr('width', x1 - x0).attr('y', frame.margin.top).attr('height', frame.inner_height).attr('fill', '#eceff2');
      frame.over.append('line').attr('x1', x1).attr('x2', x1).attr('y1', frame.margin.top).attr('y2', frame.height - frame.margin.bottom).attr('stroke', Report.colours.soft).attr('stroke-dasharray', '2 3');
    }

    // A range of values.
    function shade(frame, [low, high]) {
      frame.back.append('rect').attr('x', frame.margin.left).attr('width', frame.inner_width)
        .attr('y', frame.y(high)).attr('height', frame.y(low) - frame.y(high)).attr('fill', '#cfe8cf');
    }

    function level_line(frame, value, colour, dash, width = 1.5) {
      frame.plot.append('line').attr('x1', frame.margin.left).attr('x2', frame.width - frame.margin.right).attr('y1', frame.y(value)).attr('y2', frame.y(value))
        .attr('stroke', colour).attr('stroke-width', width).attr('stroke-dasharray', dash);
    }

    return { time_unit, band, build_up_shade, shade, level_line };
  };
})();
