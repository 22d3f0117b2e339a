// Offsets of midship during a run, magnified: they are small compared with the mooring spread.
import { ellipse, scaleLength } from '../../logic/plan';
import { shownUnit, text } from '../../logic/show';
import type { OffsetsInTime } from '../../state/offsets';

/** A round length in the unit shown [m]. */
export const scaleBar = (reach: number): number => { const { factor } = shownUnit('m'); return scaleLength(reach * factor) / factor; };

export function PlanOffsets({ of, size }: { of: OffsetsInTime; size: number }) {
  const two = ellipse(of.scatter, 2), { x, y } = of.scatter;
  const reach = 1.15 * Math.max(1e-3, ...of.track.map(([a, b]) => Math.max(Math.abs(a), Math.abs(b))), Math.abs(x.mean) + two.a, Math.abs(y.mean) + two.a);
  const k = size / 2 / reach, across = (v: number): number => size / 2 + k * v, up = (v: number): number => size / 2 - k * v;
  const bar = scaleBar(2 * reach);
  return (
    <svg class="offsetplot" width={size} height={size} viewBox={`0 0 ${size} ${size}`} role="img" aria-label="Offsets of midship during the run">
      <title>Midship relative to its nominal position, east to the right and north up: track, mean, and ellipse of two standard deviations</title>
      <path class="axis" d={`M0 ${size / 2}H${size}M${size / 2} 0V${size}`} />
      <path class="track" d={of.track.map(([a, b], i) => `${i ? 'L' : 'M'}${across(a).toFixed(1)} ${up(b).toFixed(1)}`).join('')} />
      <ellipse
        cx={across(x.mean)}
        cy={up(y.mean)}
        rx={k * two.a}
        ry={k * two.b}
        transform={`rotate(${(-two.turn * 180) / Math.PI} ${across(x.mean)} ${up(y.mean)})`}
      />
      <circle cx={across(x.mean)} cy={up(y.mean)} r="3" />
      <path class="bar" d={`M8 ${size - 8}v-4v4h${k * bar}v-4`} />
      <text x={12 + k * bar} y={size - 8}>{text(bar, 'm')}</text>
      <text x="6" y="14">midship, 2 std</text>
    </svg>
  );
}
