// Checks of the start dialog, input by input. The program checks the model again in full.
import { complete, parseQuantity, sameFamily, toSi, tidy } from './units';

export interface Answers {
  title: string;
  pipe: string;
  wall: string;
  yield: string;
  coating: string;
  concrete: string;
  depth: string;
  vessel: string;
  lay: 's' | 'j';
  stinger_radius: string;
  boxes: string;
  tension: string;
}

export type AnswerErrors = Partial<Record<keyof Answers, string>>;

const lengths = 'm, mm, ft or in';
const forces = 'kN, kip or te';

/** Default units of the inputs, as in the form. */
export const answerUnits: Partial<Record<keyof Answers, string>> = { wall: 'mm', yield: 'MPa', coating: 'mm', concrete: 'mm', depth: 'm', stinger_radius: 'm', tension: 'kN' };

/** An input with its unit: that of the previous text, otherwise the usual one. */
export function completed(key: keyof Answers, typed: string, before = ''): string {
  const usual = answerUnits[key];
  return usual ? complete(typed, parseQuantity(before)?.unit || usual) : typed.trim();
}

function quantity(text: string, like: string, units: string, least: number, most: number, shown: string): string | null {
  const q = parseQuantity(text);
  if (!q) return 'enter a number';
  if (!sameFamily(q.unit, like)) return `"${q.unit}" is not one of ${units}`;
  const si = toSi(q.number, q.unit);
  if (si < least || si > most) return `must be between ${tidy(least / toSi(1, shown))} and ${tidy(most / toSi(1, shown))} ${shown}`;
  return null;
}

/** `outside`: steel diameter in m of the selected pipe, if known. Optional inputs may be empty. */
export function check(given: Answers, outside: number | null): AnswerErrors {
  const a = Object.fromEntries(Object.entries(given).map(([key, text]) => [key, completed(key as keyof Answers, text)])) as unknown as Answers;
  const errors: AnswerErrors = {};
  const note = (key: keyof Answers, error: string | null): void => { if (error) errors[key] = error; };
  if (!a.pipe.trim()) errors.pipe = 'choose a pipe';
  note('depth', quantity(a.depth, 'm', lengths, 2, 4000, 'm'));
  if (a.wall.trim()) {
    note('wall', quantity(a.wall, 'm', lengths, 0.002, 0.1, 'mm'));
    const q = parseQuantity(a.wall);
    if (!errors.wall && q && outside && toSi(q.number, q.unit) >= outside / 2) errors.wall = 'must be less than the pipe radius';
  }
  if (a.yield.trim()) note('yield', quantity(a.yield, 'MPa', 'MPa or ksi', 100e6, 1000e6, 'MPa'));
  if (a.coating.trim()) note('coating', quantity(a.coating, 'm', lengths, 0, 0.2, 'mm'));
  if (a.concrete.trim()) note('concrete', quantity(a.concrete, 'm', lengths, 0, 0.3, 'mm'));
  if (a.tension.trim()) note('tension', quantity(a.tension, 'kN', forces, 1e3, 2e7, 'kN'));
  if (a.lay === 's') {
    if (a.stinger_radius.trim()) note('stinger_radius', quantity(a.stinger_radius, 'm', lengths, 20, 1000, 'm'));
    if (a.boxes.trim() && !(/^\d+$/.test(a.boxes.trim()) && Number(a.boxes) >= 1 && Number(a.boxes) <= 60)) errors.boxes = 'enter a whole number from 1 to 60';
  }
  return errors;
}
