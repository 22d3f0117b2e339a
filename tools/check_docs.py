#!/usr/bin/env python3
"""Compares what the documents say with what the program knows.

    tools/check_docs.py PROGRAM

- Keys of the model file in backticks exist, and so do the values given with them: `analysis.static.laying: steady`.
- Defaults that a sentence names for a key are those of the program.
- Model files in ```yaml blocks, whole or in part, follow the program's JSON Schema.
- Command lines of `overbend` in ```sh blocks and in backticks have commands, options and files that exist.
- Options in backticks belong to a command.

Needs python3-jsonschema and python3-yaml. CHANGELOG.md is history and not checked.
"""

import copy
import json
import pathlib
import re
import shlex
import subprocess
import sys

import jsonschema
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tools" / "site")]
sys.dont_write_bytecode = True

import command_reference  # noqa: E402
import key_tasks  # noqa: E402

# Pages made from the program itself, and history.
NOT_CHECKED = {"docs/input.md", "docs/command-line.md", "CHANGELOG.md"}
FENCE = re.compile(r"^```(\w*)\n(.*?)^```", flags=re.M | re.S)
FILE_SUFFIXES = {"csv", "html", "pdf", "h5", "json", "yaml", "yml", "md", "py", "sh", "xlsx", "nc", "h", "cpp", "ts", "txt", "exe",
                 "bib", "ipynb", "log", "so", "asc"}
# Options of other programs.
OTHER_OPTIONS = {"--prefix", "--no-index", "--system-site-packages", "--config-settings", "--benchmark_filter"}
NUMBER = r"[-+]?\d+(?:,\d{3})*(?:\.\d+)?(?:e[-+]?\d+)?(?: ?%| (?:mm|cm|m|kN|MPa|s|ms|deg|kN/m|m/s|m/s\^2|min|h)\b)?"
VALUE = rf"(?:`([^`]+)`|({NUMBER}))"
DEFAULTS = [
    re.compile(rf"\bdefaults? (?:is |of |to |value )?{VALUE}"),
    re.compile(rf"\bdefault of `[^`]+` is {VALUE}"),
    re.compile(rf"\bby default,? {VALUE}"),
    re.compile(rf"{VALUE},? (?:by default|is the default|\(the default\)|\(default\))"),
    re.compile(rf"{VALUE},? the default\b"),
    re.compile(rf"{VALUE} if omitted"),
]


class Keys:
    """Keys of the model file with their kinds and defaults."""

    def __init__(self, reference):
        self.rows = key_tasks.rows(reference)
        self.patterns = [re.compile(self.pattern(row[0]) + "$") for row in self.rows]
        self.heads = {re.split(r"[.\[]", row[0])[0] for row in self.rows}

    @staticmethod
    def pattern(key):
        """Spellings of a key: items of lists by number or name or not at all, names of one's own."""
        return re.escape(key).replace(r"\[\]", r"(?:\[[^\]]*\])?").replace(r"\*", r"[^.\[\]]+")

    def find(self, text):
        """Rows of a key, given whole or by the end of its path."""
        whole = [row for row, pattern in zip(self.rows, self.patterns) if pattern.match(text)]
        if whole:
            return whole
        return [row for row in self.rows
                if re.search(r"(?:^|[.\]])" + self.pattern_of_end(text) + "$", row[0])]

    @staticmethod
    def pattern_of_end(text):
        return re.escape(text).replace(r"\[\]", r"\[\]").replace(r"\*", r"[^.]+")


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, encoding="utf-8", check=True).stdout


def pages():
    found = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").rglob("*.md")),
             *sorted((ROOT / "examples").glob("*.md"))]
    return [(path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")) for path in found]


def prose(text):
    """Text without blocks of code and without the tables of results that tools/check_examples.py holds."""
    return re.sub(r"<!-- example: .*?<!-- /example -->", "", FENCE.sub("", text), flags=re.DOTALL)


def sentences(text):
    """Sentences, items and cells of the prose, each on one line."""
    text = re.sub(r"\n(?![\n|*\-#>]|\d+\.)", " ", prose(text))
    return [part for line in text.splitlines() for part in re.split(r"(?<=[.;!?]) +(?=[A-Z`\[])| \| ", line)]


# Keys and values.


def result_names(types):
    """Names in results: of the program's types, of the code that writes files of results, of the Python package."""
    names = set(re.findall(r"^\s+(\w+)\??:", types, flags=re.M))
    for folder in ("resultfiles", "results", "study"):
        for source in (ROOT / "src/overbend" / folder).rglob("*.cpp"):
            for text in re.findall(r'"([\w.*\[\]]+)"', source.read_text(encoding="utf-8")):
                names.update(re.split(r"[.*\[\]]+", text))
    for module in (ROOT / "python/overbend").glob("*.py"):
        names.update(re.findall(r"def (\w+)", module.read_text(encoding="utf-8")))
    return names


def key_problems(page, text, keys, results):
    found = []
    for code in re.findall(r"`([^`\n]+)`", prose(text)):
        given = re.match(r"([a-z_]+(?:\[[^\]]*\])?(?:\.(?:[a-z_0-9]+|\*)(?:\[[^\]]*\])?)+)(?:: (\S.*))?$", code)
        if not given or given.group(1).rsplit(".", 1)[1] in FILE_SUFFIXES:
            continue
        path, value = given.groups()
        rows = keys.find(path)
        head = re.split(r"[.\[]", path)[0]
        parts = re.sub(r"\[[^\]]*\]|\*", "", path).split(".")
        if not rows and head in keys.heads and "['" not in path and not all(part in results | {""} for part in parts[1:]):
            found.append(f"{page}: `{path}` is neither a key of the model file nor a result")
        elif rows and value:
            found += value_problems(page, path, value, rows)
    return found


def choices(row):
    """Values that a key of a choice accepts."""
    accepted = re.match(r"`([^`]+)`", row[1])
    return re.split(r", | or ", accepted.group(1)) if accepted else []


def value_problems(page, path, value, rows):
    allowed = [choices(row) for row in rows]
    if not all(allowed) or any(" or " in row[1].rsplit("`", 1)[-1] for row in rows):
        return []
    if not re.fullmatch(r"[\w-]+", value) or any(value in accepted for accepted in allowed):
        return []
    return [f"{page}: `{path}: {value}`: the values are {', '.join(allowed[0])}"]


# Defaults.


def number_and_unit(text):
    parts = re.match(r"([-+]?[\d.,]+(?:e[-+]?\d+)?) ?(.*)$", text)
    try:
        return (float(parts.group(1).replace(",", "").rstrip(".")), parts.group(2)) if parts else None
    except ValueError:
        return None


def same_value(said, fallback):
    """Whether a default in prose is that of the program, which may be a value or a sentence."""
    said, fallback = said.strip(), fallback.replace("`", "").strip()
    if re.search(rf"(?<![\w.]){re.escape(said.lower())}(?![\w.])", fallback.lower()):
        return True
    said_number, default_number = number_and_unit(said), number_and_unit(fallback)
    if said_number and default_number and said_number[1] in ("", default_number[1]):
        return said_number[0] == default_number[0]
    if not said_number or not default_number or said_number[1] != "%" or default_number[1]:
        return False
    return abs(said_number[0] - 100 * default_number[0]) < 1e-9


def default_problems(page, text, keys):
    """Problems, and the number of defaults that were compared."""
    found, compared = [], 0
    for sentence in sentences(text):
        if "default" not in sentence.lower() and "if omitted" not in sentence:
            continue
        names = [code for code in re.findall(r"`([^`]+)`", sentence)
                 if re.fullmatch(r"[a-z_]+(?:[.\[\]*\w]*)(?:: .+)?", code) and keys.find(code.split(": ")[0])]
        names = [name for name in dict.fromkeys(names) if "." in name or ": " in name or "_" in name]
        if len(names) != 1:
            continue
        key, _, value = names[0].partition(": ")
        rows = keys.find(key)
        said = [next(group for group in match.groups() if group) for pattern in DEFAULTS for match in pattern.finditer(sentence)]
        for word in said:
            word = word.partition(": ")[2] or word
            if word == key or (not number_and_unit(word) and not any(word in choices(row) for row in rows)):
                continue
            compared += 1
            if not any(same_value(word, row[2]) for row in rows if row[2]):
                defaults = ", ".join(dict.fromkeys(row[2] for row in rows if row[2])) or "none"
                found.append(f"{page}: `{key}`: default {word} here, {defaults} in the program: {sentence.strip()}")
    return found, compared


# Model files in part.


def loose(schema):
    """A JSON Schema that does not ask for keys that are left out."""
    if isinstance(schema, list):
        return [loose(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    kept = {name: loose(value) for name, value in schema.items()
            if name not in ("required", "dependencies", "minProperties", "minItems")}
    for name in ("anyOf", "oneOf", "allOf"):
        if name in kept and any(part == {} for part in kept[name]):
            del kept[name]
    return kept


def groups(schema):
    """All groups of keys in a schema."""
    if isinstance(schema, dict):
        if "properties" in schema and isinstance(schema["properties"], dict):
            yield schema
        for value in schema.values():
            yield from groups(value)
    elif isinstance(schema, list):
        for value in schema:
            yield from groups(value)


def top_items(block):
    """The items of the first level of a block, each alone: a block may show the same key in two ways."""
    block = re.sub(r"^(\s*)\.\.\.\s*$", "", block, flags=re.M)
    lines = block.splitlines()
    indent = min((len(line) - len(line.lstrip()) for line in lines if line.strip() and not line.lstrip().startswith("#")),
                 default=0)
    starts = [i for i, line in enumerate(lines) if re.match(r"\s{%d}[\w'\"*-]" % indent, line)]
    return ["\n".join(lines[a:b]) for a, b in zip(starts, starts[1:] + [len(lines)])]


def model_problems(page, text, schema, all_groups, in_studies):
    """Problems of the YAML blocks, and the number of items that were compared."""
    found, compared = [], 0
    for language, block in FENCE.findall(text):
        if language != "yaml" or re.match(r"\s*overbend_study:", block):
            continue
        for item in top_items(block):
            try:
                value = yaml.load(item, Loader=yaml.BaseLoader)
            except yaml.YAMLError as error:
                found.append(f"{page}: a YAML block cannot be read: {item.splitlines()[0]}: {error}".replace("\n", " "))
                continue
            value = without_dots(value)
            value = value[0] if isinstance(value, list) and value else value
            if not isinstance(value, dict):
                continue
            name = next(iter(value))
            if name in schema["properties"]:
                candidates = [schema]
            else:
                candidates = [group for group in all_groups if name in group["properties"]]
            if not candidates:
                if name not in in_studies:
                    found.append(f"{page}: `{name}` in a YAML block is no key of the model file")
                continue
            errors = [list(jsonschema.Draft7Validator(group).iter_errors(typed(value, group))) for group in candidates]
            compared += 1
            if all(errors):
                best = min(errors, key=len)[0]
                path = ".".join(str(part) for part in best.absolute_path)
                found.append(f"{page}: `{name}` in a YAML block: {path}: {best.message[:200]}")
    return found, compared


def study_names(texts):
    """Names of keys in study files and in blocks that show them."""
    blocks = [block for text in texts for language, block in FENCE.findall(text)
              if language == "yaml" and re.match(r"\s*overbend_study:", block)]
    blocks += [path.read_text(encoding="utf-8") for path in (ROOT / "examples/studies").glob("*.yaml")]
    return {name for block in blocks for name in re.findall(r"^[ -]*(\w+):", block, flags=re.M)}


def without_dots(value):
    """A YAML value without '...', which stands for what a page leaves out."""
    if isinstance(value, dict):
        return {name: without_dots(item) for name, item in value.items() if "..." not in (name, item)}
    if isinstance(value, list):
        return [without_dots(item) for item in value if item != "..."]
    return value


def typed(value, schema):
    """A YAML value with numbers where it has numbers, as the schema's types expect."""
    if isinstance(value, dict):
        return {name: typed(item, schema) for name, item in value.items()}
    if isinstance(value, list):
        return [typed(item, schema) for item in value]
    try:
        number = float(value)
    except (TypeError, ValueError):
        return value
    return int(number) if number.is_integer() and re.fullmatch(r"[-+]?\d+", value) else number


# Command lines.


def command_lines(text):
    """Calls of the program in blocks and in backticks."""
    for language, block in FENCE.findall(text):
        if language in ("sh", "bash", "console"):
            for line in block.replace("\\\n", " ").splitlines():
                call = re.match(r"\s*(?:\$ )?(?:\w+=\S+ )*(?:\S*/)?overbend (.*)", line)
                if call:
                    yield call.group(1)
    for code in re.findall(r"`([^`\n]+)`", prose(text)):
        call = re.match(r"(?:\w+=\S+ )*(?:\S*/)?overbend ([a-z].*)", code)
        if call:
            yield call.group(1)


def command_problems(page, call, options):
    try:
        arguments = shlex.split(call, comments=True)
    except ValueError:
        return [f"{page}: `overbend {call}`: quotes do not match"]
    end = next((i for i, argument in enumerate(arguments) if argument in ("|", ">", "&&", ";", "2>&1")), len(arguments))
    arguments = arguments[:end]
    if not arguments or arguments[0] in ("--version", "--help", "-h", "COMMAND", "COMMAND...") or "[OPTIONS]" in arguments:
        return []
    command = arguments[0]
    if command not in options:
        return [f"{page}: `overbend {call}`: no such command"]
    found = []
    for word in arguments[1:]:
        name = word.split("=")[0]
        if name.startswith("-") and not re.match(r"-\d", name) and name not in options[command] | {"--help", "-h"}:
            found.append(f"{page}: `overbend {call}`: no option {name}")
        if re.match(r"(examples|validation|data)/", word) and not (ROOT / word).exists():
            found.append(f"{page}: `overbend {call}`: no file {word}")
    return found


def option_problems(page, text, options):
    known = set().union(*options.values()) | OTHER_OPTIONS | {"--help", "--version"}
    return [f"{page}: `{code}`: no command has this option" for code in re.findall(r"`(--?[a-z][^`\n]*)`", prose(text))
            if code.startswith("--") and re.split(r"[ =]", code)[0] not in known]


def main():
    program = sys.argv[1]
    keys = Keys(run(program, "schema", "--reference"))
    results = result_names(run(program, "schema", "--types"))
    schema = loose(copy.deepcopy(json.loads(run(program, "schema"))))
    all_groups = list(groups(schema))
    options = {command: set(command_reference.options(program, command)) for command in command_reference.commands(program)}
    in_studies = study_names([text for _, text in pages()])
    found, defaults, models, calls = [], 0, 0, 0
    for page, text in pages():
        for call in command_lines(text):
            calls += 1
            found += command_problems(page, call, options) if page not in NOT_CHECKED else []
        if page in NOT_CHECKED:
            continue
        found += option_problems(page, text, options)
        found += key_problems(page, text, keys, results)
        more, compared = default_problems(page, text, keys)
        found, defaults = found + more, defaults + compared
        more, compared = model_problems(page, text, schema, all_groups, in_studies)
        found, models = found + more, models + compared
    for line in found:
        print(line, file=sys.stderr)
    print(f"compared: {defaults} defaults, {models} parts of models, {calls} command lines; {len(found)} contradictions")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
