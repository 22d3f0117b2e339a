// Charts of a study: curves, maps, swings, rank correlations, scatter.
'use strict';
(function () {
  const study = Report.data.study;
  if (!study) return;
  const kMostMaps = 36;
  const done = (group) => group.state === 'passed' || group.state === 'exceeded';
  const outputs = study.outputs;
  const short = (value) => (value === null || value === undefined ? 'no result' : Number(value.toPrecision(4)).toString());

  // Values of an axis as numbers where it has such, otherwise its places in the list.
  function ticks(axis) {
    const input = study.inputs[axis];
    const numbers = input.values.length === input.words.length && input.values.every((v) => v !== null);
    return { name: input.name, numbers, at: numbers ? input.values : d3.range(input.words.length), words: numbers ? input.values.map((v) => Number(v.toPrecision(6)).toString()) : input.words };
  }

  function room([lo, hi], part = 0.08) {
    const more = part * (hi - lo) || part * Math.abs(hi) || 1;
    return [lo >= 0 ? Math.max(0, lo - more) : lo - more, hi <= 0 ? Math.min(0, hi + more) : hi + more];
  }

  function told(group) {
    const where = study.inputs.map((input, i) => `${input.name.replace(/ \[.*/, '')}: ${group.words[i]}`).join('\n');
    const check = group.governing ? `\n${group.governing}: ${short(group.utilisation)}` : '';
    return `case ${group.case}\n${where}${check}\n${{ passed: group.governing ? 'passed' : 'solved', exceeded: 'a governing check is exceeded', failed: 'no result', open: 'not run' }[group.state]}`;
  }

  function dot(group_of, x, y, group, radius) {
    group_of.append('circle').attr('cx', x).attr('cy', y).attr('r', radius).attr('fill', group.state === 'passed' ? Report.colours.pipe : '#fff')
      .attr('stroke', group.state === 'passed' ? Report.colours.pipe : Report.colours.accent).attr('stroke-width', 1.4).append('title').text(told(group));
  }

  function small(panel, options) {
    const frame = Report.frame(panel, { width: 480, height: 250, left: 72, x_ticks: 6, y_label: '', ...options });
    frame.svg.classed('small', true);
    return frame;
  }

  // Replaces the numbers below the frame by words where an axis has only these.
  function name_ticks(frame, axis, horizontal) {
    if (axis.numbers) return;
    const group = frame.svg.selectAll('g').filter(function () { return this.getAttribute('text-anchor') === (horizontal ? 'middle' : 'end'); });
    group.selectAll('.tick text').text((d) => Report.shortened(axis.words[d] || ''));
  }

  Report.study_curves = function (panel) {
    const axis = ticks(study.axes[0]);
    const x_of = (group) => axis.at[group.at[study.axes[0]]];
    for (const output of outputs) {
      const groups = study.groups.filter((g) => done(g) && g.mean[output.at] !== null).sort((a, b) => x_of(a) - x_of(b));
      if (groups.length === 0) continue;
      const y = room(d3.extent(groups.flatMap((g) => [g.low[output.at], g.high[output.at]])));
      const x = d3.extent(axis.at);
      const frame = small(panel, { x: x[0] === x[1] ? [x[0] - 0.5, x[1] + 0.5] : x, y, x_label: axis.name, title: output.name, x_tick_values: axis.numbers ? null : axis.at });
      name_ticks(frame, axis, true);
      const band = d3.area((g) => frame.x(x_of(g)), (g) => frame.y(g.low[output.at]), (g) => frame.y(g.high[output.at]));
      frame.plot.append('path').attr('d', band(groups)).attr('fill', '#c9dbea');
      frame.plot.append('path').attr('d', d3.line((g) => frame.x(x_of(g)), (g) => frame.y(g.mean[output.at]))(groups)).attr('fill', 'none').attr('stroke', Report.colours.pipe).attr('stroke-width', 2);
      for (const g of groups) dot(frame.over, frame.x(x_of(g)), frame.y(g.mean[output.at]), g, 3.2);
      if (groups.some((g) => g.state === 'exceeded')) {
        frame.svg.append('circle').attr('cx', frame.width - 112).attr('cy', 15).attr('r', 3.2).attr('fill', '#fff').attr('stroke', Report.colours.accent).attr('stroke-width', 1.4);
        frame.svg.append('text').attr('x', frame.width - 102).attr('y', 20).text('check exceeded');
      }
    }
  };

  // The two keys with most values span the map; of the others each combination has its own.
  function layout() {
    const axes = [...study.axes].sort((a, b) => study.inputs[b].words.length - study.inputs[a].words.length);
    const rest = axes.slice(2);
    const facets = d3.groups(study.groups, (g) => rest.map((axis) => g.at[axis]).join(' '))
      .map(([, groups]) => ({ groups, title: rest.map((axis) => `${study.inputs[axis].name.replace(/ \[.*/, '')} ${groups[0].words[axis]}`).join(', ') }));
    return { x: axes[0], y: axes[1], facets };
  }

  function hatch(svg) {
    const id = 'hatch-' + Report.next_id();
    const pattern = svg.append('defs').append('pattern').attr('id', id).attr('width', 7).attr('height', 7).attr('patternUnits', 'userSpaceOnUse').attr('patternTransform', 'rotate(45)');
    pattern.append('rect').attr('width', 7).attr('height', 7).attr('fill', '#fff');
    pattern.append('line').attr('y2', 7).attr('stroke', '#7b8794').attr('stroke-width', 2.4);
    return `url(#${id})`;
  }

  // The line between cells that pass and their neighbours that do not.
  function border(group, cells, x, y) {
    const passes = (i, j) => cells.get(`${i} ${j}`)?.state === 'passed';
    for (const key of cells.keys()) {
      const [i, j] = key.split(' ').map(Number);
      if (!passes(i, j)) continue;
      const edges = [[i + 1, j, x(i + 1), y(j), x(i + 1), y(j + 1)], [i - 1, j, x(i), y(j), x(i), y(j + 1)], [i, j + 1, x(i), y(j + 1), x(i + 1), y(j + 1)], [i, j - 1, x(i), y(j), x(i + 1), y(j)]];
      for (const [a, b, x1, y1, x2, y2] of edges) {
        if (!cells.has(`${a} ${b}`) || passes(a, b)) continue;
        for (const [colour, wide] of [['#fff', 5], ['#1b2733', 2.6]]) {
          group.append('line').attr('x1', x1).attr('y1', y1).attr('x2', x2).attr('y2', y2).attr('stroke', colour).attr('stroke-width', wide).attr('stroke-linecap', 'square');
        }
      }
    }
  }

  function axis_words(svg, axis, at, across) {
    const step = Math.ceil(axis.words.length / (across ? 7 : 10));
    axis.words.forEach((word, i) => {
      if (i % step !== 0) return;
      const text = svg.append('text').attr('class', 'soft').text(Report.shortened(word));
      if (across) text.attr('text-anchor', 'middle').attr('x', at(i)).attr('y', across);
      else text.attr('text-anchor', 'end').attr('x', 62).attr('y', at(i) + 4);
    });
  }

  function map(panel, output, facet, plan, colour) {
    const ax = ticks(plan.x);
    const ay = ticks(plan.y);
    const [width, left, right, top] = [480, 70, 74, facet.title ? 46 : 32];
    const tall = Math.max(26 * Math.min(ay.at.length, 12), 120);
    const x = (i) => left + (width - left - right) * i / ax.at.length;
    const y = (j) => top + tall * (1 - j / ay.at.length);
    const svg = d3.select(panel).append('svg').attr('viewBox', `0 0 ${width} ${top + tall + 44}`).attr('class', 'small').attr('role', 'img').attr('aria-label', output.name);
    const fill = hatch(svg);
    const cells = new Map(facet.groups.map((g) => [`${g.at[plan.x]} ${g.at[plan.y]}`, g]));
    for (const [key, g] of cells) {
      const [i, j] = key.split(' ').map(Number);
      const value = g.mean[output.at];
      const cell = svg.append('rect').attr('x', x(i)).attr('y', y(j + 1)).attr('width', x(i + 1) - x(i)).attr('height', y(j) - y(j + 1))
        .attr('fill', done(g) && value !== null ? colour(value) : g.state === 'open' ? '#fff' : fill).attr('stroke', '#fff').attr('stroke-width', 0.6);
      cell.append('title').text(`${output.name}: ${short(value)}\n${told(g)}`);
    }
    svg.append('rect').attr('x', left).attr('y', top).attr('width', width - left - right).attr('height', tall).attr('fill', 'none').attr('stroke', '#8794a0');
    border(svg.append('g'), cells, x, y);
    axis_words(svg, ax, (i) => (x(i) + x(i + 1)) / 2, top + tall + 17);
    axis_words(svg, ay, (j) => (y(j) + y(j + 1)) / 2, 0);
    svg.append('text').attr('class', 'soft').attr('text-anchor', 'middle').attr('x', (left + width - right) / 2).attr('y', top + tall + 37).text(ax.name);
    svg.append('text').attr('class', 'soft').attr('text-anchor', 'middle').attr('transform', `translate(13,${top + tall / 2}) rotate(-90)`).text(ay.name);
    svg.append('text').attr('class', 'title').attr('x', left).attr('y', 16).text(output.name);
    if (facet.title) svg.append('text').attr('class', 'soft').attr('x', left).attr('y', 34).text(facet.title);
    scale(svg, colour, width - right + 14, top, tall);
  }

  function scale(svg, colour, left, top, tall) {
    const [lo, hi] = colour.domain();
    const id = 'scale-' + Report.next_id();
    const gradient = svg.append('defs').append('linearGradient').attr('id', id).attr('x1', 0).attr('x2', 0).attr('y1', 1).attr('y2', 0);
    for (const t of d3.range(0, 1.001, 0.1)) gradient.append('stop').attr('offset', t).attr('stop-color', colour(lo + t * (hi - lo)));
    svg.append('rect').attr('x', left).attr('y', top).attr('width', 11).attr('height', tall).attr('fill', `url(#${id})`);
    const numbers = d3.scaleLinear([lo, hi], [top + tall, top]);
    svg.append('g').attr('transform', `translate(${left + 11},0)`).call(d3.axisRight(numbers).ticks(5, hi - lo < 1e-3 * Math.abs(hi) ? '.6~g' : '.4~g').tickSize(4)).call((g) => g.select('.domain').remove());
  }

  Report.study_maps = function (panel) {
    const plan = layout();
    let drawn = 0;
    let left_out = 0;
    for (const output of outputs) {
      const values = study.groups.filter((g) => done(g) && g.mean[output.at] !== null).map((g) => g.mean[output.at]);
      if (values.length === 0) continue;
      let [lo, hi] = d3.extent(values);
      if (lo === hi) { lo -= 0.5 * Math.abs(lo) || 0.5; hi += 0.5 * Math.abs(hi) || 0.5; }
      const colour = d3.scaleSequential([lo, hi], d3.interpolateViridis);
      for (const facet of plan.facets) {
        if (drawn++ < kMostMaps) map(panel, output, facet, plan, colour);
        else ++left_out;
      }
    }
    if (left_out > 0) d3.select(panel).append('p').attr('class', 'small').text(`${left_out} more maps are not shown; the table of cases has their numbers.`);
  };

  // Bars to both sides of a line, the widest on top. bars: [{name, low, high, text}]
  function bars(panel, title, all, middle, x, label) {
    const tall = 24;
    const frame = small(panel, { height: 84 + tall * all.length, left: 190, right: 26, x, y: [0, all.length], y_ticks: [], x_label: label, title, x_ticks: 5 });
    all.forEach((bar, k) => {
      const y = frame.y(all.length - k) + 4;
      const low = frame.plot.append('rect').attr('x', frame.x(bar.low)).attr('y', y).attr('width', Math.max(frame.x(middle) - frame.x(bar.low), 0)).attr('height', tall - 8).attr('fill', Report.colours.second);
      const high = frame.plot.append('rect').attr('x', frame.x(middle)).attr('y', y).attr('width', Math.max(frame.x(bar.high) - frame.x(middle), 0)).attr('height', tall - 8).attr('fill', Report.colours.pipe);
      for (const one of [low, high]) one.append('title').text(bar.text);
      frame.svg.append('text').attr('x', 184).attr('y', y + 12).attr('text-anchor', 'end').text(bar.name.length > 26 ? '\u2026' + bar.name.slice(-25) : bar.name).append('title').text(bar.name);
    });
    frame.over.append('line').attr('x1', frame.x(middle)).attr('x2', frame.x(middle)).attr('y1', frame.y(0)).attr('y2', frame.y(all.length)).attr('stroke', '#1b2733').attr('stroke-width', 1.2);
  }

  Report.study_swings = function (panel) {
    for (const one of study.tornado || []) {
      const all = [...one.bars].sort((a, b) => (b.high - b.low) - (a.high - a.low))
        .map((bar) => ({ ...bar, text: `${bar.name}: ${short(bar.low)} at ${bar.low_word}, ${short(bar.high)} at ${bar.high_word}` }));
      const [lo, hi] = d3.extent(all.flatMap((bar) => [bar.low, bar.high]));
      const more = 0.05 * (hi - lo) || 0.5;
      bars(panel, one.output, all, one.base, [lo - more, hi + more], 'value; the line is the base case');
    }
  };

  Report.study_correlations = function (panel) {
    for (const one of study.tornado || []) {
      const all = [...one.bars].sort((a, b) => Math.abs(b.value) - Math.abs(a.value))
        .map((bar) => ({ name: bar.name, low: Math.min(bar.value, 0), high: Math.max(bar.value, 0), text: `${bar.name}: ${bar.value.toFixed(2)}` }));
      if (all.length > 0) bars(panel, one.output, all, 0, [-1, 1], 'rank correlation');
    }
  };

  Report.study_scatter = function (panel) {
    let drawn = 0;
    for (const output of outputs) {
      study.inputs.forEach((input, i) => {
        const groups = study.groups.filter((g) => done(g) && g.mean[output.at] !== null && g.x[i] !== null);
        if (groups.length === 0 || drawn >= kMostMaps) return;
        ++drawn;
        const x = d3.extent(groups, (g) => g.x[i]);
        const frame = small(panel, { x: room(x, 0.04), y: room(d3.extent(groups, (g) => g.mean[output.at])), x_label: input.name, title: output.name });
        for (const g of groups) dot(frame.plot, frame.x(g.x[i]), frame.y(g.mean[output.at]), g, 2.6);
      });
    }
  };
})();
