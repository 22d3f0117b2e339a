"""The keys of the model file by task: the site's page "Keys by task", made from docs/input.md.

A key belongs to the task with the longest of its prefixes; a key without a task and a prefix without a key are errors.
"""

import html
import re
import urllib.parse

REFERENCE = "docs/input.md"

# Task, what it is about, guide page, prefixes of keys.
TASKS = [
    ("Head of the file and document control", "", "model", ["overbend", "title", "report"]),
    ("Water, current, waves and wind", "Depth and density, the current by depth, the sea, and the wind on a floating hull.",
     "model", ["environment", "vessel.motion.coupled.wind"]),
    ("Seabed, soil and friction", "Stiffness, friction, slope, uneven seabeds.", "lays", ["environment.seabed"]),
    ("Route", "Curved routes and their corners.", "lays", ["route"]),
    ("Pipe and coating", "Steel, coatings, contents, field joints, drag and added mass.", "model", ["pipe"]),
    ("Pipe of several sections", "Joints of another wall or coating along the pipe.", "model", ["pipe.segments"]),
    ("In-line structures, clumps and buoys on the pipe", "Arrestors, tees, terminations, point masses.",
     "in-line-structures", ["pipe.structures", "pipe.points"]),
    ("Tensioner", "Place, tension, and what it pays out and hauls in.", "dynamics", ["tensioner"]),
    ("Rollers", "Types of roller: radius, width, stiffness, friction, restitution.", "model", ["rollers"]),
    ("Ramp, stinger and supports", "Where the roller boxes are.", "model", ["supports"]),
    ("Stingers on hinges", "Hinges, sections, tanks, springs, settings.", "stinger",
     ["supports.stinger." + key for key in
      ("body", "hinge", "hinge_friction", "limits", "sections", "settings", "setting", "springs", "stop_stiffness",
       "tanks", "angle")]),
    ("Vessel", "Dimensions, attitude, stern shoe, loads.", "model", ["vessel"]),
    ("Vessel motion", "Prescribed motion: RAOs, records, harmonics, and the conventions of their files.", "dynamics",
     ["vessel.motion"]),
    ("Floating hull", "A hull that moves by its own equations: mass, hydrodynamics, damping, drift.", "moorings",
     ["vessel.motion.coupled"]),
    ("Moorings and anchors", "Mooring lines, winches, anchors.", "moorings", ["moorings"]),
    ("Dynamic positioning", "Station keeping by thrusters.", "moorings", ["station_keeping"]),
    ("Tugs, second vessels, platforms", "Other bodies that lines are fixed to.", "bodies", ["bodies"]),
    ("Cables, chains and flexibles", "Lines between two ends.", "moorings", ["lines"]),
    ("Operations and lifts", "Abandonment, recovery, start-up, shore pull, passage of structures, davit lifts.",
     "operations", ["operation"]),
    ("Code checks and limits", "DNV-ST-F101, API RP 1111, limits of the equipment, safety factors.", "checks", ["checks"]),
    ("Fatigue", "Damage of girth welds while the pipe is laid.", "fatigue", ["fatigue"]),
    ("Static analysis and mesh", "Solver, laying history, roller friction, element lengths.", "model",
     ["analysis", "analysis.static", "analysis.mesh"]),
    ("Time steps and impacts", "Integration in the time domain; the defaults usually suffice.", "dynamics",
     ["analysis.dynamic"]),
    ("Duration, seeds and output", "Length of a run, build-up, realisations, stored results.", "dynamics",
     ["analysis.dynamic.duration", "analysis.dynamic.build_up", "analysis.dynamic.seeds", "analysis.dynamic.output_step"]),
    ("Lay tables, goal seek and sensitivities", "Questions asked of one model. Studies have files of their own.", "seek",
     ["lay_table", "seek", "sensitivities"]),
]

ROW = re.compile(r"^\| `([^`]+)` \| (.*?) \| (.*?) \| (.*?) \| (.*) \|$", flags=re.M)


class TaskError(Exception):
    """Keys and tasks do not match."""


def rows(text):
    """Rows of the reference: key, kind, value if omitted, range, meaning. Keys of two kinds have two rows."""
    return [row.groups() for row in ROW.finditer(text)]


def begins_with(key, prefix):
    return key == prefix or (key.startswith(prefix) and key[len(prefix)] in ".[")


def keys_by_task(keys, tasks):
    """The keys of each task by its title."""
    owner_by_prefix = {prefix: title for title, _, _, prefixes in tasks for prefix in prefixes}
    used, found = set(), {title: [] for title, *_ in tasks}
    lost = []
    for key in dict.fromkeys(keys):
        prefixes = [prefix for prefix in owner_by_prefix if begins_with(key, prefix)]
        if not prefixes:
            lost.append(key)
            continue
        prefix = max(prefixes, key=len)
        used.add(prefix)
        found[owner_by_prefix[prefix]].append(key)
    if lost:
        raise TaskError("keys of no task, add them to TASKS in tools/site/key_tasks.py: " + ", ".join(lost))
    if set(owner_by_prefix) - used:
        raise TaskError("prefixes of no key: " + ", ".join(sorted(set(owner_by_prefix) - used)))
    return found


def breakable(key):
    """A key as code that lines may break after each part of the path."""
    return "<code>" + html.escape(re.sub(r"([*_\[\]])", r"\\\1", key)).replace(".", ".<wbr>") + "</code>"


def with_anchors(text):
    """The reference with an anchor at the first row of each key."""
    known = set()

    def anchored(row):
        key = row.group(1)
        if key in known:
            return row.group()
        known.add(key)
        return f'| <span id="{html.escape(key)}"></span>' + breakable(key) + row.group()[len(f"| `{key}`"):]

    return ROW.sub(anchored, text)


def cell(text):
    """Markdown of a table cell as HTML."""
    text = html.escape(text.replace("\\|", "|"), quote=False)
    return re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", re.sub(r"`([^`]+)`", r"<code>\1</code>", text))


def table(keys, rows_by_key):
    lines = ["<table class=\"keys\">", "<thead><tr><th>key</th><th>meaning</th><th>kind</th><th>if omitted</th></tr></thead>",
             "<tbody>"]
    for key in keys:
        found = rows_by_key[key]
        kind = " or ".join(dict.fromkeys(cell(row[1]) for row in found))
        meaning = " ".join(dict.fromkeys(cell(row[4]) for row in found))
        omitted = next((cell(row[2]) for row in found if row[2]), "")
        # A line may break after each part of the path.
        name = html.escape(key).replace(".", ".<wbr>")
        lines.append(f'<tr><td><a href="input.html#{urllib.parse.quote(key)}"><code>{name}</code></a></td>'
                     f"<td>{meaning}</td><td>{kind}</td><td>{omitted}</td></tr>")
    return "\n".join(lines + ["</tbody>", "</table>"])


def page(root):
    """The page of keys by task in Markdown."""
    found = rows((root / REFERENCE).read_text(encoding="utf-8"))
    rows_by_key = {}
    for row in found:
        rows_by_key.setdefault(row[0], []).append(row)
    parts = ["# Keys by task",
             "All keys of [the model file](input.md) by what they are for. `[]` denotes each item of a list and `*` a name of "
             "your own. A key leads to its row with unit, range and default.",
             '<p class="key-filter"><label for="key-filter">Filter</label> '
             '<input id="key-filter" type="search" placeholder="friction, drag, stinger radius, tension" '
             'autocomplete="off"> <span id="key-count" role="status"></span></p>']
    for title, about, guide, keys in ((t, a, g, k) for (t, a, g, _), k in
                                      zip(TASKS, keys_by_task(rows_by_key, TASKS).values())):
        parts += ["## " + title, (about + " " if about else "") + f"[Guide](guide/{guide}.md)", table(keys, rows_by_key)]
    parts.append("<script>\n" + (root / "tools/site/key_filter.js").read_text(encoding="utf-8") + "</script>")
    return "\n\n".join(parts) + "\n"
