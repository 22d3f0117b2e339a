"""The elevation of a lay: pipe, vessel, rollers, water and seabed."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from . import drawing as draw
from .along import AlongPipe, has_supports

X_LABEL, Z_LABEL = "Distance astern of the stern shoe [m]", "Height [m]"


def elevation(static: Any, ax: Optional[Any], overbend: bool) -> Any:
    """Draws heights over the distance astern: the whole line true to scale, the overbend with its heights enlarged."""
    pipe, scene = static.pipe, static.scene
    end = AlongPipe.find_end(static, overbend)
    seen = float(static.total_length) - np.asarray(pipe["s"]) <= end
    x, z = np.asarray(pipe["astern"])[seen], np.asarray(pipe["z"])[seen]
    hull = _hull(scene)
    left = x.min() - 4 if overbend else min(x.min(), hull[:, 0].min()) - 5
    across = (left, x.max() + 0.02 * (x.max() - left))
    bed = _bed(static, np.linspace(*across, 400))
    low = z.min() if overbend else min(z.min(), bed[:, 1].min())
    high = z.max() if overbend else max(z.max(), hull[:, 1].max())
    above = max(0.14 * (high - low), 0.0 if overbend else 0.04 * np.ptp(across))  # for the word above the tensioner
    up = (low - (0.12 if overbend else 0.06) * (high - low), high + above)
    ax = draw.axes(ax, (9.6, 4.2) if overbend else _figure(np.ptp(across), np.ptp(up)))
    _surroundings(ax, hull, bed, across, up)
    _rollers(static, ax) if overbend else _structure(static, ax)
    ax.plot(x, z, color=draw.PIPE, linewidth=1.9, label="pipe axis" if overbend else None, zorder=3)
    ax.set_xlim(*across)
    ax.set_ylim(*up)
    ax.grid(False)
    title = "Elevation, overbend (heights enlarged)" if overbend else "Elevation, whole line (true to scale)"
    draw.label(ax, title, X_LABEL, Z_LABEL, of=static.title)
    top = np.asarray(pipe["astern"])[-1], np.asarray(pipe["z"])[-1]
    draw.mark(ax, float(top[0]), float(top[1]), "tensioner")
    if overbend:
        return ax
    touchdown = static.touchdown
    astern = float(touchdown["astern"])
    ax.plot([astern], [float(touchdown["z"])], "o", color=draw.ACCENT, markeredgecolor="white", markersize=7, zorder=5)
    ax.annotate(f"touchdown at {draw.length(astern)}", (astern, float(touchdown["z"])), xytext=(0, 9),
                textcoords="offset points", ha="center", color=draw.ACCENT, fontsize="small", fontweight="bold",
                path_effects=draw.halo(), zorder=6)
    ax.set_aspect("equal", adjustable="box")
    return ax


def distance_astern(scene: Any, places: np.ndarray) -> np.ndarray:
    """Distances astern of the stern shoe [m] along the vessel's axis of places in W [m], shape (n, 3)."""
    forward = np.asarray(scene["vessel_axes"]).reshape(3, 3)[:, 0].copy()
    forward[2] = 0.0
    return -(places - np.asarray(scene["stern_shoe"])) @ (forward / np.linalg.norm(forward))


def _figure(wide: float, tall: float) -> tuple[float, float]:
    """Size of a figure [in] for a range that is drawn true to scale."""
    height = 8.6 * tall / wide + 0.9
    return (9.6, float(np.clip(height, 2.2, 7.0)))


def _hull(scene: Any) -> np.ndarray:
    """Corners of the hull's side, astern and up [m], shape (4, 2); a point if its size is unknown."""
    length, deck = float(scene["vessel_length"]), float(scene["vessel_depth"]) - float(scene["vessel_draught"])
    keel = -float(scene["vessel_draught"])
    return np.array([(0, keel), (-length, keel), (-length, deck), (0, deck)])


def _bed(static: Any, x: np.ndarray) -> np.ndarray:
    """Elevations of the seabed under the line, shape (n, 2): of a plane through touchdown, or of an uneven seabed."""
    if "bed_heights" in dir(static):
        heights = static.bed_heights
        return np.column_stack([x, np.interp(x, np.asarray(heights["x"]), np.asarray(heights["z"]))])
    scene, touchdown = static.scene, static.touchdown
    astern, z = float(touchdown["astern"]), float(touchdown["z"]) - 0.5 * float(scene["pipe_outer_diameter"])
    z0 = -float(scene["water_depth"])
    slope = (z - z0) / astern if abs(astern) > 1 else 0.0
    return np.column_stack([x, z0 + slope * x])


def _surroundings(ax: Any, hull: np.ndarray, bed: np.ndarray, across: tuple[float, float],
                  up: tuple[float, float]) -> None:
    ax.fill_between(across, up[0], 0.0, color=draw.WATER, linewidth=0, zorder=0)
    ax.fill_between(bed[:, 0], min(up[0], bed[:, 1].min()) - 1, bed[:, 1], color=draw.BED, linewidth=0, zorder=0.5)
    ax.plot(across, (0, 0), color="#6fa8cc", linewidth=1.0, zorder=0.6)
    ax.fill(hull[:, 0], hull[:, 1], facecolor="#c3ccd5", alpha=0.55, edgecolor=draw.STEEL, zorder=0.7)


def _structure(static: Any, ax: Any) -> None:
    """Ramp and stinger as a thick line under the pipe."""
    if has_supports(static):
        places = np.column_stack([np.asarray(static.supports[key]) for key in ("x", "y", "z")])
        ax.plot(distance_astern(static.scene, places), places[:, 2], color=draw.STEEL, linewidth=3.0, zorder=2,
                solid_capstyle="butt")


def _rollers(static: Any, ax: Any) -> None:
    """A dot for each row of rollers, and the names of the boxes."""
    rows = static.rows
    places = np.column_stack([np.asarray(rows[key]) for key in ("x", "y", "z")])
    astern, carries = distance_astern(static.scene, places), np.asarray(rows["reaction"]) > 0
    for these, fill, label in ((carries, draw.CONTACT, "row in contact"), (~carries, "white", "without contact")):
        ax.plot(astern[these], places[these, 2], "o", markersize=5, markerfacecolor=fill, markeredgecolor="#3d4a56",
                markeredgewidth=0.8, label=label, zorder=4)
    box = np.asarray(rows["support"], dtype=int)
    for k, name in enumerate(np.asarray(static.supports["name"]).astype(str)):
        middle = np.flatnonzero(box == k)
        ax.annotate(name, (astern[middle].mean(), places[middle, 2].min()), xytext=(-2, -6), textcoords="offset points",
                    rotation=40, rotation_mode="anchor", ha="right", va="center", color=draw.SOFT, fontsize="small",
                    path_effects=draw.halo())
