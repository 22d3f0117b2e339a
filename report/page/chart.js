// A frame with axes, grid, units and marks; diagrams draw into it.
'use strict';
(function () {
  const kWidth = 960;

  // A scale of SI values in the unit that they are shown in.
  const as_shown = (scale, si) => (si ? scale.copy().domain(scale.domain().map((value) => value * Report.unit(si).factor)) : scale);
  const with_unit = (label, si) => (si && label ? `${label} [${Report.unit(si).name}]` : label);

  // A range that is wide enough for what its values tell: a hundredth of them, and ten of the last decimal told. What lies
  // below is the noise of equilibria and would fill the figure.
  function widened([lo, hi], digits, si) {
    const decimal = digits === undefined ? 0 : 10 ** -digits / (si ? Report.unit(si).factor : 1);
    const least = Math.max(0.01 * Math.max(Math.abs(lo), Math.abs(hi)), 10 * decimal);
    if (hi - lo >= least) return [lo, hi];
    return lo === 0 ? [0, least] : [0.5 * (lo + hi - least), 0.5 * (lo + hi + least)];
  }

  // options: {width, height, x: [lo, hi], y: [lo, hi], x_si, y_si: their SI unit where they are in SI, y_digits: decimals that its values are told with, x_label, y_label, title, equal, left, right, x_tick_values, x_tick_format, lane: room for names above the plot}
  Report.frame = function (panel, options) {
    const margin = { left: options.left || 88, right: options.right || 24, top: (options.title ? 34 : 16) + (options.lane || 0), bottom: options.bottom || 50 };
    const full_width = options.width || kWidth;
    const inner_width = full_width - margin.left - margin.right;
    let inner_height = (options.height || 300) + (options.lane || 0) - margin.top - margin.bottom;
    let [x0, x1] = options.x;
    let [y0, y1] = options.equal ? options.y : widened(options.y, options.y_digits, options.y_si);
    if (options.equal) {  // the same scale both ways: the height follows from the range
      inner_height = inner_width * (y1 - y0) / (x1 - x0);
      const most = options.most || 520;
      if (inner_height > most) {
        const wanted = inner_width * (y1 - y0) / most;
        x0 -= 0.5 * (wanted - (x1 - x0));
        x1 = x0 + wanted;
        inner_height = most;
      }
    }
    const height = inner_height + margin.top + margin.bottom;
    const svg = d3.select(panel).append('svg').attr('viewBox', `0 0 ${full_width} ${height.toFixed(1)}`)
      .attr('role', 'img').attr('aria-label', options.title || with_unit(options.y_label, options.y_si));
    const x = d3.scaleLinear([x0, x1], [margin.left, full_width - margin.right]);
    const y = d3.scaleLinear([y0, y1], [height - margin.bottom, margin.top]);
    const [x_shown, y_shown] = [as_shown(x, options.x_si), as_shown(y, options.y_si)];
    const clip = 'clip-' + Report.next_id();
    svg.append('clipPath').attr('id', clip).append('rect')
      .attr('x', margin.left).attr('y', margin.top).attr('width', inner_width).attr('height', inner_height);

    const back = svg.append('g');
    const grid = svg.append('g').attr('class', 'grid');
    const x_ticks = options.x_tick_values || x_shown.ticks(options.x_ticks || 10);
    const y_ticks = options.y_ticks || y_shown.ticks(Math.max(3, Math.round(inner_height / 48)));
    grid.selectAll(null).data(x_ticks).join('line')
      .attr('x1', (d) => x_shown(d)).attr('x2', (d) => x_shown(d)).attr('y1', margin.top).attr('y2', height - margin.bottom);
    grid.selectAll(null).data(y_ticks).join('line')
      .attr('y1', (d) => y_shown(d)).attr('y2', (d) => y_shown(d)).attr('x1', margin.left).attr('x2', full_width - margin.right);
    const plot = svg.append('g').attr('clip-path', `url(#${clip})`);
    svg.append('g').attr('transform', `translate(0,${height - margin.bottom})`)
      .call(d3.axisBottom(x_shown).tickValues(x_ticks).tickFormat(options.x_tick_format || null).tickSizeOuter(0));
    svg.append('g').attr('transform', `translate(${margin.left},0)`)
      .call(d3.axisLeft(y_shown).tickValues(y_ticks).tickSizeOuter(0));
    svg.append('text').attr('class', 'soft').attr('x', margin.left + inner_width / 2).attr('y', height - 10)
      .attr('text-anchor', 'middle').text(with_unit(options.x_label, options.x_si));
    svg.append('text').attr('class', 'soft').attr('text-anchor', 'middle')
      .attr('transform', `translate(17,${margin.top + inner_height / 2}) rotate(-90)`).text(with_unit(options.y_label, options.y_si));
    if (options.title) {
      svg.append('text').attr('class', 'title').attr('x', margin.left).attr('y', 20).text(options.title);
    }
    const over = svg.append('g');
    return { svg, back, plot, over, x, y, width: full_width, height, margin, inner_height, inner_width, used: [] };
  };


  // Width of a text in a size of its own, before there is a frame to set it in.
  const pen = document.createElement('canvas').getContext('2d');
  Report.measured = function (text, size) {
    pen.font = `${size}px ${getComputedStyle(document.body).fontFamily}`;
    return pen.measureText(text).width;
  };

  // Names that run aslant through points, all at one angle [deg]; one that would cover the name before it is left out.
  // names: [{x, y, text}] in pixels, in their order along the figure.
  Report.aslant_names = function (group, names, angle, { anchor = 'start', size = 12, css = 'soft' } = {}) {
    const turn = angle * Math.PI / 180;
    let last = null;
    for (const name of names) {
      const apart = last ? Math.abs((name.x - last.x) * Math.sin(turn) - (name.y - last.y) * Math.cos(turn)) : Infinity;
      if (apart < size + 1) continue;
      last = name;
      group.append('text').attr('class', `${css} name`).attr('text-anchor', anchor).attr('transform', `translate(${name.x},${name.y}) rotate(${angle})`)
        .style('font-size', `${size}px`).text(name.text);
    }
  };

  let ids = 0;
  Report.next_id = function () { return ++ids; };

  // Width of a text as this browser sets it.
  Report.text_width = function (frame, text, css) {
    const probe = frame.over.append('text').attr('class', css).text(text);
    const wide = probe.node().getComputedTextLength();
    probe.remove();
    return wide;
  };

  // Labels keep clear of a curve through these pixels.
  Report.keep_clear = function (frame, pixels) {
    pixels.forEach(([x1, y1], i) => {
      const [x0, y0] = pixels[Math.max(i - 1, 0)];
      const steps = Math.min(40, Math.ceil(Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0)) / 8));
      for (let k = 0; k <= steps; ++k) {
        const x = x0 + (x1 - x0) * k / Math.max(steps, 1);
        const y = y0 + (y1 - y0) * k / Math.max(steps, 1);
        frame.used.push({ x0: x - 1, x1: x + 1, y0: y - 2, y1: y + 2 });
      }
    });
  };

  // A label near a point that stays inside the frame and clear of labels set before.
  Report.label = function (frame, px, py, text, options = {}) {
    const wide = Report.text_width(frame, text, (options.css || 'mark'));
    const tall = 16;
    const places = options.below ? [[8, 20], [-wide - 8, 20], [8, -10], [-wide - 8, -10]]
                                 : [[8, -10], [-wide - 8, -10], [8, 20], [-wide - 8, 20]];
    for (let far = 0; far <= 5; ++far) {
      const up = -10 - 16 * far;
      const down = 20 + 16 * far;
      places.push([-wide / 2, up], [8, up], [-wide - 8, up], [-wide / 2, down], [8, down], [-wide - 8, down]);
    }
    const box = ([dx, dy]) => ({ x0: px + dx, x1: px + dx + wide, y0: py + dy - tall + 3, y1: py + dy + 3 });
    const inside = (b) => b.x0 >= frame.margin.left + 2 && b.x1 <= frame.width - (frame.margin.right > 40 ? frame.margin.right : 4) && b.y0 >= frame.margin.top - 2 && b.y1 <= frame.height - frame.margin.bottom;
    const clear = (b) => frame.used.every((u) => b.x1 < u.x0 || b.x0 > u.x1 || b.y1 < u.y0 || b.y0 > u.y1);
    const place = places.find((p) => inside(box(p)) && clear(box(p))) || places.find((p) => inside(box(p))) || places[0];
    frame.used.push(box(place));
    frame.over.append('text').attr('class', (options.css || 'mark') + ' halo').attr('x', px + place[0]).attr('y', py + place[1])
      .style('fill', options.fill || null).text(text);
  };

  // A point of interest with its value.
  Report.mark = function (frame, x, y, text, colour, options = {}) {
    const px = frame.x(x);
    const py = frame.y(y);
    frame.over.append('circle').attr('cx', px).attr('cy', py).attr('r', 4.5).attr('fill', colour).attr('stroke', '#fff').attr('stroke-width', 1.2);
    frame.used.push({ x0: px - 5, x1: px + 5, y0: py - 5, y1: py + 5 });
    Report.label(frame, px, py, text, { fill: colour, ...options });
  };

  // A legend in the head of the frame, from right to left. entries: [{text, colour, dash}]; `down` lowers it.
  Report.legend = function (frame, entries, down = 0) {
    let right = frame.width - frame.margin.right;
    for (const entry of [...entries].reverse()) {
      const wide = Report.text_width(frame, entry.text, '');
      frame.over.append('text').attr('x', right).attr('y', 20 + down).attr('text-anchor', 'end').text(entry.text);
      if (entry.block) {
        frame.over.append('rect').attr('x', right - wide - 22).attr('y', 9 + down).attr('width', 14).attr('height', 12).attr('fill', entry.colour).attr('stroke', entry.edge || null);
      } else if (entry.dot) {
        frame.over.append('circle').attr('cx', right - wide - 14).attr('cy', 15 + down).attr('r', 4).attr('fill', entry.colour);
      } else {
        frame.over.append('line').attr('x1', right - wide - 34).attr('x2', right - wide - 8).attr('y1', 15 + down).attr('y2', 15 + down)
          .attr('stroke', entry.colour).attr('stroke-width', entry.width || 2.2).attr('stroke-dasharray', entry.dash || null);
      }
      right -= wide + 48;
    }
  };
})();
