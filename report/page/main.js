// Fills the panels of the page.
'use strict';
(function () {
  const data = Report.data;
  const kWidth = 960;

  // Colour scale of the pipe, and what the colours of rollers mean.
  function key(svg, height, rollers) {
    const group = svg.append('g').attr('transform', `translate(16,${height - 34})`);
    const wide = 220;
    const id = 'scale-' + Report.next_id();
    const unit = Report.unit('Pa');
    const top = Report.stress_colour.domain()[1];
    const gradient = svg.append('defs').append('linearGradient').attr('id', id);
    for (const t of d3.range(0, 1.001, 0.1)) gradient.append('stop').attr('offset', t).attr('stop-color', Report.stress_colour(t * top));
    group.append('rect').attr('width', wide).attr('height', 10).attr('fill', `url(#${id})`);
    const axis = d3.axisBottom(d3.scaleLinear([0, top], [0, wide])).ticks(4).tickSize(4);
    group.append('g').attr('transform', 'translate(0,10)').call(axis).call((g) => g.select('.domain').remove());
    group.append('text').attr('y', -7).text(`von Mises stress in the pipe [${unit.name}]`);
    if (!rollers) return;
    const words = [['#e8741a', 'roller in contact'], ['#aab4bd', 'roller without contact']];
    words.forEach(([colour, text], k) => {
      group.append('rect').attr('x', wide + 40 + 160 * k).attr('y', -3).attr('width', 14).attr('height', 14).attr('fill', colour);
      group.append('text').attr('x', wide + 60 + 160 * k).attr('y', 9).text(text);
    });
  }

  // A view that turns with the pointer.
  function view(panel, title, build, azimuth, elevation, height) {
    const svg = d3.select(panel).append('svg').attr('viewBox', `0 0 ${kWidth} ${height}`).attr('class', 'rotatable').attr('role', 'img').attr('aria-label', title);
    svg.append('rect').attr('width', kWidth).attr('height', height).attr('fill', '#fff');
    const group = svg.append('g');
    const draw = () => {
      const { painter, fit } = build(new Report.Camera(azimuth, elevation));
      group.html(painter.svg(fit, kWidth, height, { left: 20, right: 20, top: 74, bottom: 64 }));
    };
    draw();
    const clip = 'clip-' + Report.next_id();
    svg.append('clipPath').attr('id', clip).append('rect').attr('y', 32).attr('width', kWidth).attr('height', height - 32);
    group.attr('clip-path', `url(#${clip})`);
    svg.append('text').attr('class', 'title').attr('x', 16).attr('y', 20).text(title);
    key(svg, height, data.supports.length > 0);
    d3.select(panel).append('div').attr('class', 'hint').text('drag to rotate');
    let waiting = false;
    svg.call(d3.drag().on('drag', (event) => {
      azimuth -= event.dx * 0.008;
      elevation = Math.min(1.5, Math.max(0.05, elevation + event.dy * 0.006));
      if (!waiting) {
        waiting = true;
        requestAnimationFrame(() => { waiting = false; draw(); });
      }
    }));
  }

  function configuration(panel, part) {
    const degrees = Math.PI / 180;
    if (part === 'whole') {
      const steep = data.water_depth > 0.4 * (data.whole_end || 1);
      view(panel, 'Whole line', Report.whole_scene, (steep ? -62 : -70) * degrees, 20 * degrees, steep ? 520 : 385);
    } else if (part === 'overbend') {
      view(panel, 'Overbend, with every roller (frames are schematic)', (c) => Report.overbend_scene(c, data.supports, 8, 10), -62 * degrees, 20 * degrees, 390);
    } else {
      const stinger = data.supports.filter((b) => b.stinger);
      if (stinger.length > 0) view(panel, 'Stinger (frames are schematic)', (c) => Report.overbend_scene(c, stinger, 2, 6), -62 * degrees, 9 * degrees, 405);
    }
  }

  const figures = {
    configuration,
    stinger: Report.stinger_view,
    geometry: (panel, part) => (part === 'plan' ? Report.plan(panel) : Report.elevation(panel, part)),
    reactions: Report.reaction_bars,
    separations: Report.separation_bars,
    checks: Report.utilisation,
    fatigue: Report.fatigue,
    history: Report.history,
    spectra: Report.spectra,
    shares: Report.share_bars,
    ranges: Report.reaction_ranges,
    impacts: Report.impact_scatter,
    mooring_plan: Report.mooring_plan,
    mooring_profile: Report.mooring_profile,
    mooring_offsets: Report.mooring_offsets,
    mooring_stages: Report.mooring_stages,
    move_pipe: Report.move_pipe,
    stages: Report.stages,
    stage_curves: Report.stage_curves,
    line_shape: Report.line_shape,
    line_tension: Report.line_tension,
    seek_path: Report.seek_path,
    compared_tensioner: Report.compared_tensioner,
    compared_contact: Report.compared_contact,
    lay_table: Report.lay_table,
    overlay: Report.overlay,
    study_curves: Report.study_curves,
    study_maps: Report.study_maps,
    study_swings: Report.study_swings,
    study_correlations: Report.study_correlations,
    study_scatter: Report.study_scatter,
    operability_chart: Report.operability_chart,
    operability_rose: Report.operability_rose,
    workability: Report.workability,
  };

  for (const panel of document.querySelectorAll('.panel')) {
    const { figure, part } = panel.dataset;
    if (figures[figure]) figures[figure](panel, part);
    else if (figure.startsWith('envelope_')) Report.envelope(panel, figure, part);
    else Report.diagram(panel, figure, part);
  }

  // What is folded on screen is printed.
  const folded = [];
  window.addEventListener('beforeprint', () => {
    for (const details of document.querySelectorAll('details.print-open')) {
      if (!details.open) { folded.push(details); details.open = true; }
    }
  });
  window.addEventListener('afterprint', () => { while (folded.length > 0) folded.pop().open = false; });
  document.documentElement.dataset.drawn = 'yes';
})();
