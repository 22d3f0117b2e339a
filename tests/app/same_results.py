"""Compares the results of second_folder dynamic runs that should be the same: prints what differs and returns 1.

    same_results.py FOLDER FOLDER      times that a clock measured and the name of the model file are left out
"""

import json
import pathlib
import sys

import h5py

MEASURED = {"wall_time", "real_time_ratio"}

first_folder, second_folder = (pathlib.Path(folder) for folder in sys.argv[1:])
offences = []
for name in ("pipe.csv", "supports.csv", "impacts.csv"):
    if (first_folder / name).read_bytes() != (second_folder / name).read_bytes():
        offences.append(name)


def unmeasured(value):
    if isinstance(value, dict):
        return {key: unmeasured(inner) for key, inner in value.items() if key not in MEASURED}
    return [unmeasured(inner) for inner in value] if isinstance(value, list) else value


summaries = [unmeasured(json.loads((folder / "summary.json").read_text(encoding="utf-8"))) for folder in (first_folder, second_folder)]
for part in summaries[0].keys() | summaries[1].keys():
    if summaries[0].get(part) != summaries[1].get(part):
        offences.append(f"summary.json: {part}")


def datasets(file):
    found = {}
    file.visititems(lambda name, item: found.update({name: item}) if isinstance(item, h5py.Dataset) else None)
    return found


with h5py.File(first_folder / "results.h5") as a, h5py.File(second_folder / "results.h5") as b:
    of_one, of_two = datasets(a), datasets(b)
    offences += [f"results.h5: {name} is in first_folder alone" for name in of_one.keys() ^ of_two.keys()]
    compared = 0
    for name in of_one.keys() & of_two.keys():
        if name.split("/")[-1] in MEASURED or name == "model/file":
            continue
        compared += 1
        first, second = of_one[name], of_two[name]
        if first.shape != second.shape or first.dtype != second.dtype:
            offences.append(f"results.h5: {name} has another shape")
        elif first.dtype.hasobject:
            if list(first[()].flat if first.shape else [first[()]]) != list(second[()].flat if second.shape else [second[()]]):
                offences.append(f"results.h5: {name}")
        elif first[()].tobytes() != second[()].tobytes():
            offences.append(f"results.h5: {name}")
    if compared < 100:
        offences.append(f"results.h5: only {compared} datasets")

print("\n".join(offences))
sys.exit(1 if offences else 0)
