// Where in a YAML text the cursor stands: the keys above it. Written for completion while the text is half typed,
// when a real parser would only say that it is wrong; indentation is all that is looked at.

export interface Place { path: string[]; typed: string; kind: 'key' | 'value'; from: number }

const keyLine = /^(\s*)((?:-\s+)*)([\w .-]+?)\s*:(?:\s|$)/;

/** Column in which the content of a line starts, list dashes skipped. */
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
    const at = contentColumn(line);
    if (at < limit && match && /:\s*(#.*)?$/.test(line.trimEnd())) { path.unshift(match[3]!); limit = at; }
    else if (at < limit && match && !dash && at === 0) break;
    if (dash && dash[1]!.length < limit && at <= limit) { path.unshift('[]'); limit = dash[1]!.length + 1; }
  }
  return path;
}

/** The line, counted from 1, on which a key of the model stands; that of the nearest group above where it has none of its own. */
export function lineOfKey(text: string, path: string): number {
  const lines = text.split('\n');
  let found = 0, from = 0, end = lines.length;
  const indent = (line: string): number => /^\s*/.exec(line)![0].length;
  const blockEnd = (start: number): number => {
    const own = contentColumn(lines[start]!);
    for (let i = start + 1; i < end; ++i) if (lines[i]!.trim() && !lines[i]!.trim().startsWith('#') && contentColumn(lines[i]!) <= own && indent(lines[i]!) < own + 1) return i;
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

/** Where the next item of the same list begins, else the end of the list. */
function nextDash(lines: string[], start: number, end: number): number {
  const column = lines[start]!.indexOf('-');
  for (let i = start + 1; i < end; ++i) if (/^\s*-(?:\s|$)/.test(lines[i]!) && lines[i]!.indexOf('-') <= column) return i;
  return end;
}
