// Keys above the cursor in a YAML text. Written for completion while the text is incomplete,
// when a real parser would only report an error; only indentation is evaluated.

export interface Place { path: string[]; typed: string; kind: 'key' | 'value'; from: number }

const keyLine = /^(\s*)((?:-\s+)*)([\w .-]+?)\s*:(?:\s|$)/;

/** Column of the content of a line, after list dashes. */
function contentColumn(line: string): number {
  return /^(\s*(?:-\s+)*)/.exec(line)![0].length;
}

export function placeAt(text: string, offset: number): Place {
  const start = text.lastIndexOf('\n', offset - 1) + 1;
  const before = text.slice(start, offset);
  const flow = before.lastIndexOf('{') > before.lastIndexOf('}');
  const path = keysAbove(text.slice(0, start), contentColumn(before), before);

  if (flow) {
    const outer = keyLine.exec(before);
    if (outer) path.push(outer[3]!);
    const inside = before.slice(before.lastIndexOf('{') + 1);
    const item = inside.slice(inside.lastIndexOf(',') + 1);
    return finish(path, item, offset);
  }
  return finish(path, before.slice(contentColumn(before)), offset);
}

function finish(path: string[], piece: string, offset: number): Place {
  const colon = /^\s*([\w .-]+?)\s*:\s*(.*)$/.exec(piece);
  if (colon) {
    const typed = colon[2]!;
    return { path: [...path, colon[1]!], typed, kind: 'value', from: offset - typed.length };
  }
  const typed = piece.trimStart();
  return { path, typed, kind: 'key', from: offset - typed.length };
}

function keysAbove(text: string, column: number, current: string): string[] {
  const path: string[] = [];
  let limit = column;
  // a dash on the current line: its list belongs to the key above at the dash's column or less
  if (/^\s*-\s/.test(current)) { limit = /^\s*/.exec(current)![0].length + 1; path.unshift('[]'); }
  const lines = text.split('\n');
  for (let i = lines.length - 1; i >= 0 && limit > 0; --i) {
    const line = lines[i]!;
    if (!line.trim() || line.trim().startsWith('#')) continue;
    const dash = /^(\s*)-\s+/.exec(line);
    const match = keyLine.exec(line);
    const column = contentColumn(line);
    if (column < limit && match && /:\s*(#.*)?$/.test(line.trimEnd())) { path.unshift(match[3]!); limit = column; }
    else if (column < limit && match && !dash && column === 0) break;
    if (dash && dash[1]!.length < limit && column <= limit) { path.unshift('[]'); limit = dash[1]!.length + 1; }
  }
  return path;
}

/** Line (from 1) of a key of the model; that of its nearest given parent if it has none. */
export function lineOfKey(text: string, path: string): number {
  const lines = text.split('\n');
  let found = 0, from = 0, end = lines.length;
  const indent = (line: string): number => /^\s*/.exec(line)![0].length;
  const blockEnd = (start: number): number => {
    const column = contentColumn(lines[start]!);
    for (let i = start + 1; i < end; ++i) if (lines[i]!.trim() && !lines[i]!.trim().startsWith('#') && contentColumn(lines[i]!) <= column && indent(lines[i]!) < column + 1) return i;
    return end;
  };
  for (const part of path.replaceAll('[', '.[').split('.').filter(Boolean)) {
    const item = /^\[(\d+)\]$/.exec(part);
    let line = -1, count = 0;
    for (let i = from; i < end && line < 0; ++i) {
      const dash = /^(\s*)-(?:\s|$)/.exec(lines[i]!);
      if (item) { if (dash && count++ === Number(item[1])) line = i; } else if (keyLine.exec(lines[i]!)?.[3] === part) line = i;
    }
    if (line < 0) return found;
    found = line + 1;
    end = item ? nextDash(lines, line, end) : blockEnd(line);
    from = item ? line : line + 1;
  }
  return found;
}

/** Beginning of the next item of the same list, otherwise the end of the list. */
function nextDash(lines: string[], start: number, end: number): number {
  const column = lines[start]!.indexOf('-');
  for (let i = start + 1; i < end; ++i) if (/^\s*-(?:\s|$)/.test(lines[i]!) && lines[i]!.indexOf('-') <= column) return i;
  return end;
}
