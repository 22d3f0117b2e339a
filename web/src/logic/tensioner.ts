// What the tensioner's state in the histories means.

export interface TensionerState { words: string; tone: 'good' | 'warn' | 'move' | 'bad'; way: number; limit: boolean }

const states: TensionerState[] = [
  { words: 'holds', tone: 'good', way: 0, limit: false },
  { words: 'waiting for its delay', tone: 'warn', way: 0, limit: false },
  { words: 'pays out', tone: 'move', way: 1, limit: false },
  { words: 'hauls in', tone: 'move', way: -1, limit: false },
  { words: 'at its limit', tone: 'bad', way: 0, limit: true },
];

export const tensionerState = (value: number | null | undefined): TensionerState | null =>
  (value === null || value === undefined || !Number.isFinite(value) ? null : states[Math.round(value)] ?? null);

const own: Record<string, string> = {
  'tensioner/tension': 'Tensioner: tension', 'tensioner/travel': 'Tensioner: travel, positive when paid out', 'tensioner/state': 'Tensioner: state (0 holds, 1 delay, 2 out, 3 in, 4 limit)',
  top_tension: 'Top tension', bottom_tension: 'Bottom tension', lay_back: 'Lay-back', departure_angle: 'Departure angle',
  stinger_tip_clearance: 'Stinger tip clearance', energy_drift: 'Energy drift', step: 'Time step', elevation: 'Water surface at the stern',
};

/** A history in words: short, and no two alike. */
export function columnName(name: string): string {
  if (own[name]) return own[name];
  const support = /^support\/(.*)\/(\w+)$/.exec(name);
  if (support) return `${support[1]}: ${support[2]}`;
  const mooring = /^mooring\/(.*)\/(fairlead|anchor)_tension$/.exec(name);
  if (mooring) return `${mooring[1]}: tension at the ${mooring[2]}`;
  const words = name.replaceAll('/', ': ').replaceAll('_', ' ').replace('von mises', 'von Mises').replace(/ peak$/, ', peak');
  return words.charAt(0).toUpperCase() + words.slice(1);
}
