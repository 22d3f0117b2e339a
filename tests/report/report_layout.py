#!/usr/bin/env python3
"""Looks how a report sits on screens of several widths and on paper, in headless Chromium.

    report_layout.py PROGRAM MODEL.yaml
    report_layout.py --made-by PROGRAM [WORD ...]
    report_layout.py --lay-table PROGRAM MODEL.yaml

With --fonts liberation before that in letters as wide as Arial's, if the machine has them; else in DejaVu, which is wider:
see tests/fonts.

On screens: nothing makes the page wider than the window, no table is cut where there is room for a desk's screen, no two
names of boxes cover each other, no number of an axis is cut, names of levels stand on their line, and the axis of a tension does not begin at zero.
On paper: the first page stands alone, what is read as a whole is not split, no page but the last is nearly empty.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import zlib

from fonts import environment, installed
from render_report import FLAGS, written_page

SKIPPED = 77  # as tests/CMakeLists.txt knows it
WIDTHS = (1920, 1280, 390)
DESK = 1200  # from here on tables have their room

# Runs inside the page; what is wrong with it.
LOOK = """
(() => {
  const errors = [];
  const wide = window.innerWidth;
  const page = document.documentElement;
  if (page.scrollWidth > wide + 1) errors.push(`the page is ${page.scrollWidth} px wide`);
  if (wide >= DESK) for (const table of document.querySelectorAll('.table, .tile, .bar, #contents')) {
    if (table.scrollWidth > table.clientWidth + 1) errors.push(`cut: ${table.className}, ${table.textContent.trim().slice(0, 40)}`);
  }
  for (const panel of document.querySelectorAll('.panel')) {
    const id = `${panel.dataset.figure}/${panel.dataset.part}`;
    for (const svg of panel.querySelectorAll('svg')) {
      // A name as a box in its own axes: names at one angle cover each other where their boxes do.
      const names = [...svg.querySelectorAll('text.name, g text.halo[text-anchor]')].filter((t) => t.classList.contains('name') || svg.classList.contains('rotatable'));
      const boxes = names.map((text) => {
        const m = text.getCTM();
        const angle = Math.atan2(m.b, m.a);
        const b = text.getBBox();
        const at = (x, y) => { const p = new DOMPoint(x, y).matrixTransform(m); return [p.x * Math.cos(angle) + p.y * Math.sin(angle), p.y * Math.cos(angle) - p.x * Math.sin(angle)]; };
        const [x0, y0] = at(b.x, b.y + 0.2 * b.height);
        const [x1, y1] = at(b.x + b.width, b.y + 0.8 * b.height);
        return { angle, x0, x1, y0, y1, text: text.textContent };
      });
      boxes.forEach((a, i) => boxes.slice(0, i).forEach((b) => {
        if (Math.abs(a.angle - b.angle) > 0.01) return;
        if (a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1) errors.push(`${id}: '${a.text}' covers '${b.text}'`);
      }));
      const frame = svg.getBoundingClientRect();
      for (const text of svg.querySelectorAll('g[text-anchor=end] .tick text')) {
        if (text.getBoundingClientRect().left < frame.left - 1) errors.push(`${id}: '${text.textContent}' is cut`);
      }
      for (const level of svg.querySelectorAll('text.level')) {
        const y = Number(level.getAttribute('y'));
        const lines = [...svg.querySelectorAll('path[stroke-dasharray="8 4"]')].map((p) => Number(p.getAttribute('d').split(',')[1].split(/[A-Z]/)[0]));
        if (!lines.some((line) => line - y > 0 && line - y < 8)) errors.push(`${id}: '${level.textContent}' stands away from its line`);
      }
    }
  }
  for (const panel of document.querySelectorAll('[data-figure=tension], [data-figure=envelope_tension]')) {
    const ticks = [...panel.querySelectorAll('g[text-anchor=end] .tick text')].map((t) => t.textContent);
    const data = JSON.parse(document.getElementById('results-data').textContent);
    const st = data.stations;
    const all = st.effective_tension.concat(st.wall_tension);
    if (data.dynamic === undefined && ticks.includes('0') && Math.min(...all) > 0.2 * Math.max(...all)) errors.push('the tension axis begins at zero');
  }
  return errors;
})()
""".replace("DESK", str(DESK))

# Blocks that stay on one page, and a link to both of their ends: a printed link shows the page of its target.
MARK = """
document.querySelectorAll('.table:has(table.checks), .table:has(table.plain), .table:has(table.summary), .verdict, .card, #contents').forEach((whole, i) => {
  const parts = whole.querySelectorAll('tr, .bar, li');
  const first = document.createElement('a');
  const last = document.createElement('a');
  first.id = `first-${i}`;
  last.id = `last-${i}`;
  (parts.length > 0 ? parts[0].querySelector('th, td, div, a') : whole).prepend(first);
  (parts.length > 0 ? [...parts].pop().querySelector('th, td, div, a') : whole).append(last);
  for (const a of [first, last]) {
    const link = document.createElement('a');
    link.href = '#' + a.id;
    link.textContent = '.';
    link.style.cssText = 'position: absolute; top: 0; left: 0';
    document.body.append(link);
  }
});
"""


def chromium(arguments, profile, fonts):
    done = subprocess.run(["chromium", *FLAGS, f"--user-data-dir={profile}", "--virtual-time-budget=8000", *arguments],
                          capture_output=True, encoding="utf-8", timeout=180, check=True, env=environment(fonts))
    return done.stdout


def with_script(page, script, name):
    copy = page.with_name(name)
    text = page.read_text(encoding="utf-8")
    cut = text.rindex("</body>")
    copy.write_text(text[:cut] + f"<script>{script}</script>\n" + text[cut:], encoding="utf-8")
    return copy


def screen_errors(page, profile, fonts):
    """A frame of each width holds the page and reports its errors."""
    look = with_script(page, f"parent.postMessage({{wide: window.innerWidth, errors: {LOOK.strip()}}}, '*');", "look.html")
    frames = "".join(f'<iframe src="{look.as_uri()}" style="width:{w}px;height:900px;border:0"></iframe>' for w in WIDTHS)
    outer = page.with_name("frames.html")
    outer.write_text("<body><pre id=reported></pre><script>const all = [];"
                     "onmessage = (e) => { all.push(e.data); reported.textContent = JSON.stringify(all); };"
                     f"</script>{frames}</body>", encoding="utf-8")
    document = chromium(["--dump-dom", outer.as_uri()], profile, fonts)
    reported = re.search(r'<pre id="reported">(.*?)</pre>', document, flags=re.S)[1]
    seen = json.loads(reported.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&") or "[]")
    if sorted(item["wide"] for item in seen) != sorted(WIDTHS):
        yield f"looked at {[item['wide'] for item in seen]} only"
    for item in seen:
        for error in item["errors"]:
            yield f"at {item['wide']} px: {error}"


class Printed:
    """The pages of a PDF by Chromium: what each draws, and where its links lead."""

    def __init__(self, data):
        self.objects = {int(m[1]): m[2] for m in re.finditer(rb"(\d+) 0 obj\s(.*?)endobj", data, flags=re.S)}
        self.pages = [n for n, body in self.objects.items() if re.search(rb"/Type\s*/Page\b", body)]

    def content(self, page):
        stream = self.objects[int(re.search(rb"/Contents (\d+) 0 R", self.objects[page])[1])]
        raw = stream[stream.index(b"stream") + 6:stream.rindex(b"endstream")].lstrip(b"\r\n")
        return zlib.decompressobj().decompress(raw) if b"/FlateDecode" in stream else raw

    def aims(self):
        """Name of each place that a link leads to, and the page it lies on."""
        found = {}
        for body in self.objects.values():
            for name, page in re.findall(rb"[(/]([\w-]+)\)?\s*\[(\d+) 0 R\s*/XYZ", body):
                found[name.decode()] = self.pages.index(int(page))
        return found


def paper_errors(page, profile, fonts):
    pdf = page.with_name("page.pdf")
    marked = with_script(page, MARK, "marked.html")
    chromium(["--no-pdf-header-footer", f"--print-to-pdf={pdf}", marked.as_uri()], profile, fonts)
    printed = Printed(pdf.read_bytes())
    aims = printed.aims()
    ends = sorted(int(name[6:]) for name in aims if name.startswith("first-"))
    # a study and a lay table are mostly charts and long tables
    least = 1 if re.search(" - (study|lay table)</title>", page.read_text(encoding="utf-8")) else 4
    if len(ends) < least:
        yield f"only {len(ends)} things to be kept whole were found on paper"
    for i in ends:
        if aims[f"first-{i}"] != aims[f"last-{i}"]:
            yield f"number {i} of what is to stay whole is split over pages {aims[f'first-{i}'] + 1} and {aims[f'last-{i}'] + 1}"
    if aims.get("results", 1) != 1:
        yield f"the key results stand on page {aims['results'] + 1}, not on the second"
    # A page with little on it has little to draw and few letters; one that holds a figure has few letters only.
    sizes = [(len(text), sum(map(len, re.findall(rb"<([0-9A-F]+)>", text)))) for text in map(printed.content, printed.pages)]
    drawn, letters = (sorted(column)[len(sizes) // 2] for column in zip(*sizes))
    for number, (size, count) in enumerate(sizes[:-1], 1):
        if number > 1 and size < 0.2 * drawn and count < 0.35 * letters:
            yield f"page {number} of {len(sizes)} is nearly empty"


def main():
    arguments, fonts = sys.argv[1:], "dejavu"
    if arguments[0] == "--fonts":
        fonts, arguments = arguments[1], arguments[2:]
        if not installed(fonts):
            print(f"skipped: this machine has no {fonts} fonts (scripts/install.sh test)")
            sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        page, profile = written_page(arguments, folder), folder + "/profile"
        errors = [*screen_errors(page, profile, fonts), *paper_errors(page, profile, fonts)]
    for error in errors[:25]:
        print(error)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
