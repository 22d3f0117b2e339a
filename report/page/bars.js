// Bars per roller row, box by box: reactions and separations.
'use strict';
(function () {
  const data = Report.data;
  const colours = Report.colours;
  const positions = [
    { name: 'bottom', colour: colours.pipe },
    { name: 'port', colour: colours.port },
    { name: 'starboard', colour: colours.third },
  ];

  // One slot per row, a gap between boxes.
  function slots() {
    const list = [];
    let at = 0.5;
    for (const box of data.supports) {
      const first = at;
      for (const row of box.rows) list.push({ box, row, at: at++ });
      box.slot = [first - 0.5, at - 0.5];
      at += 0.8;
    }
    return { list, end: at - 0.8 };
  }

  function base(panel, options) {
    const { list, end } = slots();
    // Names stand level where each has room below its box, and aslant where they would run into each other.
    const size = data.supports.length > 10 ? 12 : 14;
    const widest = d3.max(data.supports, (box) => Report.measured(box.name, size));
    const narrowest = d3.min(data.supports, (box) => box.slot[1] - box.slot[0] + 0.8) * 850 / (end + 0.4);
    const level = widest + 6 < narrowest;
    const bottom = level ? 50 : 36 + Math.ceil(0.77 * Math.min(widest, 110) + 8);
    const frame = Report.frame(panel, { x: [-0.2, end + 0.2], x_label: '', x_ticks: 0.001, ...options, bottom, height: (options.height || 330) + bottom - 50 });
    frame.svg.selectAll('.tick').filter(function () { return d3.select(this.parentNode).attr('text-anchor') === 'middle'; }).remove();
    for (const box of data.supports) {
      const x0 = frame.x(box.slot[0]);
      const x1 = frame.x(box.slot[1]);
      frame.back.append('rect').attr('class', 'support').attr('x', x0).attr('width', x1 - x0).attr('y', frame.margin.top).attr('height', frame.inner_height);
      if (!level) continue;
      frame.over.append('text').attr('class', 'soft name').attr('text-anchor', 'middle').attr('x', (x0 + x1) / 2)
        .attr('y', frame.height - frame.margin.bottom + 18).style('font-size', `${size}px`).text(box.name);
    }
    if (!level) {
      const names = data.supports.map((box) => ({ x: frame.x((box.slot[0] + box.slot[1]) / 2) + 4, y: frame.height - frame.margin.bottom + 13, text: Report.shortened(box.name) }));
      Report.aslant_names(frame.over, names, -50, { anchor: 'end', size: 12 });
    }
    frame.over.append('text').attr('class', 'soft').attr('text-anchor', 'middle').attr('x', frame.margin.left + frame.inner_width / 2)
      .attr('y', frame.height - 10).text(options.words || 'Roller rows of each box, from the tensioner astern');
    return { frame, list };
  }

  function zero_line(frame) {
    frame.over.append('line').attr('x1', frame.margin.left).attr('x2', frame.width - frame.margin.right)
      .attr('y1', frame.y(0)).attr('y2', frame.y(0)).attr('stroke', '#41505e');
  }

  Report.row_bars = { positions, base, zero_line };

  const of = (row, position) => row.rollers.find((r) => r.position === position);

  Report.reaction_bars = function (panel) {
    const total = (row) => d3.sum(row.rollers, (r) => r.reaction);
    const hi = d3.max(data.supports, (b) => d3.max(b.rows, total)) || 1;
    const { frame, list } = base(panel, { y: [0, 1.12 * hi], title: 'Normal reactions', y_label: 'Reaction', y_si: 'N' });
    let largest = { value: 0 };
    for (const { box, row, at } of list) {
      let below = 0;
      for (const position of positions) {
        const roller = of(row, position.name);
        if (!roller || roller.reaction <= 0) continue;
        const value = roller.reaction;
        frame.plot.append('rect').attr('x', frame.x(at - 0.36)).attr('width', frame.x(0.72) - frame.x(0))
          .attr('y', frame.y(below + value)).attr('height', frame.y(below) - frame.y(below + value)).attr('fill', position.colour)
          .append('title').text(`${box.name}, ${position.name}: ${Report.shown(value, 'N', 2)}`);
        frame.used.push({ x0: frame.x(at - 0.36), x1: frame.x(at + 0.36), y0: frame.y(below + value), y1: frame.y(below) });
        below += value;
        if (value > largest.value) largest = { value, at, top: below, box, position };
      }
    }
    zero_line(frame);
    const used = positions.filter((p) => list.some(({ row }) => of(row, p.name)));
    Report.legend(frame, used.map((p) => ({ text: p.name, colour: p.colour, block: true })));
    if (largest.value > 0) {
      Report.mark(frame, largest.at, largest.top, `${Report.shown(largest.value, 'N', 1)} (${largest.box.name}, ${largest.position.name})`, colours.pipe);
    }
  };

  // Past the end of a roller and behind it: the pipe is no longer between the rollers, and a distance would mislead.
  const passed = (roller) => roller.passed;

  // In words: among so many bars a label would find no room.
  function smallest_of(shown) {
    const all = data.supports.flatMap((box) => box.rows.flatMap((row) => row.rollers.filter((roller) => !passed(roller)).map((roller) => ({ box, roller }))));
    const least = d3.least(all.filter(({ roller }) => shown.some((p) => p.name === roller.position)), ({ roller }) => roller.separation);
    if (!least) return 'none, the pipe is outside the rollers';
    return `${Report.shown(least.roller.separation, 'section', 2)} at ${least.box.name}, ${least.roller.position}`;
  }

  // Bottom rollers as bars; sides, whose gap is of another size, in a panel of their own.
  function separation_panel(panel, title, shown) {
    const values = data.supports.flatMap((b) => b.rows.flatMap((row) => row.rollers.filter((r) => shown.some((p) => p.name === r.position) && !passed(r)).map((r) => r.separation)));
    if (!data.supports.some((b) => b.rows.some((row) => shown.some((p) => of(row, p.name))))) return;
    const lo = Math.min(0, d3.min(values) || 0);
    const hi = Math.max(0, d3.max(values) || 0);
    const room = 0.12 * (hi - lo || 1e-3);
    const { frame, list } = base(panel, { y: [lo < 0 ? lo - room : 0, hi + room], title: `${title}; smallest ${smallest_of(shown)}`, y_label: 'Separation', y_si: 'section', height: 300 });
    const wide = 0.72 / shown.length;
    for (const { box, row, at } of list) {
      shown.forEach((position, k) => {
        const roller = of(row, position.name);
        if (!roller) return;
        if (passed(roller)) {
          frame.plot.append('text').attr('text-anchor', 'middle').attr('x', frame.x(at - 0.36 + (k + 0.5) * wide)).attr('y', frame.y(0) - 3)
            .style('font-size', '15px').style('fill', position.colour).text('\u00d7').append('title').text(`${box.name}, ${position.name}: the pipe has passed the end of the roller`);
          return;
        }
        const value = roller.separation;
        const y = [frame.y(Math.max(value, 0)), frame.y(Math.min(value, 0))];
        frame.plot.append('rect').attr('x', frame.x(at - 0.36 + k * wide)).attr('width', frame.x(wide) - frame.x(0))
          .attr('y', y[0]).attr('height', Math.max(y[1] - y[0], 0.5)).attr('fill', position.colour)
          .append('title').text(`${box.name}, ${position.name}: ${Report.shown(value, 'section', 2)}`);
      });
    }
    zero_line(frame);
    const outside = list.some(({ row }) => row.rollers.some((r) => shown.some((p) => p.name === r.position) && passed(r)));
    if (shown.length > 1) Report.legend(frame, shown.map((p) => ({ text: p.name, colour: p.colour, block: true })));
    if (outside) frame.over.append('text').attr('class', 'soft').attr('x', frame.margin.left + 8).attr('y', frame.margin.top + 16).text('\u00d7  the pipe has passed the end of the roller');
  }

  Report.separation_bars = function (panel) {
    separation_panel(panel, 'Bottom rollers', [positions[0]]);
    separation_panel(panel, 'Side rollers', [positions[1], positions[2]]);
  };
})();
