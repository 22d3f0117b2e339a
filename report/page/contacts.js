// Rollers over time: how long each carries, how much, and how hard the pipe comes down on them.
'use strict';
(function () {
  const data = Report.data;
  if (!data.dynamic) return;
  const colours = Report.colours;
  const { positions, base, zero_line } = Report.row_bars;
  const dynamic = data.dynamic;

  // What a roller saw, in the order of the slots of the bars.
  function seen(list, position) {
    const out = [];
    for (const { box, row, at } of list) {
      const over_time = dynamic.supports[data.supports.indexOf(box)];
      const roller = over_time && over_time.rows[box.rows.indexOf(row)] && over_time.rows[box.rows.indexOf(row)][position.name];
      if (roller) out.push({ box, at, roller });
    }
    return out;
  }

  const present = (position) => dynamic.supports.some((box) => box.rows.some((row) => row[position.name]));

  function bar(frame, at, low, high, colour, half = 0.36) {
    return frame.plot.append('rect').attr('x', frame.x(at - half)).attr('width', frame.x(2 * half) - frame.x(0))
      .attr('y', frame.y(high)).attr('height', Math.max(frame.y(low) - frame.y(high), 0)).attr('fill', colour);
  }

  // The paper's question: which rollers does the pipe miss?
  Report.share_bars = function (panel) {
    for (const position of positions.filter(present)) {
      const { frame, list } = base(panel, { height: 218, y: [0, 118], title: `${position.name[0].toUpperCase()}${position.name.slice(1)} rollers`, y_label: '% of time', y_ticks: [0, 25, 50, 75, 100] });
      for (const { box, at, roller } of seen(list, position)) {
        const share = 100 * roller.contact_share;
        bar(frame, at, 0, 100, '#fff').attr('stroke', '#d5dce3');
        bar(frame, at, 0, share, position.colour).append('title').text(`${box.name}: ${Report.fixed(share, 1)} % of time in contact, ${roller.impact_count} impacts`);
        if (share <= 0) frame.plot.append('text').attr('text-anchor', 'middle').attr('x', frame.x(at)).attr('y', frame.y(0) - 4).style('fill', colours.accent).text('\u00d7');
        if (roller.static_reaction > 0) frame.plot.append('circle').attr('cx', frame.x(at)).attr('cy', frame.y(109)).attr('r', 3.6).attr('fill', '#1b2733');
      }
      zero_line(frame);
      Report.legend(frame, [{ text: 'fraction of time in contact', colour: position.colour, block: true }, { text: 'carries in the static state', colour: '#1b2733', dot: true }]);
    }
  };

  Report.reaction_ranges = function (panel) {
    for (const position of positions.filter(present)) {
      const hi = d3.max(dynamic.supports, (box) => d3.max(box.rows, (row) => (row[position.name] ? Math.max(row[position.name].reaction.max, row[position.name].static_reaction) : 0)));
      if (!(hi > 0)) continue;
      const { frame, list } = base(panel, { height: 250, y: [0, 1.15 * hi], title: `${position.name[0].toUpperCase()}${position.name.slice(1)} rollers`, y_label: 'Reaction', y_si: 'N' });
      let largest = null;
      for (const { box, at, roller } of seen(list, position)) {
        if (roller.reaction.max <= 0 && roller.static_reaction <= 0) continue;
        const [least, mean, most, before] = [roller.reaction.min, roller.reaction.mean, roller.reaction.max, roller.static_reaction];
        bar(frame, at, least, most, colours.band).attr('stroke', colours.dynamic).append('title')
          .text(`${box.name}, ${position.name}: ${Report.number(least, 'N', 1)} to ${Report.shown(most, 'N', 1)}, mean ${Report.shown(mean, 'N', 1)}, static ${Report.shown(before, 'N', 1)}`);
        frame.used.push({ x0: frame.x(at - 0.36), x1: frame.x(at + 0.36), y0: frame.y(most), y1: frame.y(0) });
        frame.plot.append('line').attr('x1', frame.x(at - 0.36)).attr('x2', frame.x(at + 0.36)).attr('y1', frame.y(mean)).attr('y2', frame.y(mean)).attr('stroke', colours.second).attr('stroke-width', 2);
        if (before > 0) frame.plot.append('circle').attr('cx', frame.x(at)).attr('cy', frame.y(before)).attr('r', 3.2).attr('fill', colours.pipe);
        if (!largest || most > largest.most) largest = { most, at, box };
      }
      zero_line(frame);
      Report.legend(frame, [{ text: 'min to max', colour: colours.band, block: true, edge: colours.dynamic }, { text: 'mean', colour: colours.second }, { text: 'static', colour: colours.pipe, dot: true }]);
      if (largest) Report.mark(frame, largest.at, largest.most, `${Report.shown(largest.most, 'N', 1)} (${largest.box.name})`, colours.dynamic);
    }
  };

  Report.impact_scatter = function (panel, part) {
    const impacts = dynamic.impacts;
    const by_time = part === 'time';
    const x = (hit) => (by_time ? hit.time : hit.approach_velocity);
    const hi = d3.max(impacts, (hit) => hit.peak_force);
    const end = by_time ? Math.max(dynamic.duration, d3.max(impacts, x)) : 1.08 * d3.max(impacts, x) || 1;
    const frame = Report.frame(panel, {
      height: 290, x: [0, end], y: [0, 1.14 * hi], title: `Peak force of the ${impacts.length > 1 ? impacts.length + ' ' : ''}hardest impact${impacts.length > 1 ? 's' : ''}, ${by_time ? 'over time' : 'against the velocity of approach'}`,
      x_label: by_time ? 'Time from the end of the build-up [s]' : 'Normal velocity at first contact', x_si: by_time ? undefined : 'm/s', y_label: 'Peak force', y_si: 'N',
    });
    const colour_of = (hit) => positions.find((p) => p.name === hit.position).colour;
    for (const hit of [...impacts].reverse()) {  // the hardest on top
      frame.plot.append('circle').attr('cx', frame.x(x(hit))).attr('cy', frame.y(hit.peak_force)).attr('r', 3.6).attr('fill', colour_of(hit)).attr('fill-opacity', 0.7)
        .append('title').text(`${hit.box}, row ${hit.row}, ${hit.position}: ${Report.shown(hit.peak_force, 'N', 1)} at ${Report.shown(hit.approach_velocity, 'm/s', 3)}, t = ${Report.fixed(hit.time, 1)} s`);
      frame.used.push({ x0: frame.x(x(hit)) - 3, x1: frame.x(x(hit)) + 3, y0: frame.y(hit.peak_force) - 3, y1: frame.y(hit.peak_force) + 3 });
    }
    Report.legend(frame, positions.filter((p) => impacts.some((hit) => hit.position === p.name)).map((p) => ({ text: p.name, colour: p.colour, dot: true })));
    const first = impacts[0];
    Report.mark(frame, x(first), first.peak_force, `${Report.shown(first.peak_force, 'N', 1)} (${first.box}, row ${first.row})`, colour_of(first));
  };
})();
