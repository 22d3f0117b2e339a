// All kinds of blocks of a report, numbers and tables.
import { expect, test } from 'vitest';
import { Blocks, FigureContext, type FigureBlock } from '../src/components/Block';
import type { BlockData, ReportDocument, TableData } from '../src/components/document';
import { FrontPage } from '../src/components/FrontPage';
import { figureNumbers } from '../src/components/outline';
import { Table } from '../src/components/Table';
import { nextOrder, rowOrder, tableCsv, tableText } from '../src/components/tableText';
import { fixed, unitsFromTable } from '../src/components/units';
import { cssString, documentNumber, marginStyle } from '../src/report/margins';
import { Figure } from '../src/report/figures';
import fixture from './report_document.json';
import { drawn, type LightNode } from './lightDom';

const report = fixture as unknown as ReportDocument;

function drawnBody(): LightNode {
  const numbers = figureNumbers(report.body);
  const NumberedFigure = ({ figure }: { figure: FigureBlock }) => <figcaption>{numbers.get(figure)}. {figure.caption}</figcaption>;
  return drawn(<FigureContext.Provider value={NumberedFigure}><Blocks blocks={report.body} /></FigureContext.Provider>);
}

function table(): TableData {
  const found = JSON.stringify(report.body).match(/\{"kind":"table","title":"","look":"dense summary".*?"marks":\[[^\]]*\]\}/)![0];
  return JSON.parse(found) as TableData;
}

const texts = (nodes: LightNode[]): string[] => nodes.map((node) => node.text);

test('a number is never -0 and has its decimals', () => {
  expect([fixed(-0.04, 1), fixed(-0, 0), fixed(12, 2), fixed(-0.06, 1), fixed(Number.NaN, 2)]).toEqual(['0.0', '0', '12.00', '-0.1', '-']);
});

test('values are shown in their unit with as many decimals more as it needs', () => {
  const units = unitsFromTable({ N: { name: 'kip', factor: 1 / 4448.2216, more: 1 }, 1: { name: '', factor: 1, more: 0 } });
  expect(units.shown(1e6, 'N', 1)).toBe('224.81 kip');
  expect(units.shown(0.5, '1', 2)).toBe('0.50');
  expect([units.title('Tension', 'N'), units.title('Share', '1')]).toEqual(['Tension [kip]', 'Share']);
  expect(units.shown(2, 'W', 0)).toBe('2 W');
});

test('the fixture has every kind of block, and each is drawn', () => {
  const kinds = new Set(JSON.stringify(report.body).match(/"kind":"\w+"/g));
  expect(kinds.size).toBe(13);
  const page = drawnBody();
  expect(texts(page.all('h2'))).toEqual(report.body.map((block) => (block as Extract<BlockData, { kind: 'section' }>).heading));
  expect(texts(page.all('h3'))).toEqual(['Stop and hold if']);
  expect(texts(page.all('p.small'))).toEqual(['Distances are along the pipe.']);
  expect(page.all('p')[0]!.html).toBe('<p>All values are at rest. <a href="#calculation-sheet">See the calculation sheet.</a></p>');
  expect(texts(page.all('ul')[0]!.all('li'))).toEqual(['Load of a roller above 400 kN.', 'Strain above 0.2 %.']);
  expect(texts(page.all('ol')[0]!.all('li'))).toEqual(['Lower the stinger.', 'Pay out.']);
  expect(texts(page.all('dl.control')[0]!.all('dd'))).toEqual(['BGL-OB-001', '\u00a0']);
  expect(texts(page.all('pre'))).toEqual(['pipe:\n  diameter: 30 in\n']);
  expect(page.all('div.columns')[0]!.all('table')).toHaveLength(2);
});

test('figures are numbered over the whole page, within folded blocks too', () => {
  expect(texts(drawnBody().all('figcaption'))).toEqual(['1. Effective tension.', '2. Histories.', '3. Stinger.']);
});

test('folded blocks say whether they are printed', () => {
  const page = drawnBody();
  expect(page.all('details.print-open').map((d) => d.all('summary')[0]!.text)).toEqual(['More figures', 'Laying criterion']);
  expect(texts(page.all('details.print-not')[0]!.all('summary'))).toEqual(['Show the file']);
});

test('a table has units below titles, groups, marks and words flush left', () => {
  const made = drawn(<Table table={table()} />);
  expect(made.all('tr.groups')[0]!.all('th').map((th) => [th.text, th.attribute('colSpan')])).toEqual([['', 1], ['Tension', 2], ['', 1]]);
  expect(made.all('th')[4]!.html).toContain('hold<br></br><span class="unit">kN</span>');
  expect(texts(made.all('tr.over')[0]!.all('td'))).toEqual(['stinger 9', '98.5', '', 'EXCEEDED 1.072']);
  expect(made.all('td.exceeded')[0]!.attribute('class')).toBe('t exceeded');
  expect(texts(made.all('td.t'))).toContain('stinger 10');
  expect(made.all('tr.total')).toHaveLength(1);
  expect(made.all('button')).toHaveLength(0);
});

test('a click on a head sorts up, then down, then not; sums stay last', async () => {
  const made = drawn(<Table table={table()} sortable copyable />);
  const names = (): string[] => made.all('tbody')[0]!.all('tr').map((row) => row.all('td')[0]!.text);
  const click = async (column: number): Promise<void> => {
    made.all('button.sort')[column]!.click();
    await new Promise((done) => setTimeout(done));
  };
  await click(0);
  expect(names()).toEqual(['stinger 9', 'stinger 10', 'all']);
  expect(made.all('th').map((th) => th.attribute('aria-sort')).filter(Boolean)).toEqual(['ascending', 'none', 'none', 'none']);
  await click(0);
  expect(names()).toEqual(['stinger 10', 'stinger 9', 'all']);
  await click(0);
  expect(names()).toEqual(['stinger 10', 'stinger 9', 'all']);
  expect(made.all('th')[3]!.attribute('aria-sort')).toBe('none');
});

test('empty cells stand after the others in either direction', () => {
  expect(rowOrder(table(), { column: 2, descending: false })).toEqual([0, 1, 2]);
  expect(rowOrder(table(), { column: 2, descending: true })).toEqual([0, 1, 2]);
  expect(rowOrder(table(), nextOrder(null, 1))).toEqual([0, 1, 2]);
  expect(rowOrder(table(), nextOrder(nextOrder(null, 1), 1))).toEqual([1, 0, 2]);
});

test('a copied table has titles with group and unit and the numbers that are shown', () => {
  expect(tableText(table()).split('\n').slice(0, 3)).toEqual([
    'Support\tTension: hold [kN]\tTension: not below [kN]\tVerdict',
    'stinger 10\t210.1\t200.1\tpassed',
    'stinger 9\t98.5\t\tEXCEEDED 1.072',
  ]);
});

test('a saved table has all decimals and is quoted where it must be', () => {
  const made = { ...table(), rows: [['a "b", c', 210.1234, null, '-']], marks: [''] } as TableData;
  expect(tableCsv(made)).toBe('Support,Tension: hold [kN],Tension: not below [kN],Verdict\r\n"a ""b"", c",210.1234,,-\r\n');
});

test('a head explains its column, the name of a row can be selected, numbers have tooltips', () => {
  const chosen: string[] = [];
  const described = { ...table(), columns: table().columns.map((column) => ({ ...column, description: `About ${column.title}` })) };
  const action = (name: string) => (name === 'all' ? undefined : { act: () => { chosen.push(name); }, title: 'Show it', chosen: name === 'stinger 9' });
  const made = drawn(<Table table={described} rowAction={action} numberTitle={(text, column) => `${text} ${column.unit}`} file="rows" />);
  expect(made.all('tr')[1]!.all('th')[0]!.attribute('title')).toBe('About Support');
  expect(texts(made.all('button.linkname'))).toEqual(['stinger 10', 'stinger 9']);
  made.all('button.linkname')[1]!.click();
  expect(chosen).toEqual(['stinger 9']);
  expect(made.all('tr.chosen')[0]!.all('td')[1]!.attribute('title')).toBe('98.5 kN');
  expect(texts(made.all('caption')[0]!.all('button'))).toEqual(['csv']);
});

test('tiles mark what is beyond a limit and make room for long values', () => {
  const [first, second] = drawnBody().all('div.tile');
  expect(first!.html).toContain('<div class="value">276.5 <span>kN</span></div>');
  expect(second!.attribute('class')).toBe('tile over');
  expect(second!.all('div.long')).toHaveLength(1);
});

test('the first page has control box, verdict, bars, findings and contents', () => {
  const page = drawn(<FrontPage front={report.front} body={report.body} />);
  expect(page.all('h1')[0]!.text).toBe('30 in pipe in 89 m of water <draft>');
  expect(page.all('dl.control')[0]!.all('dd')[0]!.text).toBe('\u00a0');
  expect(page.all('div.verdict')[0]!.attribute('class')).toBe('verdict exceeded');
  expect(page.all('div.bar').map((bar) => [bar.attribute('class'), bar.all('div.value')[0]!.text])).toEqual([['bar over', '1.072'], ['bar', '0.613']]);
  expect(page.all('nav')[0]!.all('a').map((a) => a.attribute('href'))).toEqual(['#results', '#figures', '#procedure', '#calculation-sheet', '#model']);
  expect(page.all('details')[0]!.all('summary')[0]!.text).toBe('1 more');
  expect(page.all('li.serious')[0]!.text).toBe('Serious The pipe is off these rollers: stinger 8. pipe-off-rollers');
});

test('without bars only the note is below the verdict', () => {
  const front = { ...report.front, control: undefined, findings: [], utilisation: { heading: 'Utilisation', bars: [], note: 'Of the static state.' } };
  const page = drawn(<FrontPage front={front} body={[]} />);
  expect(page.all('section')[0]!.all('p.small')[0]!.text).toBe('Of the static state.');
  expect([page.all('div.card').length, page.all('dl.control').length, page.all('section').length]).toEqual([0, 0, 1]);
});

test('margins of printed pages carry the number of the document', () => {
  expect(documentNumber(report.front.control)).toBe('BGL-OB-001, rev. B');
  expect(documentNumber(undefined)).toBe('');
  expect(cssString('a "b" </style>')).toBe('"a \\22 b\\22  \\3c /style>"');
  expect(marginStyle(report)).toMatch(/size: A4; @top-left \{ content: "BGL-OB-001, rev\. B";.*@bottom-left \{ content: "Static pipelay analysis, 2026-11-29 17:00 UTC"/);
});

test('an unknown figure is reported in its panel and keeps the caption', async () => {
  const errors: unknown[] = [];
  const { error } = console;
  console.error = (e: unknown) => errors.push(e);
  const made = drawn(<Figure figure={{ kind: 'figure', id: 'no_such', caption: 'Nothing.', parts: ['a', 'b'], small: true }} number={4} data={{}} />);
  await new Promise((done) => setTimeout(done));
  console.error = error;
  expect(errors).toHaveLength(2);
  expect(made.all('div.multiples').map((panel) => panel.attribute('data-part'))).toEqual(['a', 'b']);
  expect(made.all('figcaption')[0]!.text).toBe('Figure 4. Nothing.');
});
