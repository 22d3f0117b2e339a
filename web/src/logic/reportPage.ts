// The page of a report as it is printed: its sections, those that are left out, its paper.

export interface Section { heading: string; element: HTMLElement }

/** The sections of the page in their order. */
export function reportSections(page: Document): Section[] {
  return [...page.querySelectorAll<HTMLElement>('.sections > section')].map((element) => (
    { heading: element.querySelector('h2')?.textContent?.trim() ?? '', element })).filter(({ heading }) => heading !== '');
}

/** Leaves sections out and sets the paper; "own" is that of the units. */
export function prepareReport(page: Document, leftOut: readonly string[], paper: 'own' | 'A4' | 'letter'): void {
  for (const { heading, element } of reportSections(page)) element.hidden = leftOut.includes(heading);
  page.getElementById('chosen-paper')?.remove();
  if (paper === 'own') return;
  const style = page.createElement('style');
  style.id = 'chosen-paper';
  style.textContent = `@page { size: ${paper}; }`;
  page.body.append(style);
}
