// Margins of printed pages: title, number, kind and date of the report; and the paper size.
import type { Front, ReportDocument } from '../components/document';

const look = 'font: 8pt Arial, "Liberation Sans", sans-serif; color: #5b6b7a;';

/** Text as a string of CSS. */
export function cssString(text: string): string {
  return `"${text.replace(/["\\<&\u0000-\u001f]/g, (letter) => `\\${letter.charCodeAt(0).toString(16)} `)}"`;
}

function entry(entries: [string, string][] | undefined, name: string): string {
  return entries?.find(([title]) => title === name)?.[1] ?? '';
}

/** "BGL-OB-001, rev. B"; empty if neither is given. */
export function documentNumber(control: Front['control']): string {
  const revision = entry(control, 'Revision');
  return [entry(control, 'Document'), revision && `rev. ${revision}`].filter(Boolean).join(', ');
}

export function marginStyle({ front, paper }: Pick<ReportDocument, 'front' | 'paper'>): string {
  const number = documentNumber(front.control);
  const box = (place: string, text: string): string => `@${place} { content: ${cssString(text)}; ${look} } `;
  const written = [front.kind, entry(front.entries, 'Written')].filter(Boolean).join(', ');
  return `@page { size: ${paper}; ${box('top-left', number || front.title)}${box('top-right', number ? front.title : front.kind)}${box('bottom-left', written)}}`;
}
