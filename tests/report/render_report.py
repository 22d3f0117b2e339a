#!/usr/bin/env python3
"""Solves an example, opens its report in headless Chromium and looks whether every figure was drawn.

    render_report.py PROGRAM MODEL.yaml
    render_report.py --made-by PROGRAM [WORD ...]
    render_report.py --compared PROGRAM MODEL.yaml tensioner|contact DURATION

The second form calls PROGRAM FILE.html WORD ... to write the page; the third looks at the page of a comparison.

Fails on any error of the page's scripts, on an empty panel, on a figure without axis labels and on marks of missing
numbers (NaN, undefined) in what was drawn.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from fonts import environment

FLAGS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--enable-logging=stderr",
]


def rendered(page, profile):
    """The page's document after its scripts have run, and what they complained about."""
    done = subprocess.run(
        ["chromium", *FLAGS, f"--user-data-dir={profile}", "--virtual-time-budget=5000", "--dump-dom", page.as_uri()],
        capture_output=True, encoding="utf-8", timeout=120, check=True, env=environment())
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


def find_page_errors(document):
    """What is wrong with the drawn page."""
    if 'data-drawn="yes"' not in document:
        yield "the scripts did not run to their end"
    body = document[document.index("<body>"):]
    drawn = re.sub(r"<script.*?</script>", "", body, flags=re.S)
    panels = re.findall(r'<div class="panel(?: multiples)?" data-figure="(\w+)" data-part="(\w+)">(.*?)</div>', drawn, flags=re.S)
    if not panels:
        yield "there are no panels"
    for figure, part, content in panels:
        shapes = len(re.findall(r"<(path|rect|polygon|polyline|circle)\b", content))
        if "<svg" not in content or shapes < 5:
            yield f"{figure}/{part}: nothing drawn"
    for word in ("NaN", "undefined", "Infinity"):
        for found in re.finditer(word, drawn):
            yield f"'{word}' in: ...{drawn[max(0, found.start() - 80):found.end() + 20]!r}"


def written_page(arguments, folder):
    """The page that the words of the command line ask for."""
    if arguments[0] == "--made-by":
        page = pathlib.Path(folder, "report.html")
        subprocess.run([arguments[1], str(page), *arguments[2:]], check=True)
        return page
    if arguments[0] == "--compared":
        _, program, model, what, duration = arguments
        subprocess.run([program, "compare", model, "--of", what, "--duration", duration, "-o", folder + "/out"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return pathlib.Path(folder, "out", "comparison.html")
    if arguments[0] == "--lay-table":
        _, program, model = arguments
        subprocess.run([program, "lay-table", model, "-o", folder + "/out"], check=True, stdout=subprocess.DEVNULL)
        return pathlib.Path(folder, "out", "report.html")
    program, model = arguments
    subprocess.run([program, "static", model, "-o", folder + "/out"], check=True, stdout=subprocess.DEVNULL)
    return pathlib.Path(folder, "out", "report.html")


def main():
    if not shutil.which("chromium"):
        sys.exit("chromium is not installed")
    with tempfile.TemporaryDirectory() as folder:
        page = written_page(sys.argv[1:], folder)
        document, complaints = rendered(page, folder + "/profile")
        errors = complaints + list(find_page_errors(document))
    for error in errors[:20]:
        print(error)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
