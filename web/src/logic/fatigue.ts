// Text of the allowable standby time.
const kDay = 86400;

export function waitText(seconds: number): string {
  if (seconds < 7200) return `${Math.round(seconds / 60)} min`;
  if (seconds < 10 * kDay) return `${(seconds / 3600).toFixed(1)} h`;
  return seconds < 730 * kDay ? `${Math.round(seconds / kDay)} days` : `${Math.round(seconds / 31557600)} years`;
}
