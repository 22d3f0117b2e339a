// A workbook (.xlsx) of plain tables, written by the page: sheets with a bold, frozen head; numbers stay numbers.
import type { Cell, TableData } from './document';
import { fullTitles } from './tableText';

export interface Sheet { name: string; rows: (string | number | null)[][] }

const encoder = new TextEncoder();

const escapeXml = (text: string): string =>
  text.replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f]/g, '').replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');

/** "A", "Z", "AA", ... */
export function columnLetters(index: number): string {
  const before = Math.floor(index / 26);
  return (before > 0 ? columnLetters(before - 1) : '') + String.fromCharCode(65 + index % 26);
}

function cellXml(value: string | number | null, row: number, column: number): string {
  const place = `r="${columnLetters(column)}${row + 1}"${row === 0 ? ' s="1"' : ''}`;
  if (value === null || value === '') return '';
  if (typeof value === 'number') return Number.isFinite(value) ? `<c ${place}><v>${value}</v></c>` : '';
  return `<c ${place} t="inlineStr"><is><t xml:space="preserve">${escapeXml(value)}</t></is></c>`;
}

/** Column width for its longest text, within limits. */
function widths(rows: Sheet['rows']): string {
  const count = Math.max(...rows.map((row) => row.length), 1);
  const wide = (column: number): number => Math.min(48, Math.max(9, ...rows.map((row) => String(row[column] ?? '').length + 2)));
  return Array.from({ length: count }, (_, i) => `<col min="${i + 1}" max="${i + 1}" width="${wide(i)}" customWidth="1"/>`).join('');
}

const kXml = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n';
const kMain = 'http://schemas.openxmlformats.org/spreadsheetml/2006/main';
const kRelations = 'http://schemas.openxmlformats.org/officeDocument/2006/relationships';
const kPackage = 'http://schemas.openxmlformats.org/package/2006';
const kType = 'application/vnd.openxmlformats-officedocument.spreadsheetml';

function sheetXml({ rows }: Sheet): string {
  const lines = rows.map((row, r) => `<row r="${r + 1}">${row.map((value, c) => cellXml(value, r, c)).join('')}</row>`);
  return `${kXml}<worksheet xmlns="${kMain}"><sheetViews><sheetView workbookViewId="0"><pane ySplit="1" topLeftCell="A2" activePane="bottomLeft" state="frozen"/>`
    + `</sheetView></sheetViews><cols>${widths(rows)}</cols><sheetData>${lines.join('')}</sheetData></worksheet>`;
}

const kStyles = `${kXml}<styleSheet xmlns="${kMain}"><fonts count="2"><font><sz val="11"/><name val="Calibri"/></font><font><b/><sz val="11"/><name val="Calibri"/></font></fonts>`
  + '<fills count="2"><fill><patternFill patternType="none"/></fill><fill><patternFill patternType="gray125"/></fill></fills>'
  + '<borders count="1"><border><left/><right/><top/><bottom/><diagonal/></border></borders><cellStyleXfs count="1"><xf/></cellStyleXfs>'
  + '<cellXfs count="2"><xf/><xf fontId="1" applyFont="1"/></cellXfs></styleSheet>';

/** Sheet names: at most 31 characters, none of []:*?/\, unique. */
function sheetNames(sheets: readonly Sheet[]): string[] {
  const names: string[] = [];
  for (const { name } of sheets) {
    const plain = name.replace(/[[\]:*?/\\]/g, ' ').slice(0, 31).trim() || 'Sheet';
    names.push(names.includes(plain) ? `${plain.slice(0, 27)} ${names.length + 1}` : plain);
  }
  return names;
}

function parts(sheets: readonly Sheet[]): [string, string][] {
  const names = sheetNames(sheets);
  const overrides = sheets.map((_, i) => `<Override PartName="/xl/worksheets/sheet${i + 1}.xml" ContentType="${kType}.worksheet+xml"/>`).join('');
  const links = sheets.map((_, i) => `<Relationship Id="rId${i + 1}" Type="${kRelations}/worksheet" Target="worksheets/sheet${i + 1}.xml"/>`).join('');
  const list = names.map((name, i) => `<sheet name="${escapeXml(name)}" sheetId="${i + 1}" r:id="rId${i + 1}"/>`).join('');
  return [
    ['[Content_Types].xml', `${kXml}<Types xmlns="${kPackage}/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>`
      + `<Default Extension="xml" ContentType="application/xml"/><Override PartName="/xl/workbook.xml" ContentType="${kType}.sheet.main+xml"/>`
      + `<Override PartName="/xl/styles.xml" ContentType="${kType}.styles+xml"/>${overrides}</Types>`],
    ['_rels/.rels', `${kXml}<Relationships xmlns="${kPackage}/relationships"><Relationship Id="rId1" Type="${kRelations}/officeDocument" Target="xl/workbook.xml"/></Relationships>`],
    ['xl/workbook.xml', `${kXml}<workbook xmlns="${kMain}" xmlns:r="${kRelations}"><sheets>${list}</sheets></workbook>`],
    ['xl/_rels/workbook.xml.rels', `${kXml}<Relationships xmlns="${kPackage}/relationships">${links}`
      + `<Relationship Id="rId${sheets.length + 1}" Type="${kRelations}/styles" Target="styles.xml"/></Relationships>`],
    ['xl/styles.xml', kStyles],
    ...sheets.map((sheet, i): [string, string] => [`xl/worksheets/sheet${i + 1}.xml`, sheetXml(sheet)]),
  ];
}

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c >>> 0;
});

export function crc32(bytes: Uint8Array): number {
  let c = 0xffffffff;
  for (const byte of bytes) c = crcTable[(c ^ byte) & 255]! ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

/** Two (positive) and four (negative) bytes of values, low byte first. */
function record(...values: [number, 2 | 4][]): Uint8Array {
  const out = new DataView(new ArrayBuffer(values.reduce((sum, [, size]) => sum + size, 0)));
  let offset = 0;
  for (const [value, size] of values) {
    if (size === 2) out.setUint16(offset, value, true); else out.setUint32(offset, value, true);
    offset += size;
  }
  return new Uint8Array(out.buffer);
}

/** 1 January 1980, the earliest date of the format: files do not depend on the time of writing. */
const kDate = 0x0021;
const kUtf8 = 0x0800;

/** A zip archive without compression. */
export function zip(files: readonly [string, string][]): Uint8Array {
  const body: Uint8Array[] = [], directory: Uint8Array[] = [];
  const length = (list: readonly Uint8Array[]): number => list.reduce((sum, part) => sum + part.length, 0);
  for (const [path, text] of files) {
    const name = encoder.encode(path), data = encoder.encode(text);
    const common: [number, 2 | 4][] = [[20, 2], [kUtf8, 2], [0, 2], [0, 2], [kDate, 2], [crc32(data), 4], [data.length, 4], [data.length, 4], [name.length, 2], [0, 2]];
    directory.push(record([0x02014b50, 4], [20, 2], ...common, [0, 2], [0, 2], [0, 2], [0, 4], [length(body), 4]), name);
    body.push(record([0x04034b50, 4], ...common), name, data);
  }
  const end = record([0x06054b50, 4], [0, 2], [0, 2], [files.length, 2], [files.length, 2], [length(directory), 4], [length(body), 4], [0, 2]);
  const all = [...body, ...directory, end], out = new Uint8Array(length(all));
  let offset = 0;
  for (const part of all) { out.set(part, offset); offset += part.length; }
  return out;
}

export const workbookBytes = (sheets: readonly Sheet[]): Uint8Array => zip(parts(sheets));

export const workbook = (sheets: readonly Sheet[]): Blob =>
  new Blob([workbookBytes(sheets) as BlobPart], { type: `${kType}.sheet` });

const plainCell = (cell: Cell): string | number | null => (typeof cell === 'object' && cell !== null ? cell.text : cell);

/** A table as a sheet, named by its title. */
export const makeSheet = (table: TableData, name = table.title): Sheet => (
  { name, rows: [fullTitles(table), ...table.rows.map((row) => row.map(plainCell))] });
