// The three-dimensional picture. It is drawn again only when something has changed.
import * as THREE from 'three';
import type { Lay, Scene } from '../api/types';
import { TensionerArrow, type Machine } from './arrows';
import { viewNames, type ViewName } from './cameras';
import { Flight } from './flight';
import { hull, seeThrough, slotDepth } from './hull';
import { labelsOf, Labels, type Label } from './labels';
import { dispose } from './members';
import { followPointer, pick, type Picked } from './picking';
import { PipeView } from './pipe';
import { rig } from './rig';
import { RollersView } from './rollers';
import { seaCorners, SeaView } from './sea';

export interface Colouring { values: ArrayLike<number> | null; low: number; high: number }
export interface Moment {
  time: number; pose: number[]; places: Float32Array;
  flashes: { support: string; row: number; position: string; strength: number }[];
  /** Reactions of the boxes at the moment, as far as they are known; the largest of the run. */
  reactions: Map<string, number>; largest: number;
  tensioner: Machine | null;
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
  onPick: (p: Picked, x: number, y: number) => void = () => undefined;
  onHover: (index: number | null) => void = () => undefined;
  frames = 0;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly world = new THREE.Scene();
  private readonly flight: Flight;
  private readonly pipe = new PipeView();
  private readonly rollers = new RollersView();
  private readonly sea = new SeaView();
  private readonly drawnThings = new THREE.Group(); // unseen until there is a scene and a solution
  private readonly afloat = new THREE.Group(); // moves with the vessel
  private readonly hullGroup = new THREE.Group();
  private readonly rigGroup = new THREE.Group();
  private readonly marker: THREE.Mesh;
  private readonly flashGroup = new THREE.Group();
  private readonly labels: Labels;
  private labelList: Label[] = [];
  private scene: Scene | null = null;
  private solution: Lay | null = null;
  private still = new THREE.Matrix4();
  private dirty = true;
  private dark = false;
  private width = 1;
  private height = 1;
  private hullKey = '';
  private seaKey = '';
  private waves: Scene['waves'] | null = null;
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
  private readonly arrow = new TensionerArrow();

  constructor(private readonly box: HTMLElement) {
    this.renderer = new THREE.WebGLRenderer({ antialias: !this.byProcessor, alpha: true, powerPreference: 'high-performance' });
    this.renderer.domElement.setAttribute('aria-hidden', 'true');
    box.append(this.renderer.domElement);
    const overlay = document.createElement('div');
    overlay.className = 'labels3d';
    overlay.setAttribute('aria-hidden', 'true');
    box.append(overlay);
    this.labels = new Labels(overlay);
    this.flight = new Flight(this.renderer.domElement, () => this.redraw());

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
    this.afloat.add(this.hullGroup, this.rigGroup, this.rollers.group, this.flashGroup, this.arrow.group);
    this.drawnThings.add(this.afloat, this.pipe.mesh, this.sea.group, this.marker);
    this.drawnThings.visible = false;
    this.world.add(this.drawnThings);

    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(box);
    this.resize();
    this.listen();
    const loop = (now: number): void => {
      if (!this.running) return;
      requestAnimationFrame(loop);
      this.flight.fly(now);
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
    this.taken();
  }

  setSolution(solution: Lay): void {
    this.solution = solution;
    this.taken();
  }

  /** Scene and solution come in any order: whichever is the second makes the picture. */
  private taken(): void {
    this.stale = true;
    this.redraw();
    if (!this.scene || !this.solution) return;
    this.drawnThings.visible = true;
    this.flight.follow(this.solution, this.scene, this.dragging);
  }

  /** While a value is dragged the camera stands still and only what moves is drawn, with coarser pixels. */
  setDragging(on: boolean): void {
    if (on === this.dragging) return;
    this.dragging = on;
    if (on) {
      this.flight.stop();
      const least = this.byProcessor ? 0.5 : 1 / Math.min(2, devicePixelRatio);
      if (this.coarse > least) { this.coarse = least; this.setPixels(); }
    } else {
      this.stale = true;
      this.lastLabels = -Infinity;
    }
    this.redraw();
  }

  /** Another model: nothing of the old one is shown, and the new one is looked at afresh. */
  reset(): void {
    this.scene = null;
    this.solution = null;
    this.rigKey = '';
    this.labelList = [];
    this.drawnThings.visible = false;
    this.flight.reset();
    this.redraw();
  }

  /** Brings what is drawn up to the newest solution: once a picture, however many solutions came since the last. */
  private refresh(): void {
    if (!this.stale || !this.solution || !this.scene) return;
    this.stale = false;
    if (!this.moment) this.setPipe(this.solution);
    this.build();
    const c = this.colouring;
    if (c) this.pipe.setColours(c.values, c.low, c.high, 'stress');
  }

  private setPipe(s: Lay): void {
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
    this.arrow.point(moment?.tensioner ?? null, this.solution);
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
      this.hullGroup.add(hull(scene.vessel, slotDepth(scene, this.still)));
    }
    this.hullGroup.matrix.copy(this.still);
    this.hullGroup.matrixWorldNeedsUpdate = true;
    if (!this.dragging || this.seaKey === '' || scene.waves !== this.waves) this.placeSea();
    if (!this.dragging) this.labelList = labelsOf(scene, solution);
    this.redraw();
  }

  private placeSea(): void {
    const { scene, solution } = this;
    if (!scene || !solution) return;
    const [low, high] = seaCorners(scene, solution);
    const key = JSON.stringify([low, high, scene.seabed, scene.current, scene.water_depth, this.dark]);
    if (key === this.seaKey && scene.waves === this.waves) return;
    this.seaKey = key;
    this.waves = scene.waves;
    this.sea.set(scene, low, high, this.dark);
  }

  go(name: ViewName, smooth = true): void {
    if (this.scene && this.solution) this.flight.go(name, this.solution, this.scene, smooth);
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
    this.flight.fit(this.width / this.height);
    if (this.flight.view) this.go(this.flight.view, false);
    // at once, or the emptied canvas would flash
    this.draw();
  }

  private draw(): void {
    this.refresh();
    this.flight.fit(this.width / this.height);
    seeThrough(this.scene !== null && this.flight.distance < 1.15 * this.scene.vessel.length);
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

  private listen(): void {
    const at = (x: number, y: number): Picked => pick({ camera: this.camera, width: this.width, height: this.height, points: this.pipe.points, rollers: this.rollers.list, afloat: this.afloat.matrix }, x, y);
    followPointer(this.renderer.domElement, (x, y) => this.onPick(at(x, y), x, y), (x, y) => {
      const hit = at(x, y);
      this.onHover(hit?.kind === 'station' ? hit.index : null);
    }, () => this.onHover(null));
  }

  get camera(): THREE.PerspectiveCamera { return this.flight.camera; }
  get activeView(): ViewName | null { return this.flight.view; }

  dispose(): void {
    this.running = false;
    this.observer.disconnect();
    this.flight.controls.dispose();
    this.renderer.dispose();
    this.box.replaceChildren();
  }
}

export { viewNames };
export type { Picked, ViewName };
