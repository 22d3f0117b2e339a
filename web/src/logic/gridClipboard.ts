// Tables from and to a spreadsheet: tab or comma separated text, with a head row recognised by the column names.

function delimiterIn(text: string): string {
  if (text.includes('\t')) return '\t';
  const lines = text.split(/\r?\n/).filter((line) => line.trim());
  if (lines.every((line) => line.includes(';'))) return ';';
  const decimals = lines.every((line) => /^\s*[-+−]?[\d ']*,\d+(\s*[a-zA-Z%/^*0-9]+)?\s*$/.test(line));
  return !decimals && lines.length > 0 && lines.every((line) => line.includes(',')) ? ',' : '\t';
}

/** Cells of a text from a spreadsheet or a CSV file; quoted cells may contain line breaks. */
export function parseTable(text: string): string[][] {
  const delimiter = delimiterIn(text);
  const rows: string[][] = [];
  let row: string[] = [], cell = '', quoted = false;
  const endCell = (): void => { row.push(cell.trim()); cell = ''; };
  const endRow = (): void => { endCell(); rows.push(row); row = []; };
  for (let i = 0; i < text.length; ++i) {
    const c = text[i]!;
    if (quoted) {
      if (c !== '"') cell += c;
      else if (text[i + 1] === '"') { cell += '"'; ++i; }
      else quoted = false;
    } else if (c === '"' && cell.trim() === '') { quoted = true; cell = ''; }
    else if (c === delimiter) endCell();
    else if (c === '\n') endRow();
    else if (c !== '\r') cell += c;
  }
  if (cell !== '' || row.length > 0) endRow();
  while (rows.length > 0 && rows.at(-1)!.every((c) => c === '')) rows.pop();
  return rows;
}

export interface NamedColumn { id: string; title: string; unit: string }

/** Target columns of a pasted table: id of the column, null: none. */
export interface TableHead { columns: (string | null)[]; units: string[]; ignored: string[]; rows: string[][] }

const unitPattern = /\s*(?:\[([^\]]*)\]|\(([^)]*)\)|,\s*([a-zA-Z%°/^*0-9]+))\s*$/;

/** Title and unit from "x [m]", "x (ft)" or "x, m". */
export function splitTitle(text: string): { title: string; unit: string } {
  const match = unitPattern.exec(text);
  return match ? { title: text.slice(0, match.index).trim(), unit: (match[1] ?? match[2] ?? match[3] ?? '').trim() } : { title: text.trim(), unit: '' };
}

const flat = (text: string): string => text.toLowerCase().replace(/^.*:\s*/, '').replace(/[\s_.-]+/g, ' ').trim();

/** Names of columns in other programs. */
const synonyms: Record<string, string[]> = {
  name: ['box', 'roller box', 'line', 'label', 'id', 'segment', 'stage'],
  x: ['x coordinate', 'x coord', 'x pos', 'x position', 'easting'],
  y: ['y coordinate', 'y coord', 'northing'],
  z: ['z coordinate', 'z coord', 'z pos', 'elevation', 'height'],
  depth: ['water depth'],
  speed: ['velocity', 'current speed'],
  towards: ['direction', 'heading'],
  rows: ['rows a box', 'no of rows', 'number of rows'],
  thickness: ['wall thickness'],
};

function columnNamed(text: string, columns: NamedColumn[]): string | null {
  const wanted = flat(splitTitle(text).title);
  if (!wanted) return null;
  const found = columns.find((c) => flat(c.id) === wanted || flat(c.title) === wanted) ?? columns.find((c) => synonyms[c.id]?.includes(wanted));
  return found?.id ?? null;
}

const isNumber = (text: string): boolean => /^[-+−]?[\d.,' ]*\d/.test(text);
const isUnit = (text: string): boolean => text === '' || /^[[(]?[a-zA-Z%°/^*0-9² ³-]{1,8}[\])]?$/.test(text);

/** Units in a separate row below the heads. */
function unitRow(row: string[] | undefined): string[] | null {
  if (!row || row.every((cell) => cell === '') || row.some(isNumber) || !row.every(isUnit)) return null;
  const units = row.map((cell) => cell.replace(/[[\]()]/g, ''));
  return units.some((unit) => /^(m|mm|cm|km|ft|in|kN|N|MN|kip|deg|°|MPa|m\/s|knot|t|kg)$/.test(unit)) ? units : null;
}

/** The table with its head row; null if the first row is not one. */
export function readHead(rows: string[][], columns: NamedColumn[]): TableHead | null {
  const heads = rows[0];
  if (!heads || heads.some((cell) => cell !== '' && isNumber(cell))) return null;
  const seen = new Set<string>();
  const found = heads.map((cell) => {
    const id = columnNamed(cell, columns);
    if (id === null || seen.has(id)) return null;
    seen.add(id);
    return id;
  });
  const named = heads.filter((cell) => cell !== '').length;
  if (seen.size === 0 || 2 * seen.size < Math.min(named, 2)) return null;
  const units = unitRow(rows[1]);
  return {
    columns: found,
    units: heads.map((cell, i) => units?.[i] || splitTitle(cell).unit),
    ignored: heads.filter((cell, i) => cell !== '' && found[i] === null),
    rows: rows.slice(units ? 2 : 1),
  };
}

const flatCell = (text: string): string => text.replace(/\s+/g, ' ');

/** Tab-separated text for a spreadsheet. */
export const tabText = (rows: string[][]): string => rows.map((cells) => `${cells.map(flatCell).join('\t')}\n`).join('');
