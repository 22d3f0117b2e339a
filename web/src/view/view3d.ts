// The three-dimensional picture. It is drawn again only when something has changed.
import * as THREE from 'three';
import type { Lay, Scene } from '../api/types';
import type { ViewName } from '../logic/views';
import { Flight } from './flight';
import { seeThrough } from './hull';
import { Labels } from './labels';
import { followPointer, pick, type Picked } from './picking';
import { Stage, type Colouring, type DrawnParts, type Moment, type MooredStage } from './stage';

/** Without a graphics card every sample of a pixel costs: smooth edges are then given up for pictures a second. */
function drawnByProcessor(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  const names = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = names ? String(gl!.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class View3D {
  onPick: (p: Picked, x: number, y: number) => void = () => undefined;
  onHover: (index: number | null) => void = () => undefined;
  frames = 0;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly world = new THREE.Scene();
  private readonly flight: Flight;
  private readonly stage = new Stage();
  private readonly marker: THREE.Mesh;
  private readonly labels: Labels;
  private dirty = true;
  private width = 1;
  private height = 1;
  private readonly observer: ResizeObserver;
  private running = true;
  private coarse = 1;
  private slow = 0;
  private lastDraw = -Infinity;
  private lastLabels = -Infinity;
  private dragging = false;
  private drawn = false; // in the turn before
  private cost = 0; // of a picture: ms from its drawing to the next turn of the page
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

    const sun = new THREE.DirectionalLight('#ffffff', 2.1);
    sun.position.set(-0.4, -1, 1.6);
    const back = new THREE.DirectionalLight('#cfe4ff', 0.7);
    back.position.set(0.6, 1, 0.5);
    this.world.add(sun, back, new THREE.HemisphereLight('#eaf4ff', '#8a7d63', 1.25));
    this.marker = new THREE.Mesh(new THREE.SphereGeometry(1, 20, 14), new THREE.MeshBasicMaterial({ color: '#ff2d7a', transparent: true, opacity: 0.9, depthTest: false }));
    this.marker.renderOrder = 10;
    this.marker.visible = false;
    this.world.add(this.stage.group, this.marker);

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
    this.stage.dark = dark;
    this.stage.placeSea();
    this.redraw();
  }

  setScene(scene: Scene): void { this.taken({ scene }); }
  setSolution(solution: Lay): void { this.taken({ solution }); }

  /** Scene and solution come in any order: whichever is the second makes the picture. */
  private taken(part: { scene?: Scene; solution?: Lay }): void {
    this.stage.take(part);
    this.redraw();
    const { scene, solution } = this.stage;
    if (scene && solution) this.flight.follow(solution, scene, this.dragging);
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
      this.stage.spoil();
      this.lastLabels = -Infinity;
    }
    this.redraw();
  }

  /** Another model: nothing of the old one is shown, and the new one is looked at afresh. */
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

  /** A moment of a run; null goes back to statics. */
  setMoment(moment: Moment | null): void { if (this.stage.setMoment(moment)) this.redraw(); }

  go(name: ViewName, smooth = true): void {
    const { scene, solution } = this.stage;
    if (scene && solution) this.flight.go(name, solution, scene, smooth);
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
    this.renderer.render(this.world, this.camera);
    // moving names costs a layout of the page: a few times a second are enough while a value is dragged
    const now = performance.now();
    if (!this.dragging || now - this.lastLabels > 200) {
      this.lastLabels = now;
      this.labels.draw(this.stage.labels, this.camera, this.width, this.height);
    }
    ++this.frames;
  }

  private listen(): void {
    const at = (x: number, y: number): Picked => pick({ camera: this.camera, width: this.width, height: this.height, points: this.stage.pipe.points, rollers: this.stage.rollers.list, lines: this.stage.moorings.lines, afloat: this.stage.afloat.matrix }, x, y);
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

export type { Picked, ViewName };
