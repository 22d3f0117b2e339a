// The path of a goal seek: the result over the key, or, with several keys, over the steps.
'use strict';
(function () {
  const data = Report.data;
  if (!data.seek) return;
  const { keys, goals, path } = data.seek;
  const colours = Report.colours;

  const named = (one) => (one.unit ? `${one.name} [${one.unit}]` : one.name);

  function points(goal) {
    const k = goals.indexOf(goal);
    if (keys.length > 1) return path.map((step, i) => [i + 1, step.results[k] * goal.factor]);
    return path.map((step) => [step.values[0] * keys[0].factor, step.results[k] * goal.factor]).sort((a, b) => a[0] - b[0]);
  }

  // The answer: at its key, or at the last step.
  function answer(goal, all) {
    if (goal.reached === null) return null;
    return [keys.length > 1 ? all.length : keys[0].answer * keys[0].factor, goal.reached * goal.factor];
  }

  Report.seek_path = function (panel, part) {
    const goal = goals[Number(part)];
    const all = points(goal);
    const end = answer(goal, all);
    const wanted = goal.wanted === null ? null : goal.wanted * goal.factor;
    const [x0, x1] = d3.extent(all, (p) => p[0]);
    const [y0, y1] = d3.extent([...all.map((p) => p[1]), ...(wanted === null ? [] : [wanted])]);
    const [wide, tall] = [x1 - x0 || 1, y1 - y0 || 1];
    const frame = Report.frame(panel, { height: 300, x: [x0 - 0.03 * wide, x1 + 0.03 * wide], y: [y0 - 0.12 * tall, y1 + 0.12 * tall],
      x_label: keys.length > 1 ? 'Step of the search' : named(keys[0]), y_label: goal.unit ? `[${goal.unit}]` : '', title: goal.name });
    if (wanted !== null) {
      frame.plot.append('line').attr('x1', frame.margin.left).attr('x2', frame.width - frame.margin.right)
        .attr('y1', frame.y(wanted)).attr('y2', frame.y(wanted)).attr('stroke', colours.accent).attr('stroke-width', 1.4).attr('stroke-dasharray', '7 4');
    }
    const pixels = all.map((p) => [frame.x(p[0]), frame.y(p[1])]);
    frame.plot.append('path').attr('d', d3.line()(pixels)).attr('fill', 'none').attr('stroke', colours.pipe).attr('stroke-width', 1.8);
    frame.plot.append('g').selectAll('circle').data(pixels).join('circle').attr('cx', (p) => p[0]).attr('cy', (p) => p[1]).attr('r', 3).attr('fill', colours.pipe);
    Report.keep_clear(frame, pixels);
    if (end) Report.mark(frame, end[0], end[1], keys.length > 1 ? `${d3.format('.5~g')(end[1])} ${goal.unit}` : `${d3.format('.6~g')(end[0])} ${keys[0].unit}`, colours.accent);
  };
})();
