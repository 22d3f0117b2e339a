// The page of a report as printed: sections, omitted sections, paper.

export interface Section { heading: string; element: HTMLElement }

/** Sections of the page in order. */
export function reportSections(page: Document): Section[] {
  return [...page.querySelectorAll<HTMLElement>('.sections > section')].map((element) => (
    { heading: element.querySelector('h2')?.textContent?.trim() ?? '', element })).filter(({ heading }) => heading !== '');
}

/** Omits sections and sets the paper; "own" follows the units. */
export function prepareReport(page: Document, leftOut: readonly string[], paper: 'own' | 'A4' | 'letter'): void {
  for (const { heading, element } of reportSections(page)) element.hidden = leftOut.includes(heading);
  page.getElementById('chosen-paper')?.remove();
  if (paper === 'own') return;
  const style = page.createElement('style');
  style.id = 'chosen-paper';
  style.textContent = `@page { size: ${paper}; }`;
  page.body.append(style);
}
