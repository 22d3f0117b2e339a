// The pipe: a tube with its true radius, drawn thicker only if it would be thinner than a few pixels on the screen.
import * as THREE from 'three';
import { valueShares, type Rgb, type ValueScale } from '../components/colourScale';
import type { PartName } from '../logic/operation';
import { tube, tubeIndices, type Tube } from '../logic/tube';

const sides = 14;

export class PipeView {
  readonly mesh: THREE.Mesh;
  private geometry = new THREE.BufferGeometry();
  private shape: Tube | undefined;
  private colours = new Float32Array(0);
  private thickness = new Float32Array(0);
  private readonly uniforms = { radius: { value: 0.25 }, pixel: { value: 0.001 }, least: { value: 1.5 } };
  points: Float32Array = new Float32Array(0);

  constructor() {
    const material = new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.55, metalness: 0.05 });
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, { pipeRadius: this.uniforms.radius, pixelSize: this.uniforms.pixel, leastPixels: this.uniforms.least });
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', '#include <common>\nattribute float thickness; uniform float pipeRadius; uniform float pixelSize; uniform float leastPixels;')
        .replace('#include <begin_vertex>', `
          float away = -(modelViewMatrix * vec4(position, 1.0)).z;
          vec3 transformed = position + normal * max(pipeRadius * thickness, leastPixels * clamp(thickness, 0.5, 1.7) * pixelSize * max(away, 0.0));`);
    };
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** The pipe ends at the edge of the drawn sea. */
  setBounds(low: THREE.Vector2, high: THREE.Vector2): void {
    const plane = (x: number, y: number, c: number): THREE.Plane => new THREE.Plane(new THREE.Vector3(x, y, 0), c);
    (this.mesh.material as THREE.Material).clippingPlanes = [plane(1, 0, -low.x), plane(-1, 0, high.x), plane(0, 1, -low.y), plane(0, -1, high.y)];
  }

  /** World size of a pixel at unit distance. */
  setPixel(size: number): void { this.uniforms.pixel.value = size; }
  setRadius(radius: number): void { this.uniforms.radius.value = radius; }
  /** Minimum radius on the screen, in pixels. */
  setLeast(pixels: number): void { this.uniforms.least.value = pixels; }

  setPlaces(points: Float32Array): void {
    this.points = points;
    const old = this.shape;
    this.shape = tube(points, sides, old);
    if (this.shape !== old) {
      // with spare capacity: the number of stations varies slightly between solutions
      const room = Math.ceil(1.25 * this.shape.stations);
      const grown = { centres: new Float32Array(3 * room * sides), normals: new Float32Array(3 * room * sides), stations: room, sides };
      this.shape = tube(points, sides, grown);
      this.geometry.dispose();
      this.geometry = new THREE.BufferGeometry();
      this.colours = new Float32Array(grown.centres.length).fill(0.6);
      this.geometry.setAttribute('position', new THREE.BufferAttribute(this.shape.centres, 3));
      this.geometry.setAttribute('normal', new THREE.BufferAttribute(this.shape.normals, 3));
      this.thickness = new Float32Array(room * sides).fill(1);
      this.geometry.setAttribute('thickness', new THREE.BufferAttribute(this.thickness, 1));
      this.geometry.setAttribute('color', new THREE.BufferAttribute(this.colours, 3));
      this.geometry.setIndex(new THREE.BufferAttribute(tubeIndices(room, sides), 1));
      this.mesh.geometry = this.geometry;
    } else {
      this.geometry.getAttribute('position').needsUpdate = true;
      this.geometry.getAttribute('normal').needsUpdate = true;
    }
    this.geometry.setDrawRange(0, Math.max(0, this.shape.stations - 1) * sides * 6);
  }

  /** Thickness at every station, relative to the pipe radius; null: 1. */
  setThickness(of: ((i: number) => number) | null): void {
    const n = this.shape?.stations ?? 0;
    for (let i = 0; i < n; ++i) this.thickness.fill(of ? of(i) : 1, i * sides, (i + 1) * sides);
    const attribute = this.geometry.getAttribute('thickness');
    if (attribute) attribute.needsUpdate = true;
  }

  /** A uniform colour. */
  setColour(colour: string): void {
    const uniform = new THREE.Color(colour);
    const n = (this.shape?.stations ?? 0) * sides;
    for (let i = 0; i < n; ++i) uniform.toArray(this.colours, 3 * i);
    const attribute = this.geometry.getAttribute('color');
    if (attribute) attribute.needsUpdate = true;
  }

  setColours(values: ArrayLike<number> | null, scale: ValueScale, parts: { partAt: (i: number) => PartName; colours: Record<'head' | 'cable', string> } | null = null): void {
    const n = this.shape?.stations ?? 0;
    const rgb: Rgb = [0, 0, 0];
    const linear = new THREE.Color();
    for (let i = 0; i < n; ++i) {
      const part = parts?.partAt(i) ?? 'pipe';
      if (part !== 'pipe') linear.set(parts!.colours[part]);
      else if (values) linear.setRGB(...valueShares(scale, values[i]!, rgb), THREE.SRGBColorSpace);
      else linear.setRGB(0.55, 0.58, 0.61, THREE.SRGBColorSpace);
      for (let j = 0, k = i * sides * 3; j < sides; ++j) { this.colours[k++] = linear.r; this.colours[k++] = linear.g; this.colours[k++] = linear.b; }
    }
    const attribute = this.geometry.getAttribute('color');
    if (attribute) attribute.needsUpdate = true;
  }
}
