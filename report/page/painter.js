// Axonometric drawing: pieces are painted from the farthest to the nearest, in layers, as SVG.
'use strict';
(function () {
  // Ship axes (astern, port, up) are left-handed; the drawing uses (astern, starboard, up).
  const hand = (p) => [p[0], -p[1], p[2]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = (a) => { const n = Math.hypot(...a) || 1; return a.map((v) => v / n); };
  const add = (a, b, k = 1) => a.map((v, i) => v + k * b[i]);
  Report.vector = { dot, cross, unit, add, hand };

  // azimuth from astern towards starboard, elevation above the horizon [rad].
  Report.Camera = function (azimuth, elevation) {
    const c = Math.cos(elevation);
    this.towards_eye = [c * Math.cos(azimuth), c * Math.sin(azimuth), Math.sin(elevation)];
    this.right = [-Math.sin(azimuth), Math.cos(azimuth), 0];
    this.up = cross(this.towards_eye, this.right);
  };
  Report.Camera.prototype.see = function (p) { return [dot(this.right, p), -dot(this.up, p), dot(this.towards_eye, p)]; };

  Report.Painter = function (camera) {
    this.camera = camera;
    this.pieces = [];
    this.labels = [];
    this.light = unit([0.25 * camera.right[0] + 0.6 * camera.up[0] + camera.towards_eye[0], 0.25 * camera.right[1] + 0.6 * camera.up[1] + camera.towards_eye[1], 0.25 * camera.right[2] + 0.6 * camera.up[2] + camera.towards_eye[2]]);
  };
  const P = Report.Painter.prototype;

  P.add = function (layer, points, attributes, closed, nearer = 0) {
    const seen = points.map((p) => this.camera.see(p));
    this.pieces.push({ layer, seen, attributes, closed, depth: d3.mean(seen, (p) => p[2]) + nearer });
  };
  P.face = function (layer, points, attributes, nearer) { this.add(layer, points, attributes, true, nearer); };
  P.line = function (layer, points, attributes, nearer) { this.add(layer, points, `fill="none" ${attributes}`, false, nearer); };
  // `step`: it may move on along its lead, or be left out, where it would cover another.
  P.text = function (point, text, dx, dy, anchor, step = false) { this.labels.push({ at: this.camera.see(point), text, dx, dy, anchor, step }); };

  // A face of a round body: only when it looks at the eye, brighter towards the light.
  P.shaded = function (layer, points, normal, colour) {
    if (dot(normal, this.camera.towards_eye) <= 0) return;
    const bright = 0.45 + 0.65 * Math.max(0, dot(normal, this.light));
    const c = d3.rgb(colour);
    const shade = d3.rgb(Math.min(255, c.r * bright), Math.min(255, c.g * bright), Math.min(255, c.b * bright)).formatHex();
    this.face(layer, points, `fill="${shade}" stroke="${shade}" stroke-width="0.4"`);
  };

  // Scales what must be seen into the box and writes the SVG.
  P.svg = function (fit, width, height, room) {
    const seen = fit.map((p) => this.camera.see(p));
    const [x0, x1] = d3.extent(seen, (p) => p[0]);
    const [y0, y1] = d3.extent(seen, (p) => p[1]);
    const scale = Math.min((width - room.left - room.right) / (x1 - x0), (height - room.top - room.bottom) / (y1 - y0));
    const dx = room.left + (width - room.left - room.right - scale * (x1 - x0)) / 2 - scale * x0;
    const dy = room.top + (height - room.top - room.bottom - scale * (y1 - y0)) / 2 - scale * y0;
    const place = (p) => `${(dx + scale * p[0]).toFixed(1)},${(dy + scale * p[1]).toFixed(1)}`;
    this.pieces.sort((a, b) => a.layer - b.layer || a.depth - b.depth);
    const parts = this.pieces.map((piece) => `<${piece.closed ? 'polygon' : 'polyline'} points="${piece.seen.map(place).join(' ')}" ${piece.attributes}/>`);
    const taken = [];
    for (const label of this.labels) {
      const [x, y] = place(label.at).split(',').map(Number);
      const box = this.room_for(label, x, y, taken, height - room.bottom + 8);
      if (!box) continue;
      taken.push(box);
      label.dy = box.dy;
      const lead = Math.hypot(label.dx, label.dy) > 24 ? `<line x1="${x}" y1="${y}" x2="${x + 0.85 * label.dx}" y2="${y + 0.85 * label.dy}" stroke="#5b6b7a" stroke-width="0.8"/>` : '';
      parts.push(`${lead}<text class="halo" x="${x + label.dx}" y="${y + label.dy + 4}" text-anchor="${label.anchor || 'middle'}" style="font-size:13px">${Report.escape(label.text)}</text>`);
    }
    this.scale = scale;
    return parts.join('');
  };

  // Where a label covers none of those set before it: as asked for, or further along its lead; null where nowhere near.
  // Moved ones stay above `lowest`, where the colour scale stands.
  P.room_for = function (label, x, y, taken, lowest) {
    const wide = Report.measured(label.text, 13);
    const left = x + label.dx - (label.anchor === 'end' ? wide : label.anchor === 'start' ? 0 : wide / 2);
    const steps = label.step ? d3.range(0, 4) : [0];
    for (const k of steps) {
      const dy = label.dy + 17 * k * Math.sign(label.dy);
      const box = { x0: left - 2, x1: left + wide + 2, y0: y + dy - 8, y1: y + dy + 7, dy };
      if (k > 0 && box.y1 > lowest) break;
      if (taken.every((u) => box.x1 < u.x0 || box.x0 > u.x1 || box.y1 < u.y0 || box.y0 > u.y1)) return box;
    }
    return label.step ? null : { x0: left, x1: left + wide, y0: y + label.dy - 8, y1: y + label.dy + 7, dy: label.dy };
  };

  Report.escape = (text) => String(text).replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);
})();
