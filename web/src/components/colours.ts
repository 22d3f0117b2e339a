// Colours of curves and marks, in figures of the report and of the page.

export const colours = {
  pipe: '#0b5394',
  accent: '#b3261e',
  second: '#c77700',
  third: '#009e73',
  dynamic: '#6a3d9a',
  band: '#d9cce6',
  history: '#9c7fc4',
  port: '#d55e00',
  steel: '#7b8794',
  soft: '#5b6b7a',
  zero: '#8794a0',
  ink: '#1b2733',
} as const;

/** Colours of several curves of one kind: distinct for all kinds of colour vision (Okabe and Ito 2008). */
export const curveColours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#000000'] as const;

/** Dashes that distinguish curves in print. */
export const curveDashes = [undefined, '7 4', '2 3', '9 3 2 3'] as const;

/** Colour and dash of curve k; the dash changes when all colours are used. */
export function curveLook(k: number): { colour: string; dash?: string } {
  const dash = curveDashes[Math.floor(k / curveColours.length) % curveDashes.length];
  return { colour: curveColours[k % curveColours.length]!, dash };
}
