// The camera: its position, flights between the views, and mouse control.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Lay, Scene } from '../api/types';
import { firstView, availableViews, type ViewName } from '../logic/views';
import { shot, type Shot } from './cameras';

const flightTime = 420; // ms

export class Flight {
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.2, 5000);
  readonly controls: OrbitControls;
  /** The view that is kept while the model changes; null once the user has rotated the picture. */
  view: ViewName | null = 'whole';
  private framed = false;
  private path: { from: [THREE.Vector3, THREE.Vector3]; to: [THREE.Vector3, THREE.Vector3]; start: number } | null = null;

  constructor(canvas: HTMLElement, private readonly moved: () => void) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', moved);
    this.controls.addEventListener('start', () => { this.view = null; this.stop(); });
  }

  get distance(): number { return this.camera.position.distanceTo(this.controls.target); }

  /** Another model: the view is reset. */
  reset(): void { this.view = 'whole'; this.framed = false; this.stop(); }
  stop(): void { this.path = null; }

  /** Scene or solution have changed: follows them with the kept view; without animation for the first picture. */
  follow(solution: Lay, scene: Scene, keepView: boolean): void {
    if (!this.framed) this.go(this.view && availableViews(solution).includes(this.view) ? this.view : firstView(solution), solution, scene, false);
    else if (this.view && !keepView) this.go(this.view, solution, scene, true);
  }

  go(name: ViewName, solution: Lay, scene: Scene, smooth: boolean): void {
    const to = shot(name, solution, scene, this.camera);
    if (!to) return;
    this.view = name;
    // an unchanged solution does not move the camera: the picture stays sharp
    if (smooth && this.framed && !this.path && this.isAt(to)) return;
    if (smooth && this.framed && !matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.path = { from: [this.camera.position.clone(), this.controls.target.clone()], to: [to.eye, to.target], start: performance.now() };
    } else {
      this.stop();
      this.camera.position.copy(to.eye);
      this.controls.target.copy(to.target);
      this.controls.update();
    }
    this.framed = true;
    this.moved();
  }

  /** Moves closer to a position, keeping the viewing direction. */
  approach(place: THREE.Vector3, distance: number): void {
    const back = this.camera.position.clone().sub(this.controls.target).normalize();
    this.view = null;
    this.path = { from: [this.camera.position.clone(), this.controls.target.clone()], to: [place.clone().addScaledVector(back, distance), place.clone()], start: performance.now() };
    this.moved();
  }

  private isAt(to: Shot): boolean {
    const near = 1e-4 * to.eye.distanceTo(to.target); // less than a tenth of a pixel
    return this.camera.position.distanceTo(to.eye) < near && this.controls.target.distanceTo(to.target) < near;
  }

  /** Continues a flight, if there is one. */
  fly(time: number): void {
    if (!this.path) return;
    const f = Math.min(1, (time - this.path.start) / flightTime);
    const e = f * f * (3 - 2 * f);
    this.camera.position.lerpVectors(this.path.from[0], this.path.to[0], e);
    this.controls.target.lerpVectors(this.path.from[1], this.path.to[1], e);
    this.controls.update();
    if (f >= 1) this.stop();
    this.moved();
  }

  /** Near and far plane of the drawing, by the viewing distance. */
  fit(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.near = Math.max(0.05, this.distance / 400);
    this.camera.far = this.distance * 8 + 3000;
    this.camera.updateProjectionMatrix();
  }
}
