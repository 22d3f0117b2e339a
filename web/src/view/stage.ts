// Contents of the picture: updated to a scene, a solution, and an instant of a run.
import * as THREE from 'three';
import type { ValueScale } from '../components/colourScale';
import type { Lay, LineParts, MooredState, Scene, Vessel } from '../api/types';
import { partAt, partColours, type PartName } from '../logic/operation';
import { TensionerArrow, type Machine } from './arrows';
import { hull, slotDepth } from './hull';
import { makeLabels, type Label } from './labels';
import { dispose } from './members';
import { MooringsView, ofLines, recordedLines, ofMoorings } from './moorings';
import { PipeView } from './pipe';
import { rig } from './rig';
import { RollersView } from './rollers';
import { seaCorners, SeaView, widerCorners } from './sea';

export interface Colouring { values: ArrayLike<number> | null; scale: ValueScale }
/** A stage of an operation, and its vessel pose. */
export interface MooredStage { state: MooredState; pose: number[] }

/** Head and cable parts of the line, and the cable diameter relative to the pipe diameter. */
export interface DrawnParts { parts: LineParts; cable: number }

export interface Moment {
  time: number; pose: number[]; places: Float32Array;
  flashes: { support: string; row: number; position: string; strength: number }[];
  /** Reactions of the boxes at the instant, as far as known; the maximum of the run. */
  reactions: Map<string, number>; largest: number;
  tensioner: Machine | null;
  /** Points of the lines by name, if the run has recorded them. */
  lines?: Map<string, Float32Array> | null;
}

/** A pose of the program as a matrix: the position, then the axes row by row. */
export function poseMatrix(p: number[]): THREE.Matrix4 {
  return new THREE.Matrix4().set(p[3]!, p[4]!, p[5]!, p[0]!, p[6]!, p[7]!, p[8]!, p[1]!, p[9]!, p[10]!, p[11]!, p[2]!, 0, 0, 0, 1);
}

export class Stage {
  readonly group = new THREE.Group();
  readonly pipe = new PipeView();
  readonly rollers = new RollersView();
  readonly sea = new SeaView();
  readonly moorings = new MooringsView();
  readonly afloat = new THREE.Group(); // moves with the vessel
  readonly flashGroup = new THREE.Group();
  scene: Scene | null = null;
  solution: Lay | null = null;
  labels: Label[] = [];
  dark = false;
  private readonly hullGroup = new THREE.Group();
  private readonly rigGroup = new THREE.Group();
  private readonly bodiesGroup = new THREE.Group(); // hulls other than the vessel
  private readonly arrow = new TensionerArrow();
  private restPose = new THREE.Matrix4();
  private colouring: Colouring | null = null;
  private moment: Moment | null = null;
  private stage: MooredStage | null = null;
  private chosen: string | null = null;
  private parts: DrawnParts | null = null;
  private stale = false; // scene, solution or colours have changed since the last drawing
  private hullKey = '';
  private rigKey = '';
  private bodiesKey = '';
  private seaKey = '';
  private waves: Scene['waves'] | null = null;

  constructor() {
    this.afloat.matrixAutoUpdate = false;
    this.hullGroup.matrixAutoUpdate = false;
    this.afloat.add(this.hullGroup, this.rigGroup, this.rollers.group, this.flashGroup, this.arrow.group);
    this.group.add(this.afloat, this.bodiesGroup, this.pipe.mesh, this.moorings.group, this.sea.group);
    this.group.visible = false;
  }

  /** True if there is something to show. */
  get ready(): boolean { return this.scene !== null && this.solution !== null; }

  take(part: { scene?: Scene; solution?: Lay }): void {
    if (part.scene) {
      this.scene = part.scene;
      if (part.scene.vessel) this.restPose = poseMatrix(part.scene.vessel.pose);
      this.pipe.setRadius(part.scene.pipe.outer_radius);
    }
    if (part.solution) this.solution = part.solution;
    this.stale = true;
    this.group.visible = this.ready;
  }

  /** Another model: clears the previous one. */
  clear(): void {
    this.scene = null;
    this.solution = null;
    this.rigKey = '';
    this.labels = [];
    this.group.visible = false;
  }

  spoil(): void { this.stale = true; }

  /** Updates the contents to the latest solution: once per frame, for any number of solutions. */
  refresh(dragging: boolean): void {
    if (!this.stale || !this.solution || !this.scene) return;
    this.stale = false;
    if (!this.moment) this.setPipe(this.solution);
    this.drawLines();
    this.build(this.scene, this.solution, dragging);
    this.colour();
  }

  setColouring(c: Colouring): void {
    this.colouring = c;
    if (!this.stale) this.colour();
  }

  private colour(): void {
    const c = this.colouring;
    const { parts, solution, moment } = this;
    const drawn = parts && solution && !moment ? parts : null;
    const findPart = (i: number): PartName => partAt(drawn!.parts, solution!.pipe.s[i] ?? 0);
    this.pipe.setThickness(drawn ? (i) => ({ pipe: 1, head: 1.6, cable: drawn.cable })[findPart(i)] : null);
    if (c) this.pipe.setColours(c.values, c.scale, drawn ? { partAt: findPart, colours: partColours(this.dark) } : null);
  }

  private setPipe(s: Lay): void {
    const n = s.pipe.s.length;
    const points = new Float32Array(3 * n);
    for (let i = 0; i < n; ++i) { points[3 * i] = s.pipe.x[i]!; points[3 * i + 1] = s.pipe.y[i]!; points[3 * i + 2] = s.pipe.z[i]!; }
    this.pipe.setPlaces(points);
  }

  /** A stage of the operation and its vessel pose; null shows the equilibrium. */
  setStage(stage: MooredStage | null): void {
    this.stage = stage;
    if (!this.moment) this.float();
    this.stale = true;
  }

  /** Line parts of a stage of an operation on the line; null: all is pipe. */
  setParts(parts: DrawnParts | null): void {
    this.parts = parts;
    this.stale = true;
  }

  choose(line: string | null): void {
    this.chosen = line;
    this.stale = true;
  }

  /** The static vessel pose: in equilibrium, or in a stage. */
  private float(): void {
    if (this.stage) this.afloat.matrix.multiplyMatrices(poseMatrix(this.stage.pose), this.restPose.clone().invert());
    else this.afloat.matrix.identity();
    this.afloat.matrixWorldNeedsUpdate = true;
  }

  /** Lines are drawn as computed: in equilibrium, in a stage, or as recorded in a run. */
  private drawLines(): void {
    const rest = this.solution?.moorings?.rest;
    const state = this.stage?.state ?? rest;
    const alone = ofLines(this.solution?.lines ?? []);
    if (this.moment) this.moorings.set(recordedLines([...(rest ? ofMoorings(rest) : []), ...alone], this.moment.lines ?? null), this.chosen);
    else this.moorings.set([...(state ? ofMoorings(state) : []), ...alone], this.chosen);
    this.moorings.mark(this.moment ? null : state ?? null);
    // results of the pipe are those of the equilibrium
    this.pipe.mesh.visible = (this.solution?.pipe.s.length ?? 0) > 1 && (this.moment !== null || this.stage === null);
  }

  /** An instant of a run; null returns to statics. False if nothing has changed. */
  setMoment(moment: Moment | null): boolean {
    if (moment && !this.scene) return false;
    dispose(this.flashGroup);
    if (!moment && !this.moment) return false;
    this.moment = moment;
    this.arrow.point(moment?.tensioner ?? null, this.solution);
    if (!moment) {
      this.rollers.endReactions();
      this.stale = true;
      this.float();
      this.sea.setTime(null);
    } else {
      this.pipe.setPlaces(moment.places);
      this.afloat.matrix.multiplyMatrices(poseMatrix(moment.pose), this.restPose.clone().invert());
      this.sea.setTime(moment.time);
      this.drawLines();
      this.rollers.setReactions(moment.reactions, moment.largest);
      for (const f of moment.flashes) this.flash(f);
    }
    this.afloat.matrixWorldNeedsUpdate = true;
    return true;
  }

  private flash(f: Moment['flashes'][number]): void {
    const roller = this.rollers.list.find((r) => r.support.name === f.support && r.row === f.row && r.position === f.position);
    if (!roller) return;
    const glow = new THREE.Mesh(new THREE.SphereGeometry(0.3 + 0.4 * f.strength, 16, 12), new THREE.MeshBasicMaterial({ color: '#ffea00', transparent: true, opacity: 0.2 + 0.35 * f.strength, depthWrite: false }));
    glow.position.copy(roller.center);
    glow.renderOrder = 8;
    this.flashGroup.add(glow);
  }

  private build(scene: Scene, solution: Lay, dragging: boolean): void {
    const largest = Math.max(1, ...solution.supports.flatMap((s) => s.rollers.map((r) => r.reaction)));
    this.rollers.set(solution.supports, largest);
    const rigKey = JSON.stringify([solution.supports.map((s) => s.place), solution.tensioner?.place, scene.vessel?.pose, scene.pipe]);
    if (rigKey !== this.rigKey) {
      this.rigKey = rigKey;
      dispose(this.rigGroup);
      if (solution.tensioner) this.rigGroup.add(rig(solution, scene));
    }
    const key = JSON.stringify([{ ...scene.vessel, pose: 0 }, scene.ramp, scene.tensioner]);
    if (key !== this.hullKey) {
      this.hullKey = key;
      dispose(this.hullGroup);
      if (scene.vessel) this.hullGroup.add(hull(scene.vessel, slotDepth(scene, this.restPose)));
    }
    this.buildBodies(scene.bodies ?? []);
    this.hullGroup.matrix.copy(this.restPose);
    this.hullGroup.matrixWorldNeedsUpdate = true;
    if (!dragging || this.seaKey === '' || scene.waves !== this.waves) this.placeSea();
    if (!dragging) {
      const moored = this.stage?.state ?? solution.moorings?.rest;
      this.labels = [...makeLabels(scene, solution), ...(moored ? this.moorings.labels(moored) : [])];
    }
  }

  private buildBodies(bodies: Vessel[]): void {
    const key = JSON.stringify(bodies);
    if (key === this.bodiesKey) return;
    this.bodiesKey = key;
    dispose(this.bodiesGroup);
    for (const body of bodies) {
      const drawn = hull(body, () => null);
      drawn.applyMatrix4(poseMatrix(body.pose));
      this.bodiesGroup.add(drawn);
    }
  }

  placeSea(): void {
    const { scene, solution } = this;
    if (!scene || !solution) return;
    const core = seaCorners(scene, solution);
    const [low, high] = widerCorners(core, solution);
    const key = JSON.stringify([low, high, core, scene.seabed, scene.current, scene.water_depth, this.dark]);
    if (key === this.seaKey && scene.waves === this.waves) return;
    this.seaKey = key;
    this.waves = scene.waves;
    this.sea.set(scene, low, high, core, this.dark);
    this.pipe.setBounds(low, high);
    if (this.moment) this.sea.setTime(this.moment.time);
  }
}
