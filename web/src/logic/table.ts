// A diagram as CSV, and as SVG drawn from its data (not from pixels, so that it prints sharp).

export interface Line { name: string; colour: string; values: (number | null)[]; dash?: boolean }
export interface Diagram { title: string; xName: string; yName: string; x: number[]; lines: Line[]; low: number; high: number; xLow: number; xHigh: number }

function cell(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

export function toCsv(d: Diagram): string {
  const head = [d.xName, ...d.lines.map((l) => `${l.name} ${d.yName.match(/\[.*\]/)?.[0] ?? ''}`.trim())].map(cell).join(',');
  const rows = d.x.map((x, i) => [x, ...d.lines.map((l) => l.values[i] ?? '')].join(','));
  return `${[head, ...rows].join('\r\n')}\r\n`;
}

export function ticks(low: number, high: number, about: number): number[] {
  const raw = (high - low) / Math.max(1, about);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw) ?? raw;
  const out: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) out.push(Number((k * step).toPrecision(12)));
  return out;
}

const escape = (text: string): string => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

export function toSvg(d: Diagram, width = 900, height = 420): string {
  const box = { left: 72, right: width - 20, top: 40, bottom: height - 52 };
  const px = (x: number): number => box.left + ((x - d.xLow) / (d.xHigh - d.xLow || 1)) * (box.right - box.left);
  const py = (y: number): number => box.bottom - ((y - d.low) / (d.high - d.low || 1)) * (box.bottom - box.top);
  const parts: string[] = [];
  for (const t of ticks(d.xLow, d.xHigh, 8)) parts.push(`<path d="M${px(t).toFixed(1)} ${box.top}V${box.bottom}" class="g"/><text x="${px(t).toFixed(1)}" y="${box.bottom + 18}" text-anchor="middle">${t}</text>`);
  for (const t of ticks(d.low, d.high, 6)) parts.push(`<path d="M${box.left} ${py(t).toFixed(1)}H${box.right}" class="g"/><text x="${box.left - 8}" y="${(py(t) + 4).toFixed(1)}" text-anchor="end">${t}</text>`);
  for (const line of d.lines) {
    let path = '';
    let pen = 'M';
    line.values.forEach((v, i) => {
      if (v === null || d.x[i]! < d.xLow || d.x[i]! > d.xHigh) { pen = 'M'; return; }
      path += `${pen}${px(d.x[i]!).toFixed(1)} ${py(v).toFixed(1)}`;
      pen = 'L';
    });
    parts.push(`<path d="${path}" fill="none" stroke="${line.colour}" stroke-width="1.6"${line.dash ? ' stroke-dasharray="5 4"' : ''} clip-path="url(#c)"/>`);
  }
  let at = box.left;
  for (const line of d.lines) {
    parts.push(`<path d="M${at} ${height - 10}h18" stroke="${line.colour}" stroke-width="2.5"/><text x="${at + 24}" y="${height - 6}">${escape(line.name)}</text>`);
    at += 44 + 7.2 * line.name.length;
  }
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="Segoe UI, Helvetica, Arial, sans-serif" font-size="13" fill="#1b2733">`
    + `<style>.g{stroke:#dde3e9;fill:none}</style><clipPath id="c"><rect x="${box.left}" y="${box.top}" width="${box.right - box.left}" height="${box.bottom - box.top}"/></clipPath>`
    + `<rect width="${width}" height="${height}" fill="#fff"/><text x="${box.left}" y="20" font-weight="600">${escape(d.title)}</text>`
    + `<text x="${box.left}" y="35" fill="#5b6b7a" font-size="12">${escape(d.yName)}</text><text x="${box.right}" y="${box.bottom + 34}" text-anchor="end" fill="#5b6b7a" font-size="12">${escape(d.xName)}</text>${parts.join('')}</svg>\n`;
}
