// Meaning of the tensioner state in the histories.

export interface TensionerState { label: string; tone: 'good' | 'warn' | 'move' | 'bad'; way: number; limit: boolean }

const states: TensionerState[] = [
  { label: 'holds', tone: 'good', way: 0, limit: false },
  { label: 'in delay', tone: 'warn', way: 0, limit: false },
  { label: 'pays out', tone: 'move', way: 1, limit: false },
  { label: 'hauls in', tone: 'move', way: -1, limit: false },
  { label: 'at its limit', tone: 'bad', way: 0, limit: true },
];

export const tensionerState = (value: number | null | undefined): TensionerState | null =>
  (value === null || value === undefined || !Number.isFinite(value) ? null : states[Math.round(value)] ?? null);

const labels: Record<string, string> = {
  'tensioner/tension': 'Tensioner: tension', 'tensioner/travel': 'Tensioner: travel, positive when paid out', 'tensioner/state': 'Tensioner: state (0 holds, 1 delay, 2 out, 3 in, 4 limit)',
  top_tension: 'Top tension', bottom_tension: 'Bottom tension', lay_back: 'Lay-back', departure_angle: 'Departure angle',
  stinger_tip_clearance: 'Stinger tip clearance', energy_drift: 'Energy drift', step: 'Time step', elevation: 'Water surface at the stern',
};

/** Short, unique label of a history. */
export function columnName(name: string): string {
  if (labels[name]) return labels[name];
  const support = /^support\/(.*)\/(\w+)$/.exec(name);
  if (support) return `${support[1]}: ${support[2]}`;
  const mooring = /^mooring\/(.*)\/(fairlead|anchor)_tension$/.exec(name);
  if (mooring) return `${mooring[1]}: tension at the ${mooring[2]}`;
  const label = name.replaceAll('/', ': ').replaceAll('_', ' ').replace('von mises', 'von Mises').replace(/ peak$/, ', peak');
  return label.charAt(0).toUpperCase() + label.slice(1);
}
