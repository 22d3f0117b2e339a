// The three-dimensional picture. It is drawn again only when something has changed.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Converged, Scene } from '../api/types';
import { shot, viewNames, axes, type ViewName } from './cameras';
import { hull, seeThrough } from './hull';
import { Labels, type Label } from './labels';
import { dispose, vec } from './members';
import { PipeView } from './pipe';
import { rig } from './rig';
import { RollersView, type RollerRef } from './rollers';
import { SeaView } from './sea';

export interface Colouring { values: ArrayLike<number> | null; low: number; high: number }
export type Picked = { kind: 'station'; index: number } | { kind: 'roller'; roller: RollerRef } | null;
export interface Moment {
  time: number; pose: number[]; places: Float32Array;
  flashes: { support: string; row: number; position: string; strength: number }[];
  /** Reactions of the boxes at the moment, as far as they are known; the largest of the run. */
  reactions: Map<string, number>; largest: number;
  /** What the tensioner does: +1 pays out, -1 hauls in, 0 holds; at its limit it can not go on. */
  tensioner: { way: number; limit: boolean; travel: number } | null;
}

/** Without a graphics card every sample of a pixel costs: smooth edges are then given up for pictures a second. */
function drawnByProcessor(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  const names = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = names ? String(gl!.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/** A pose of the program as a matrix: the place, then the axes row by row. */
export function poseMatrix(p: number[]): THREE.Matrix4 {
  return new THREE.Matrix4().set(p[3]!, p[4]!, p[5]!, p[0]!, p[6]!, p[7]!, p[8]!, p[1]!, p[9]!, p[10]!, p[11]!, p[2]!, 0, 0, 0, 1);
}

export class View3D {
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.2, 5000);
  onPick: (p: Picked, x: number, y: number) => void = () => undefined;
  onHover: (index: number | null) => void = () => undefined;
  frames = 0;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly world = new THREE.Scene();
  private readonly controls: OrbitControls;
  private readonly pipe = new PipeView();
  private readonly rollers = new RollersView();
  private readonly sea = new SeaView();
  private readonly afloat = new THREE.Group(); // moves with the vessel
  private readonly hullGroup = new THREE.Group();
  private readonly rigGroup = new THREE.Group();
  private readonly marker: THREE.Mesh;
  private readonly flashGroup = new THREE.Group();
  private readonly labels: Labels;
  private labelList: Label[] = [];
  private scene: Scene | null = null;
  private solution: Converged | null = null;
  private still = new THREE.Matrix4();
  private dirty = true;
  private dark = false;
  private width = 1;
  private height = 1;
  private view: ViewName | null = 'whole';
  private hullKey = '';
  private seaKey = '';
  private seaScene: Scene | null = null;
  private flight: { from: [THREE.Vector3, THREE.Vector3]; to: [THREE.Vector3, THREE.Vector3]; start: number } | null = null;
  private readonly observer: ResizeObserver;
  private running = true;
  private coarse = 1;
  private slow = 0;
  private lastDraw = -Infinity;
  private lastLabels = -Infinity;
  private stale = false; // solution or colours have changed since they were drawn
  private colouring: Colouring | null = null;
  private moment: Moment | null = null;
  private dragging = false;
  private drawn = false; // in the turn before
  private cost = 0; // of a picture: ms from its drawing to the next turn of the page
  private rigKey = '';
  private readonly byProcessor = drawnByProcessor();
  private readonly arrow = new THREE.Group();
  private readonly arrowPaint = new THREE.MeshBasicMaterial({ color: '#1f6fd0' });

  constructor(private readonly box: HTMLElement) {
    this.renderer = new THREE.WebGLRenderer({ antialias: !this.byProcessor, alpha: true, powerPreference: 'high-performance' });
    this.renderer.domElement.setAttribute('aria-hidden', 'true');
    box.append(this.renderer.domElement);
    const overlay = document.createElement('div');
    overlay.className = 'labels3d';
    overlay.setAttribute('aria-hidden', 'true');
    box.append(overlay);
    this.labels = new Labels(overlay);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.redraw());
    this.controls.addEventListener('start', () => { this.view = null; this.flight = null; });

    const sun = new THREE.DirectionalLight('#ffffff', 2.1);
    sun.position.set(-0.4, -1, 1.6);
    const back = new THREE.DirectionalLight('#cfe4ff', 0.7);
    back.position.set(0.6, 1, 0.5);
    this.world.add(sun, back, new THREE.HemisphereLight('#eaf4ff', '#8a7d63', 1.25));
    this.marker = new THREE.Mesh(new THREE.SphereGeometry(1, 20, 14), new THREE.MeshBasicMaterial({ color: '#ff2d7a', transparent: true, opacity: 0.9, depthTest: false }));
    this.marker.renderOrder = 10;
    this.marker.visible = false;
    this.afloat.matrixAutoUpdate = false;
    this.hullGroup.matrixAutoUpdate = false;
    const shaft = new THREE.Mesh(new THREE.CylinderGeometry(0.22, 0.22, 3, 12), this.arrowPaint);
    const head = new THREE.Mesh(new THREE.ConeGeometry(0.65, 1.6, 16), this.arrowPaint);
    head.position.y = 2.3;
    this.arrow.add(shaft, head);
    this.arrow.visible = false;
    this.afloat.add(this.hullGroup, this.rigGroup, this.rollers.group, this.flashGroup, this.arrow);
    this.world.add(this.afloat, this.pipe.mesh, this.sea.group, this.marker);

    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(box);
    this.resize();
    this.listen();
    const loop = (now: number): void => {
      if (!this.running) return;
      requestAnimationFrame(loop);
      this.fly(now);
      if (!this.dirty) { this.rest(now); return; }
      // Where the processor draws, the page stands still meanwhile: while dragging it is left more than half of the time.
      if (this.drawn) { this.cost = now - this.lastDraw; this.drawn = false; }
      if (this.dragging && this.byProcessor && this.cost > 25 && now - this.lastDraw < Math.min(160, 2.5 * this.cost)) return;
      this.drawn = true;
      this.dirty = false;
      this.pace(now);
      this.draw();
    };
    requestAnimationFrame(loop);
  }

  redraw(): void { this.dirty = true; }

  setDark(dark: boolean): void {
    this.dark = dark;
    this.seaKey = '';
    this.placeSea();
    this.redraw();
  }

  setScene(scene: Scene): void {
    this.scene = scene;
    this.still = poseMatrix(scene.vessel.pose);
    this.pipe.setRadius(scene.pipe.outer_radius);
    this.stale = true;
    this.redraw();
  }

  setSolution(solution: Converged): void {
    const first = this.solution === null;
    this.solution = solution;
    this.stale = true;
    this.redraw();
    if (first) this.go(this.view ?? 'whole', false);
    else if (this.view && !this.dragging) this.go(this.view);
  }

  /** While a value is dragged the camera stands still and only what moves is drawn, with coarser pixels. */
  setDragging(on: boolean): void {
    if (on === this.dragging) return;
    this.dragging = on;
    if (on) {
      this.flight = null;
      const least = this.byProcessor ? 0.5 : 1 / Math.min(2, devicePixelRatio);
      if (this.coarse > least) { this.coarse = least; this.setPixels(); }
    } else {
      this.stale = true;
      this.lastLabels = -Infinity;
    }
    this.redraw();
  }

  /** Another model: look at it afresh. */
  reset(): void { this.solution = null; this.view = 'whole'; this.rigKey = ''; }

  /** Brings what is drawn up to the newest solution: once a picture, however many solutions came since the last. */
  private refresh(): void {
    if (!this.stale || !this.solution) return;
    this.stale = false;
    if (!this.moment) this.setPipe(this.solution);
    this.build();
    const c = this.colouring;
    if (c) this.pipe.setColours(c.values, c.low, c.high, 'stress');
  }

  private setPipe(s: Converged): void {
    const n = s.pipe.s.length;
    const points = new Float32Array(3 * n);
    for (let i = 0; i < n; ++i) { points[3 * i] = s.pipe.x[i]!; points[3 * i + 1] = s.pipe.y[i]!; points[3 * i + 2] = s.pipe.z[i]!; }
    this.pipe.setPlaces(points);
  }

  setColouring(c: Colouring): void {
    this.colouring = c;
    if (this.stale) { this.redraw(); return; }
    this.pipe.setColours(c.values, c.low, c.high, 'stress');
    this.redraw();
  }

  setCursor(index: number | null): void {
    const p = this.pipe.points;
    this.marker.visible = index !== null && 3 * index + 2 < p.length;
    if (this.marker.visible) this.marker.position.set(p[3 * index!]!, p[3 * index! + 1]!, p[3 * index! + 2]!);
    this.redraw();
  }

  /** A moment of a run; null goes back to statics. */
  setMoment(moment: Moment | null): void {
    if (!this.scene) return;
    dispose(this.flashGroup);
    if (!moment && !this.moment) return;
    this.moment = moment;
    this.pointArrow(moment?.tensioner ?? null);
    if (!moment) {
      this.rollers.endReactions();
      this.stale = true;
      this.afloat.matrix.identity();
      this.sea.setTime(null);
    } else {
      this.pipe.setPlaces(moment.places);
      this.afloat.matrix.multiplyMatrices(poseMatrix(moment.pose), this.still.clone().invert());
      this.sea.setTime(moment.time);
      this.rollers.setReactions(moment.reactions, moment.largest);
      for (const f of moment.flashes) this.flash(f);
    }
    this.afloat.matrixWorldNeedsUpdate = true;
    this.redraw();
  }

  /** Beside the tensioner, the way the pipe is going through it. */
  private pointArrow(t: Moment['tensioner']): void {
    this.arrow.visible = t !== null && (t.way !== 0 || t.limit);
    if (!t || !this.solution) return;
    const along = vec(this.solution.tensioner.direction).normalize();
    const way = t.way || Math.sign(t.travel) || 1;
    this.arrow.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.clone().multiplyScalar(way));
    this.arrow.position.copy(vec(this.solution.tensioner.place)).addScaledVector(along, -2.2 + t.travel).add(new THREE.Vector3(0, 0, 3));
    this.arrowPaint.color.set(t.limit ? '#c3271b' : way > 0 ? '#1f6fd0' : '#7a3fb5');
  }

  private flash(f: Moment['flashes'][number]): void {
    const roller = this.rollers.list.find((r) => r.support.name === f.support && r.row === f.row && r.position === f.position);
    if (!roller) return;
    const glow = new THREE.Mesh(new THREE.SphereGeometry(0.55 + 0.9 * f.strength, 16, 12), new THREE.MeshBasicMaterial({ color: '#ffea00', transparent: true, opacity: 0.25 + 0.6 * f.strength, depthWrite: false }));
    glow.position.copy(roller.center);
    glow.renderOrder = 8;
    this.flashGroup.add(glow);
  }

  private build(): void {
    const { scene, solution } = this;
    if (!scene || !solution) return;
    const largest = Math.max(1, ...solution.supports.flatMap((s) => s.rollers.map((r) => r.reaction)));
    this.rollers.set(solution.supports, largest);
    const rigKey = JSON.stringify([solution.supports.map((s) => s.place), solution.tensioner.place, scene.vessel.pose, scene.pipe]);
    if (rigKey !== this.rigKey) {
      this.rigKey = rigKey;
      dispose(this.rigGroup);
      this.rigGroup.add(rig(solution, scene));
    }
    const key = JSON.stringify([{ ...scene.vessel, pose: 0 }, scene.ramp, scene.tensioner]);
    if (key !== this.hullKey) {
      this.hullKey = key;
      dispose(this.hullGroup);
      this.hullGroup.add(hull(scene.vessel, this.slotDepth(scene)));
    }
    this.hullGroup.matrix.copy(this.still);
    this.hullGroup.matrixWorldNeedsUpdate = true;
    if (!this.dragging || this.seaKey === '' || scene !== this.seaScene) this.placeSea();
    if (!this.dragging) this.labelList = this.makeLabels();
    this.redraw();
  }

  /** How high the deck may reach under the pipe, at a place along the vessel: a metre and more below the rollers. */
  private slotDepth(scene: Scene): (x: number) => number | null {
    const inverse = this.still.clone().invert();
    const list = [scene.tensioner, ...scene.ramp.map((b) => b.place), ...scene.stinger.slice(0, 1).map((b) => b.place)]
      .map((p) => vec(p).applyMatrix4(inverse)).sort((a, b) => a.x - b.x);
    return (x) => {
      if (!list.length || x > list[list.length - 1]!.x) return null;
      const i = Math.max(1, list.findIndex((p) => p.x >= x));
      const a = list[i - 1]!, b = list[i] ?? a;
      const f = b.x === a.x ? 0 : (x - a.x) / (b.x - a.x);
      return a.z + f * (b.z - a.z) - 1.1;
    };
  }

  private placeSea(): void {
    const { scene, solution } = this;
    if (!scene || !solution) return;
    const touch = solution.touchdown?.s ?? Infinity;
    const { forward } = axes(scene);
    const points = [vec(scene.vessel.pose).addScaledVector(forward, 0.62 * scene.vessel.length)];
    solution.pipe.s.forEach((s, i) => { if (s <= touch + 80) points.push(new THREE.Vector3(solution.pipe.x[i], solution.pipe.y[i], 0)); });
    const box = new THREE.Box3().setFromPoints(points);
    const wide = Math.max(1.6 * scene.vessel.beam, 0.13 * box.getSize(new THREE.Vector3()).length());
    const step = 20; // whole cells, so that the water does not creep while a value is dragged
    const low = new THREE.Vector2(Math.floor((box.min.x - wide) / step) * step, Math.floor((box.min.y - wide) / step) * step);
    const high = new THREE.Vector2(Math.ceil((box.max.x + wide) / step) * step, Math.ceil((box.max.y + wide) / step) * step);
    const key = JSON.stringify([low, high, scene.seabed, scene.current, scene.waves.length, scene.water_depth, this.dark]);
    if (key === this.seaKey) return;
    this.seaKey = key;
    this.seaScene = scene;
    this.sea.set(scene, low, high, this.dark);
  }

  private makeLabels(): Label[] {
    const { scene, solution } = this;
    if (!scene || !solution) return [];
    const list: Label[] = [{ text: 'tensioner', place: vec(solution.tensioner.place), weight: 5 }];
    if (solution.touchdown) list.push({ text: 'touchdown', place: vec(solution.touchdown.place), weight: 6 });
    for (const s of solution.supports) list.push({ text: s.name, place: vec(s.place).add(new THREE.Vector3(0, 0, 0.6)), weight: s.reaction / 1e9 });
    const o = vec(scene.vessel.pose).addScaledVector(axes(scene).forward, 0.33 * scene.vessel.length);
    list.push({ text: scene.vessel.name, place: o.add(new THREE.Vector3(0, 0, scene.vessel.height - scene.vessel.draught + 11)), weight: 7 });
    return list;
  }

  go(name: ViewName, smooth = true): void {
    if (!this.scene || !this.solution) return;
    this.view = name;
    const to = shot(name, this.solution, this.scene, this.camera);
    if (smooth && !matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.flight = { from: [this.camera.position.clone(), this.controls.target.clone()], to: [to.eye, to.target], start: performance.now() };
    } else {
      this.flight = null;
      this.camera.position.copy(to.eye);
      this.controls.target.copy(to.target);
      this.controls.update();
    }
    this.redraw();
  }

  private fly(now: number): void {
    if (!this.flight) return;
    const f = Math.min(1, (now - this.flight.start) / 420);
    const e = f * f * (3 - 2 * f);
    this.camera.position.lerpVectors(this.flight.from[0], this.flight.to[0], e);
    this.controls.target.lerpVectors(this.flight.from[1], this.flight.to[1], e);
    this.controls.update();
    if (f >= 1) this.flight = null;
    this.redraw();
  }

  /** Coarser pixels while pictures follow each other too slowly. */
  private pace(now: number): void {
    const gap = now - this.lastDraw;
    this.lastDraw = now;
    if (gap > 400) { this.slow = 0; return; }
    this.slow = gap > 45 ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.slow >= 3 && this.coarse > 0.45) { this.coarse *= 0.75; this.slow = 0; this.setPixels(); }
  }

  /** Full sharpness again when the picture stands still. */
  private rest(now: number): void {
    if (this.dragging || this.coarse === 1 || now - this.lastDraw < 350) return;
    this.coarse = 1;
    this.setPixels();
    this.draw();
    this.lastDraw = -Infinity;
  }

  private setPixels(): void {
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio) * this.coarse);
    this.renderer.setSize(this.width, this.height);
  }

  private resize(): void {
    const r = this.box.getBoundingClientRect();
    this.width = Math.max(1, Math.floor(r.width));
    this.height = Math.max(1, Math.floor(r.height));
    this.setPixels();
    this.camera.aspect = this.width / this.height;
    this.camera.updateProjectionMatrix();
    if (this.view) this.go(this.view, false);
    // at once, or the emptied canvas would flash
    this.draw();
  }

  private draw(): void {
    this.refresh();
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(0.05, distance / 400);
    this.camera.far = distance * 8 + 3000;
    this.camera.updateProjectionMatrix();
    seeThrough(this.scene !== null && distance < 1.15 * this.scene.vessel.length);
    const pixel = (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / this.height;
    // thicker on large screens, where the letters are larger too
    this.pipe.setPixel(pixel * Math.max(1, this.height / 520));
    if (this.marker.visible) {
      const away = this.camera.position.distanceTo(this.marker.position);
      this.marker.scale.setScalar(Math.max(5.5 * pixel * away, 0));
    }
    this.renderer.render(this.world, this.camera);
    // moving names costs a layout of the page: a few times a second are enough while a value is dragged
    const now = performance.now();
    if (!this.dragging || now - this.lastLabels > 200) {
      this.lastLabels = now;
      this.labels.draw(this.labelList, this.camera, this.width, this.height);
    }
    ++this.frames;
  }

  /** Stations and rollers under the pointer. Both are looked for on the screen, so that thin things can be hit. */
  private pick(x: number, y: number): Picked {
    const p = new THREE.Vector3();
    let best: Picked = null;
    let closest = 14;
    const depthOf = (): number => { p.project(this.camera); return p.z < 1 ? Math.hypot(((p.x + 1) / 2) * this.width - x, ((1 - p.y) / 2) * this.height - y) : Infinity; };
    for (const roller of this.rollers.list) {
      p.copy(roller.center).applyMatrix4(this.afloat.matrix);
      const away = this.camera.position.distanceTo(p);
      if (away > 60) continue; // too small to be meant
      const d = depthOf();
      if (d < closest) { closest = d; best = { kind: 'roller', roller }; }
    }
    const points = this.pipe.points;
    for (let i = 0; i + 2 < points.length; i += 3) {
      p.set(points[i]!, points[i + 1]!, points[i + 2]!);
      const d = depthOf();
      if (d < closest - (best?.kind === 'roller' ? 3 : 0)) { closest = d; best = { kind: 'station', index: i / 3 }; }
    }
    return best;
  }

  private listen(): void {
    const canvas = this.renderer.domElement;
    let down: [number, number] | null = null;
    let last = 0;
    const local = (e: PointerEvent): [number, number] => { const r = canvas.getBoundingClientRect(); return [e.clientX - r.left, e.clientY - r.top]; };
    canvas.addEventListener('pointerdown', (e) => { down = local(e); });
    canvas.addEventListener('pointerup', (e) => {
      const at = local(e);
      if (down && Math.hypot(at[0] - down[0], at[1] - down[1]) < 4) this.onPick(this.pick(...at), ...at);
      down = null;
    });
    canvas.addEventListener('pointermove', (e) => {
      if (e.buttons || performance.now() - last < 30) return;
      last = performance.now();
      const hit = this.pick(...local(e));
      this.onHover(hit?.kind === 'station' ? hit.index : null);
    });
    canvas.addEventListener('pointerleave', () => this.onHover(null));
  }

  get activeView(): ViewName | null { return this.view; }

  dispose(): void {
    this.running = false;
    this.observer.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.box.replaceChildren();
  }
}

export { viewNames };
export type { ViewName };
