// Common parts of the pictures: lights, mark of the cursor, and detection of software rendering.
import * as THREE from 'three';

/** Without a graphics card every sample of a pixel is expensive: antialiasing is then disabled for a higher frame rate. */
export function drawnByProcessor(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  const names = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = names ? String(gl!.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export function lights(): THREE.Light[] {
  const sun = new THREE.DirectionalLight('#ffffff', 2.1);
  sun.position.set(-0.4, -1, 1.6);
  const back = new THREE.DirectionalLight('#cfe4ff', 0.7);
  back.position.set(0.6, 1, 0.5);
  return [sun, back, new THREE.HemisphereLight('#eaf4ff', '#8a7d63', 1.25)];
}

/** Drawn over everything. */
export function cursorMark(): THREE.Mesh {
  const mark = new THREE.Mesh(new THREE.SphereGeometry(1, 20, 14), new THREE.MeshBasicMaterial({ color: '#ff2d7a', transparent: true, opacity: 0.9, depthTest: false }));
  mark.renderOrder = 10;
  mark.visible = false;
  return mark;
}
