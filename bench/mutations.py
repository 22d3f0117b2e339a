#!/usr/bin/env python3
"""Reads damaged input, solves what is accepted, and lists what crashes, hangs or fails without a message of its own.

    bench/mutations.py models|data COUNT SEED MODEL.yaml...

`models` damages the text of the models, `data` the files that they name. Every case is a function of its seed. Needs the
package overbend on PYTHONPATH.
"""

import random
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

MAX_TIME = 120.0  # of a case, after which it counts as hanging [s]
SPECIAL = [b"0", b"-1", b"1e308", b"-1e-308", b"nan", b"inf", b"999", b"1e6", b"0.001", b"", b"\xff", b"1,5", b"--", b"#"]
NUMBER = re.compile(rb"-?\d+\.?\d*(?:[eE][-+]?\d+)?")
NAMED = re.compile(r"[\w./-]+\.\w+")


def damage_number(data, rng):
    places = list(NUMBER.finditer(data))
    if not places:
        return data
    match = rng.choice(places)
    scaled = b"%g" % (float(match.group()) * rng.choice([-1.0, 0.0, 1e-3, 0.1, 0.5, 2.0, 10.0, 1e3, 1e9]))
    return data[: match.start()] + rng.choice([scaled, scaled, rng.choice(SPECIAL)]) + data[match.end() :]


def damage_line(data, rng):
    lines = data.split(b"\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    way = rng.randrange(4)
    if way == 0:
        del lines[i]
    elif way == 1:
        lines.insert(i, lines[j])
    elif way == 2:
        lines[i], lines[j] = lines[j], lines[i]
    else:
        lines[i] = lines[i][rng.randrange(4) :] if rng.random() < 0.5 else b"  " + lines[i]
    return b"\n".join(lines)


def damage_bytes(data, rng):
    if not data:
        return data
    i, way = rng.randrange(len(data)), rng.randrange(3)
    if way == 0:
        return data[:i] + bytes([rng.randrange(256)]) + data[i + 1 :]
    if way == 1:
        return data[:i] + data[i + rng.randrange(1, 9) :]
    return data[:i] if rng.random() < 0.2 else data[:i] + bytes(rng.randrange(256) for _ in range(3)) + data[i:]


def damaged(data, rng):
    for _ in range(rng.choice([1, 1, 1, 2, 4])):
        data = rng.choice([damage_number, damage_number, damage_line, damage_bytes])(data, rng)
    return data


def model_case(path, rng):
    return damaged(path.read_bytes(), rng).decode("utf-8", "surrogateescape").encode("utf-8", "replace").decode()


def data_case(path, rng, folder):
    text = path.read_text(encoding="utf-8")
    names = sorted({n for n in NAMED.findall(text) if (path.parent / n).is_file()})
    name = rng.choice(names)
    copy = Path(folder) / Path(name).name
    copy.write_bytes(damaged((path.parent / name).read_bytes(), rng))
    return text.replace(name, str(copy))


def work(kind, models, first, last):
    """Prints each case as it begins and as it ends."""
    import overbend

    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, last):
            print("begin", seed, flush=True)
            rng = random.Random(seed)
            path = Path(rng.choice(models))
            end = "solved"
            try:
                text = model_case(path, rng) if kind == "models" else data_case(path, rng, folder)
                model = overbend.Model.from_text(text, str(path.parent / "damaged.yaml"))
                model.static()
            except overbend.OverbendError as error:
                end = type(error).__name__
            except BaseException as error:  # noqa: BLE001: any other exception is an error of the program
                end = f"FAILURE {type(error).__name__}: {error}"[:300].replace("\n", " ")
            print("end", seed, end, flush=True)


def batch(kind, models, first, last, tally):
    """Runs cases in a process of their own; returns the next seed after a crash or a hang, else `last`."""
    command = [sys.executable, __file__, "--work", kind, str(first), str(last), *models]
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    seed, begun = first, time.monotonic()
    for line in child.stdout:
        word, number, *rest = line.split(" ", 2)
        seed = int(number)
        if word == "begin":
            begun = time.monotonic()
            continue
        end = rest[0].strip()
        if time.monotonic() - begun > MAX_TIME:
            end = f"FAILURE slow: {time.monotonic() - begun:.0f} s"
        if end.startswith("FAILURE"):
            print(seed, end, flush=True)
        tally[end.split(":")[0]] = tally.get(end.split(":")[0], 0) + 1
    if child.wait() == 0:
        return last
    print(seed, f"FAILURE crash: {child.returncode}", flush=True)
    tally["FAILURE crash"] = tally.get("FAILURE crash", 0) + 1
    return seed + 1


def main():
    kind, count, seed, *models = sys.argv[1:]
    tally, next_seed, end = {}, int(seed), int(seed) + int(count)
    while next_seed < end:
        next_seed = batch(kind, models, next_seed, min(next_seed + 500, end), tally)
    for name, cases in sorted(tally.items()):
        print(f"{name}: {cases}")


if __name__ == "__main__":
    if sys.argv[1] == "--work":
        work(sys.argv[2], sys.argv[5:], int(sys.argv[3]), int(sys.argv[4]))
    else:
        main()
