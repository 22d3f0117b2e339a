#!/usr/bin/env python3
"""Holds sources, messages and documents to the project's vocabulary (CONTRIBUTING.md, "Words").

usage: tools/check_words.py [--count] [--root FOLDER] [PATH...]     paths of files or folders; the whole tree without any

Prints file:line, the kind of text (identifier, comment, message, document), what was found and what to write instead.
Exit code 1 if anything was found.
"""

import argparse
import collections
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SKIPPED_FOLDERS = ("build", "node_modules", "dist", ".git")

# Words of identifiers, after they are split at underscores and capitals.
WORDS = {
    "told": "given, prescribed or reported", "tell": "report_, print_ or add_", "tells": "reports", "telling": "reporting",
    "beside": "next_to, neighbouring, in addition to", "besides": "in addition to",
    "hang": "name the mechanics", "hangs": "depends on", "hanging": "suspended", "hung": "suspended",
    "least": "min_", "most": "max_", "largest": "max_", "smallest": "min_", "greatest": "max_", "longest": "max_",
    "shortest": "min_", "fault": "error", "faults": "errors", "refuse": "reject", "refused": "rejected",
    "refuses": "rejects", "refusal": "rejection", "obstacle": "unsupported", "obstacles": "unsupported",
    "foresight": "extrapolation", "foreseen": "extrapolated", "doorkeeper": "connection limiter",
    "stranger": "unauthenticated", "strangers": "unauthenticated", "words": "label, message, name or text",
    "giving": "payout", "gave": "payout", "nobody": "no user", "anybody": "a user", "wish": "request",
    "happening": "event", "resort": "fallback", "fro": "cycle",
}  # fmt: skip
MIN_AND_MAX = {"least", "most", "largest", "smallest", "greatest", "longest", "shortest"}
# Whole identifiers that name nothing.
NAMES = {"at", "one", "now", "there", "here", "own", "other"}
# Functions of languages and libraries whose names are theirs.
BORROWED = {
    "indexOf", "lastIndexOf", "typeof", "instanceof", "valueOf", "none_of", "any_of", "all_of", "rtnOf",
    "findLastIndexOf", "posToVal", "isPrototypeOf", "offset_of", "oneOf", "anyOf", "allOf",
    "least_squares", "inequality_least_squares", "find_first_of",
    "find_first_not_of", "find_last_not_of", "find_last_of", "at_least", "at_most", "most_probable_max",
    "most_probable_min", "most_probable_utilisation", "most_influential_inputs", "find_least_damped",
    "break_long_words",
}  # fmt: skip

# Enumerators that mean what they say, and `at` where it is the key of the model file.
ALLOWED = {
    "src/overbend/model/description/hull_description.h": {"at"},
    "src/overbend/model/description/line_description.h": {"at"},
    "src/overbend/model/description/stinger_description.h": {"at"},
    "src/overbend/model/description/structure_description.h": {"at"},
    "src/overbend/mechanics/line_kernel_energy.h": {"at"},
    "src/overbend/mechanics/moving_vessel.h": {"at"},
    "src/overbend/base/assumption.h": {"other"},
    "src/overbend/statics/solver/statics.h": {"other"},
    "src/overbend/seafiles/netcdf_arrays.h": {"other"},
    "python/overbend/plots/study_plots.py": {"at"},  # parameter of StudyPlots.curve() and map()
    "tests/python/test_plots.py": {"at"},
}

# Public names of the Python package.
ALLOWED_PYTHON = {"Fault", "faults"}

# Names of JSON members that the page reads.
JSON_NAMES = {"at", "obstacle", "words"}
JSX_TEXT = re.compile(r"(?<!\bconst)(?<!\blet)(?<!\breturn)(?<!\bof)(?<!\bin)(?<!\bawait)(?<!\bnew)[A-Za-z,.%*\"] $")

PHRASES = [
    (r"\btold\b|\btells?\b|\btelling\b", "given, prescribed, reported, prints"),
    (r"\bbesides?\b", "next to, in addition to, neighbouring"),
    (r"\b(hangs?|hung|hanging) on\b", "depends on; a load: is suspended from"),
    (r"\b(gives?|gave|given|giving) way\b", "renders, slips, pays out, drags"),
    (r"\brefus(e|es|ed|al|als|ing)\b", "reject, is not supported"),
    (r"\bfaults?\b", "error"),
    (r"\bobstacles?\b", "unsupported feature"),
    (r"\bnobody\b|\banybody\b|\bsomebody\b", "name the user or the program"),
    (r"\bwhatever\b|\bhowsoever\b", "any, regardless of"),
    (r"\bdoorkeeper\b|\bstrangers?\b", "connection limiter, unauthenticated connection"),
    (r"\bforesight\b|\bforesees?\b|\bforeseen\b", "extrapolation, extrapolated, predicted"),
    (r"\b(comes?|came|coming) to rest\b", "reaches equilibrium"),
    (r"\bto and fro\b", "cycle between two states"),
    (r"\bmend(s|ed|ing)?\b", "correct, fix"),
    (r"\bstood still\b|\bstands? still\b", "is constant, is at rest"),
    (r"\bas such\b", "itself, normal"),
    (r"\blooks? on\b|\blooked on\b", "observe"),
    (r"\bof (its|their) own accord\b", "by itself"),
    (r"\blet go\b|\blets go\b", "release"),
    (r"\btakes? (it )?up again\b", "resume"),
]
PHRASES = [(re.compile(pattern, re.IGNORECASE), instead) for pattern, instead in PHRASES]
OPENING = re.compile(r"^(What|How|Whether|Of|Where|Who|Whose|That which)\b")
QUOTED = re.compile(r"`[^`\n]*`|https?://\S+|\]\([^)]*\)")

CPP = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<raw>R"(?P<mark>\w*)\(.*?\)(?P=mark)")|'
    r"(?P<text>\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*')|(?P<include>^[ \t]*\#[ \t]*include[^\n]*)|"
    r"(?P<name>(?:(?:->|\.|::)\s*)?[A-Za-z_]\w*)",
    re.DOTALL | re.MULTILINE,
)
SCRIPT = re.compile(
    r"(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<raw>(?<=[(,=:\[ ])/(?![/*\s])(?:\\.|[^/\\\n])+/[gimsuy]*)|"
    r"(?P<text>'(?:\\.|[^'\\\n])*'|\"(?:\\.|[^\"\\\n])*\"|`(?:\\.|[^`\\])*`)|"
    r"(?P<name>(?:\?\.|\.)?[A-Za-z_$][\w$]*)",
    re.DOTALL,
)
PYTHON = re.compile(
    r'(?P<comment>\#[^\n]*)|(?P<text>"""(?:.*?)"""|\'\'\'(?:.*?)\'\'\'|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')|'
    r"(?P<name>\.?[A-Za-z_]\w*)",
    re.DOTALL,
)
LANGUAGES = {".h": CPP, ".cpp": CPP, ".ts": SCRIPT, ".tsx": SCRIPT, ".mjs": SCRIPT, ".py": PYTHON}
LEFT_OUT = (
    "docs/python/reference.md", "CHANGELOG.md", "tools/check_words.py", "tests/tools/check_words_test.py",
    "web/src/api/types.ts", "CONTRIBUTING.md",
)  # fmt: skip


def words_of_identifier(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower().split("_")


def check_identifier(name, is_member, is_called, is_cpp, in_test):
    """Yields (found, instead) for an identifier. Names of tests are sentences: min_ and max_ do not read as such.

    In TypeScript names with underscores, in Python all public names are those of the results, a promise to users.
    """
    if name in BORROWED or name.startswith("__"):
        return
    if name in NAMES and not is_member and not is_called:
        yield name, "name the thing"
    is_sentence = in_test and name.count("_") >= 3
    if not is_sentence and re.search(r"_of_?$|[a-z]Of$", name):
        yield name, "make_, compute_, find_ or a noun"
    words = words_of_identifier(name)
    for word, following in zip(words, [*words[1:], ""]):
        if word in MIN_AND_MAX and (is_sentence or not is_cpp):
            continue
        if word in WORDS:
            yield name, WORDS[word]
        elif word == "still" and following != "water" and not is_sentence:
            yield name, "statics_only, still_water, at_rest"


def check_prose(text):
    text = QUOTED.sub(lambda m: " " * len(m.group(0)), text)
    for pattern, instead in PHRASES:
        for match in pattern.finditer(text):
            yield match.group(0), instead, match.start()


def check_code(path, text):
    in_test = path.startswith(("tests/", "web/e2e/", "web/tests/", "bench/")) or "/tests/" in path
    is_cpp = path.endswith((".h", ".cpp"))
    for match in LANGUAGES[Path(path).suffix].finditer(text):
        found, start, kind = match.group(0), match.start(), match.lastgroup
        if kind == "name":
            name = found.lstrip(".:->? \t\n")
            is_member = found.lstrip().startswith((".", ":", "-", "?"))
            is_called = text[match.end() : match.end() + 1] == "("
            if path.endswith(".py") and name in ALLOWED_PYTHON:
                continue
            if name in ALLOWED.get(path, ()) or path.startswith("web/") and name in JSON_NAMES:
                continue
            if path.endswith(".tsx") and name in NAMES and JSX_TEXT.search(text, max(start - 12, 0), start):
                continue
            if not is_cpp and "_" in name and path.startswith("web/"):
                continue
            for what, instead in check_identifier(name, is_member, is_called, is_cpp, in_test):
                yield start + len(found) - len(name), "identifier", what, instead
        elif kind == "comment":
            for what, instead, place in check_prose(found):
                yield start + place, "comment", what, instead
            opening = OPENING.match(found.lstrip("/*<!# \n"))
            if opening:
                yield start, "comment", opening.group(0) + " ...", "say the noun: 'Number of', 'Distance from', 'True if'"
        elif kind in ("text", "raw", "mark") and " " in found:
            for what, instead, place in check_prose(found):
                yield start + place, "message", what, instead


def check_document(_, text):
    text = re.sub(r"```.*?```", lambda m: re.sub(r"[^\n]", " ", m.group(0)), text, flags=re.DOTALL)
    for what, instead, place in check_prose(text):
        yield place, "document", what, instead


def files(root, paths):
    """Paths of the texts below `paths` (all, if there are none), relative to `root`."""
    for start in paths or ["."]:
        found = [root / start] if (root / start).is_file() else sorted((root / start).rglob("*"))
        for file in found:
            path = file.relative_to(root).as_posix()
            if path in LEFT_OUT or any(part in SKIPPED_FOLDERS for part in Path(path).parts) or not file.is_file():
                continue
            if file.suffix in LANGUAGES or file.suffix == ".md":
                yield path


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", action="store_true", help="print numbers by kind and word instead of every place")
    parser.add_argument("--root", type=Path, default=ROOT, help="root of the tree")
    parser.add_argument("paths", nargs="*")
    options = parser.parse_args()
    counts = collections.Counter()
    for path in files(options.root.resolve(), options.paths):
        text = (options.root / path).read_text(encoding="utf-8")
        check = check_document if path.endswith(".md") else check_code
        for place, kind, what, instead in check(path, text):
            counts[kind, what.lower()] += 1
            if not options.count:
                print(f"{path}:{text.count(chr(10), 0, place) + 1}: {kind} '{what}': {instead}")
    for (kind, what), number in counts.most_common() if options.count else ():
        print(f"{number:6} {kind:10} {what}")
    total = sum(counts.values())
    print(f"words: {total} to change" if total else "words: none to change")
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main())
