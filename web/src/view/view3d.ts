// The three-dimensional picture. It is drawn again only when something has changed.
import * as THREE from 'three';
import type { Lay, Scene, Vector } from '../api/types';
import type { Rect } from '../logic/labelPlaces';
import type { ViewName } from '../logic/views';
import { Flight } from './flight';
import { seeThrough } from './hull';
import { Labels, type ShownName } from './labels';
import { followPointer, pick, placeUnder, type Picked, type Target } from './picking';
import { Pace } from './pace';
import { RulerLine } from './rulerLine';
import { axes } from './cameras';
import { vec } from './members';
import { cursorMark, drawnByProcessor, lights } from './world';
import { Stage, type Colouring, type DrawnParts, type Moment, type MooredStage } from './stage';

export class View3D {
  onPick: (p: Picked, x: number, y: number) => void = () => undefined;
  onHover: (index: number | null) => void = () => undefined;
  frames = 0;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly world = new THREE.Scene();
  private readonly flight: Flight;
  private readonly stage = new Stage();
  private readonly marker = cursorMark();
  private readonly labels: Labels;
  private dirty = true;
  private width = 1;
  private height = 1;
  private readonly observer: ResizeObserver;
  private running = true;
  private paused = false;
  private readonly ruler = new RulerLine();
  private readonly sharpness = new Pace();
  private lastLabels = -Infinity;
  private dragging = false;
  private drawn = false; // in the previous turn
  private cost = 0; // of a frame: ms from its drawing to the next turn of the page
  private readonly byProcessor = drawnByProcessor();

  constructor(private readonly box: HTMLElement) {
    this.renderer = new THREE.WebGLRenderer({ antialias: !this.byProcessor, alpha: true, powerPreference: 'high-performance' });
    this.renderer.localClippingEnabled = true;
    this.renderer.domElement.setAttribute('aria-hidden', 'true');
    box.append(this.renderer.domElement);
    const overlay = document.createElement('div');
    overlay.className = 'labels3d';
    overlay.setAttribute('aria-hidden', 'true');
    box.append(overlay);
    this.labels = new Labels(overlay);
    this.flight = new Flight(this.renderer.domElement, () => this.redraw());

    this.world.add(...lights(), this.stage.group, this.marker, this.ruler.group);

    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(box);
    this.resize();
    this.listen();
    const loop = (time: number): void => {
      if (!this.running) return;
      requestAnimationFrame(loop);
      if (this.paused) return;
      this.flight.fly(time);
      if (!this.dirty) { this.rest(time); return; }
      // With software rendering the page is blocked meanwhile: during a drag it gets more than half of the time.
      if (this.drawn) { this.cost = this.sharpness.since(time); this.drawn = false; }
      if (this.dragging && this.byProcessor && this.cost > 25 && this.sharpness.since(time) < Math.min(160, 2.5 * this.cost)) return;
      this.drawn = true;
      this.dirty = false;
      if (this.sharpness.next(time)) this.setPixels();
      this.draw();
    };
    requestAnimationFrame(loop);
  }

  redraw(): void { this.dirty = true; }

  /** Not drawn while a drawing replaces it. */
  setPaused(on: boolean): void { this.paused = on; if (!on) this.redraw(); }

  /** Rectangles over the picture that names avoid [px]. */
  keepClear(taken: Rect[]): void { this.labels.taken = taken; this.lastLabels = -Infinity; this.redraw(); }

  /** Marks a box. */
  chooseBox(name: string | null): void {
    this.stage.rollers.choose(name);
    this.labels.chosen = name ?? '';
    this.lastLabels = -Infinity;
    this.redraw();
  }

  setRuler(points: readonly Vector[]): void { this.ruler.set(points); this.redraw(); }

  /** Flies to a box. */
  approachBox(name: string): void {
    const box = this.stage.solution?.supports.find((s) => s.name === name);
    if (box) this.flight.approach(vec(box.place).applyMatrix4(this.stage.afloat.matrix), 16);
  }

  /** World position of a point of the picture. */
  placeUnder(x: number, y: number): Vector | null {
    const { scene, solution } = this.stage;
    const place = solution?.tensioner?.place ?? scene?.vessel?.pose, point = place ? vec(place) : null;
    const normal = scene?.vessel ? axes(scene.vessel).port : new THREE.Vector3(0, 1, 0);
    return placeUnder(this.target, x, y, point && { point, normal })?.toArray() ?? null;
  }

  /** The picture with its names, in pixels of the screen. */
  snapshot(): { canvas: HTMLCanvasElement; width: number; height: number; names: readonly ShownName[] } {
    this.sharpness.coarse = 1;
    this.setPixels();
    this.lastLabels = -Infinity;
    this.draw();
    return { canvas: this.renderer.domElement, width: this.width, height: this.height, names: this.labels.shown };
  }

  setDark(dark: boolean): void {
    this.stage.dark = dark;
    this.stage.placeSea();
    this.redraw();
  }

  setScene(scene: Scene): void { this.taken({ scene }); }
  setSolution(solution: Lay): void { this.taken({ solution }); }

  /** Scene and solution arrive in any order: the second one makes the picture. */
  private taken(part: { scene?: Scene; solution?: Lay }): void {
    this.stage.take(part);
    this.redraw();
    const { scene, solution } = this.stage;
    if (scene && solution) this.flight.follow(solution, scene, this.dragging);
  }

  /** During a drag the camera is fixed and only moving parts are drawn, with coarser pixels. */
  setDragging(on: boolean): void {
    if (on === this.dragging) return;
    this.dragging = on;
    if (on) {
      this.flight.stop();
      const least = this.byProcessor ? 0.5 : 1 / Math.min(2, devicePixelRatio);
      if (this.sharpness.lower(least)) this.setPixels();
    } else {
      this.stage.spoil();
      this.lastLabels = -Infinity;
    }
    this.redraw();
  }

  /** Another model: the previous one is cleared, and the view is reset. */
  reset(): void {
    this.stage.clear();
    this.marker.visible = false;
    this.flight.reset();
    this.redraw();
  }

  setColouring(c: Colouring): void { this.stage.setColouring(c); this.redraw(); }

  setCursor(index: number | null): void {
    const p = this.stage.pipe.points;
    this.marker.visible = index !== null && 3 * index + 2 < p.length;
    if (this.marker.visible) this.marker.position.set(p[3 * index!]!, p[3 * index! + 1]!, p[3 * index! + 2]!);
    this.redraw();
  }

  setStage(stage: MooredStage | null): void { this.stage.setStage(stage); this.redraw(); }
  setParts(parts: DrawnParts | null): void { this.stage.setParts(parts); this.redraw(); }
  choose(line: string | null): void { this.stage.choose(line); this.redraw(); }

  /** An instant of a run; null returns to statics. */
  setMoment(moment: Moment | null): void { if (this.stage.setMoment(moment)) this.redraw(); }

  go(name: ViewName, smooth = true): void {
    const { scene, solution } = this.stage;
    if (scene && solution) this.flight.go(name, solution, scene, smooth);
  }

  /** Full resolution when the picture is at rest. */
  private rest(time: number): void {
    if (this.dragging || !this.sharpness.rest(time)) return;
    this.setPixels();
    this.draw();
  }

  /** 1 if the picture is at full resolution. */
  get coarse(): number { return this.sharpness.coarse; }

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
    this.stage.refresh(this.dragging);
    this.flight.fit(this.width / this.height);
    const { scene } = this.stage;
    const { vessel } = scene ?? {};
    seeThrough(!!vessel && (this.stage.solution?.tensioner ?? null) !== null && this.flight.distance < 1.15 * vessel.length);
    const pixel = (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / this.height;
    // thicker on large screens, where the letters are larger too
    this.stage.pipe.setPixel(pixel * Math.max(1, this.height / 520));
    this.stage.moorings.setPixel(pixel * Math.max(1, this.height / 520));
    this.stage.moorings.face(this.camera);
    if (this.marker.visible) {
      const away = this.camera.position.distanceTo(this.marker.position);
      this.marker.scale.setScalar(Math.max(5.5 * pixel * away, 0));
    }
    this.ruler.face(this.camera, pixel);
    this.renderer.render(this.world, this.camera);
    // moving names requires a page layout: a few times a second are enough during a drag
    const time = performance.now();
    if (!this.dragging || time - this.lastLabels > 200) {
      this.lastLabels = time;
      this.labels.draw(this.stage.labels, this.camera, this.width, this.height);
    }
    ++this.frames;
  }

  private listen(): void {
    const pickAt = (x: number, y: number): Picked => pick(this.target, x, y);
    followPointer(this.renderer.domElement, (x, y) => this.onPick(pickAt(x, y), x, y), (x, y) => {
      const hit = pickAt(x, y);
      this.onHover(hit?.kind === 'station' ? hit.index : null);
    }, () => this.onHover(null));
  }

  private get target(): Target {
    const { pipe, rollers, moorings, afloat } = this.stage;
    return { camera: this.camera, width: this.width, height: this.height, points: pipe.points, rollers: rollers.list, lines: moorings.lines, afloat: afloat.matrix };
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

export type { Picked, ViewName };
