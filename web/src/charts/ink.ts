// Curve colours: those of print, and brighter ones of the same hue in the dark theme.
const brighter: Record<string, string> = {
  '#0b66c2': '#5aa9f2', '#0b5394': '#6cb2f0', '#0072b2': '#4fb0e8', '#5d7f2f': '#9cc766', '#8e24aa': '#d083e6', '#6a3d9a': '#b08be0', '#b3261e': '#ff8d84', '#000000': '#e4eaf0',
};

const isDark = (): boolean => document.documentElement.dataset.theme === 'dark';

export const inkOnPage = (colour: string, dark = isDark()): string => (dark ? brighter[colour.toLowerCase()] ?? colour : colour);
