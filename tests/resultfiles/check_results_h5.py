"""Reads a results file with h5py as a user would; prints what offends and returns 1."""

import sys

import h5py
import numpy

offences = []
UNITS = {"1", "m", "rad", "rad/s", "N", "N m", "1/m", "Pa", "N/m", "N m2", "m2", "m4", "kg/m", "s", "m/s", "N s", "J", "Hz", "(N)^2/Hz",
         "see column units"}


def look(name, item):
    if not item.attrs.get("description"):
        offences.append(f"{name}: no description")
    if isinstance(item, h5py.Dataset):
        if item.attrs.get("units") not in UNITS:
            offences.append(f"{name}: units {item.attrs.get('units')!r}")
        if not item.attrs.get("frame"):
            offences.append(f"{name}: no frame")
        if item.parent.name == "/static/stations" and name != "static/stations/s" and "s" not in item.dims[0].keys():
            offences.append(f"{name}: not over s")


with h5py.File(sys.argv[1]) as results:
    results.visititems(look)
    for attribute in ("Conventions", "title"):
        if not results.attrs.get(attribute):
            offences.append(f"no {attribute}")
    for key in ("text", "hash", "version", "machine", "compiler"):
        if not results[f"model/{key}"][()]:
            offences.append(f"model/{key} is empty")
    hash_ = 0xCBF29CE484222325
    for byte in results["model/text"][()]:
        hash_ = (hash_ ^ byte) * 0x100000001B3 % 2**64
    if results["model/hash"].asstr()[()] != f"fnv1a64:{hash_:016x}":
        offences.append("the hash is not that of the text")
    stations = results["static/stations"]
    s = stations["s"][:]
    if len(s) < 50 or (numpy.diff(s) <= 0).any():
        offences.append("stations do not run along the pipe")
    if not set(stations["region"].asstr()[:]) <= {"tower", "overbend", "sagbend", "seabed"}:
        offences.append("a region without a name")
    extremes = [results[f"static/{region}/bending_moment/value"][()] for region in ("overbend", "sagbend")
                if f"static/{region}" in results]
    if not numpy.isclose(stations["bending_moment"][:].max(), max(extremes), rtol=1e-3):
        offences.append("the largest moment of the stations is not that of the regions")

print("\n".join(offences))
sys.exit(1 if offences else 0)
