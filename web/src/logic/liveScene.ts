// The fixed scene adjusted to trial values: seabed with the depth, vessel with its trim.
import type { Scene } from '../api/types';

/** Trial values of `depth` [m] and `trim` [rad, bow up]; `trim0` is that of the model. */
export function liveScene(scene: Scene, depth: number | undefined, trim: number | undefined, trim0: number): Scene {
  if (depth === undefined && trim === undefined) return scene;
  const out = { ...scene };
  if (depth !== undefined) {
    const [x, y, z] = scene.seabed.point;
    out.water_depth = depth;
    out.seabed = { normal: scene.seabed.normal, point: [x, y, z - (depth - scene.water_depth)] };
  }
  if (trim !== undefined && scene.vessel) {
    // about the transverse axis of the vessel; bow up is a rotation by the negative angle
    const p = scene.vessel.pose, angle = trim0 - trim, c = Math.cos(angle), s = Math.sin(angle);
    const pose = [...p];
    for (let row = 0; row < 3; ++row) {
      const i = 3 + 3 * row;
      pose[i] = p[i]! * c - p[i + 2]! * s;
      pose[i + 2] = p[i]! * s + p[i + 2]! * c;
    }
    out.vessel = { ...scene.vessel, pose };
  }
  return out;
}
