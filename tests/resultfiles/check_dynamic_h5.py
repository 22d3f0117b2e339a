"""Reads the dynamic part of a results file with h5py as a user would; prints what offends and returns 1."""

import sys

import h5py
import numpy

offences = []


def expect(true, what):
    if not true:
        offences.append(what)


def scales(dataset, dimension):
    return list(dataset.dims[dimension].keys())


with h5py.File(sys.argv[1]) as results:
    dynamic = results["dynamic"]
    row = numpy.arange(50_000)
    histories = dynamic["histories"]
    expect(numpy.array_equal(histories["time"][:], 0.25 * (row - 40)), "time")
    names = ["top_tension", "heave", "support/b 8/reaction", "support/b 8/separation"]
    for column, name in enumerate(names, start=1):
        history = histories[name]
        expect(numpy.allclose(history[:], numpy.sin(column * row), rtol=0, atol=1e-9), f"history {name}")
        expect(scales(history, 0) == ["time"], f"history {name} is not over time")
        expect(history.chunks and history.compression == "gzip", f"history {name} is not compressed")
    expect(histories["support/b 8/reaction"].attrs["units"] == "N", "units of a history")
    thinned = dynamic["thinned"]
    expect(list(thinned["name"].asstr()[:]) == names, "names of the thinned histories")
    first, count = thinned["first"][1], thinned["count"][1]
    expect(count == 2000, "2000 stretches")
    expect(numpy.array_equal(thinned["low"][first:first + count], histories["heave"][:].reshape(2000, 25).min(axis=1)),
           "least values of stretches")
    expect(numpy.isclose(thinned["std"][1], histories["heave"][40:].std(), rtol=1e-12), "standard deviation")

    impacts = dynamic["impacts"]
    number = numpy.arange(20_000)
    expect(numpy.array_equal(impacts["roller"][:], number % 7), "rollers of impacts")
    expect(numpy.array_equal(impacts["peak_force"][:], 1e5 + number), "forces of impacts")

    snapshots = dynamic["snapshots"]
    instant = numpy.arange(37)[:, None]
    expect(numpy.array_equal(snapshots["time"][:], instant[:, 0]), "times of snapshots")
    for place, name in enumerate(["x", "y", "z", "effective_tension", "von_mises"]):
        expect(numpy.array_equal(snapshots[name][:], 1000.0 * instant + 5 * numpy.arange(40) + place), f"snapshots {name}")
        expect(scales(snapshots[name], 0) == ["time"] and scales(snapshots[name], 1) == ["s"], f"scales of {name}")
    expect(numpy.array_equal(snapshots["vessel_position"][:], 1000.0 * instant + 200 + numpy.arange(3)), "pose")
    expect(numpy.array_equal(snapshots["vessel_axes"][:].reshape(37, 9), 1000.0 * instant + 203 + numpy.arange(9)), "axes")

    stations = dynamic["stations"]
    for name, column in stations.items():
        expect(len(column) == 40 and (name == "s" or scales(column, 0) == ["s"]), f"column {name} of the stations")
    for statistic in ("min", "max", "mean", "std"):
        expect(f"effective_tension_{statistic}" in stations, f"envelope {statistic}")
    density = dynamic["spectra/support/b 8/reaction/density"]
    expect(density.attrs["units"] == "(N)^2/Hz" and scales(density, 0) == ["frequency"], "spectrum")

print("\n".join(offences))
sys.exit(1 if offences else 0)
