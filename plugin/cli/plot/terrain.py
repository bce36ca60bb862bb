"""Draws the ground after a run: how far it has sunk, and where the wheels went.

Usage: python3 terrain.py FOLDER

Reads terrain.npy, wheels.csv and summary.json of `softsoil run --out FOLDER` and writes terrain.png.
"""
import csv
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.patheffects import Normal, Stroke
from matplotlib.ticker import MaxNLocator, MultipleLocator
from matplotlib.transforms import ScaledTranslation
from mpl_toolkits.axes_grid1 import make_axes_locatable

import picture_file

# From undisturbed soil to the bottom of the deepest rut; lightness falls steadily.
SOIL_COLOURS = LinearSegmentedColormap.from_list(
    "soil", ["#f3ebdc", "#e6c793", "#cf924f", "#a9592f", "#7b3022"])
TRACK_COLOURS = ["#ffffff", "#6fd0ff", "#ffe04d", "#ff9ad5"]  # light: a track lies in a dark rut
SUN = np.array([-0.5, 0.5, 1.0]) / np.sqrt(1.5)  # towards it: from the upper left
STEPS = [1, 2, 5, 10]  # between the numbers on a scale
MARGIN = 1.0  # [m] of undisturbed ground around ruts and tracks
MAX_NAMED_WHEELS = 8
MOVED = 0.0005  # [m] least change of height that counts as a rut
TRACK_WIDTH = 0.04  # [m]  narrower than a rut
THICKEST, THINNEST = 1.0, 0.4  # [pt]
LONG_SIDE = 10.0  # [in] of the map
SHORT_SIDE = 3.0  # [in] at least


def read_tracks(path):
    """Centre of each wheel over time: name -> array of x, y [m]."""
    tracks = {}
    with open(path, newline="", encoding="utf-8", errors="replace") as file:
        for row in csv.DictReader(file):
            tracks.setdefault(row["wheel"], []).append((float(row["x [m]"]), float(row["y [m]"])))
    return {name: np.array(points) for name, points in tracks.items()}


def extent_of(nodes, tracks):
    """x_min, x_max, y_min, y_max [m] that show every rut and every track."""
    rut = nodes[np.abs(nodes[:, 3]) > MOVED, :2]
    points = np.concatenate([rut, *tracks.values()])
    if len(points) == 0:
        points = np.zeros((1, 2))
    (x_min, y_min), (x_max, y_max) = points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN
    return x_min, x_max, y_min, y_max


def sinkage_map(nodes, spacing, extent):
    """Sinkage [m] on the grid nodes of the extent, rows along y; ground never touched has none.

    Also returns the exact extent of the cells around the nodes [m].
    """
    i_min, i_max, j_min, j_max = (int(round(value / spacing)) for value in extent)
    sinkage = np.zeros((j_max - j_min + 1, i_max - i_min + 1))
    i = np.rint(nodes[:, 0] / spacing).astype(int) - i_min
    j = np.rint(nodes[:, 1] / spacing).astype(int) - j_min
    inside = (i >= 0) & (i < sinkage.shape[1]) & (j >= 0) & (j < sinkage.shape[0])
    sinkage[j[inside], i[inside]] = nodes[inside, 3]
    cells = np.array([i_min - 0.5, i_max + 0.5, j_min - 0.5, j_max + 0.5]) * spacing
    return sinkage, cells


def sunlight(sinkage, spacing):
    """Brightness of the ground, 1 where it is level."""
    slope_y, slope_x = np.gradient(-sinkage, spacing)
    normal = np.dstack([-slope_x, -slope_y, np.ones_like(slope_x)])
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    return np.clip(normal @ SUN / SUN[2], 0, None)


def draw_ground(axes, sinkage, cells, spacing):
    deepest = max(sinkage.max(), 0.01)  # [m]
    norm = Normalize(0, 100 * deepest)
    colours = SOIL_COLOURS(norm(100 * sinkage))[:, :, :3]
    # Only in ruts and on berms: a bright rim beside a rut would look like soil thrown up.
    light = np.clip(sunlight(sinkage, spacing), 0.7, 1.1)
    light = np.where(np.abs(sinkage) > MOVED, light, 1)[:, :, None]
    axes.imshow(np.clip(colours * light, 0, 1), origin="lower", extent=cells,
                interpolation="bilinear")
    return matplotlib.cm.ScalarMappable(norm, SOIL_COLOURS)


def draw_tracks(axes, tracks, cells):
    points = 72 * LONG_SIDE / longest_side(cells)  # per metre
    width = min(max(points * TRACK_WIDTH, THINNEST), THICKEST)
    outline = [Stroke(linewidth=2.2 * width, foreground="#00000099"), Normal()]
    for number, (name, track) in enumerate(tracks.items()):
        colour = TRACK_COLOURS[number % len(TRACK_COLOURS)]
        axes.plot(track[:, 0], track[:, 1], color=colour, linewidth=width, label=name,
                  path_effects=outline)
        axes.plot(*track[-1], marker="o", markersize=5, color=colour, markeredgecolor="black",
                  markeredgewidth=0.8)
    if 0 < len(tracks) <= MAX_NAMED_WHEELS:
        below = ScaledTranslation(0, -0.5, axes.figure.dpi_scale_trans)  # [in] the numbers of x
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0), ncol=min(len(tracks), 4),
                    bbox_transform=axes.transAxes + below, frameon=False, columnspacing=1.4,
                    handlelength=1.6)


def longest_side(cells):
    return max(cells[1] - cells[0], cells[3] - cells[2])


def figure_for(cells):
    """A figure for a map with equal axes."""
    inches = LONG_SIDE / longest_side(cells)  # per metre
    width, height = (cells[1] - cells[0]) * inches, (cells[3] - cells[2]) * inches
    return plt.subplots(figsize=(max(width, SHORT_SIDE) + 2, max(height, SHORT_SIDE) + 1))


def label(axes, colours, cells, title):
    beside = make_axes_locatable(axes).append_axes("right", size=0.18, pad=0.12)
    bar = axes.figure.colorbar(colours, cax=beside, ticks=MaxNLocator(6, steps=STEPS))
    bar.set_label("sinkage below the undisturbed ground [cm]")
    ticks = MaxNLocator(8, steps=STEPS).tick_values(0, longest_side(cells))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MultipleLocator(ticks[1] - ticks[0]))
    axes.grid(color="black", alpha=0.08, linewidth=0.6)
    axes.set(xlabel="x [m]", ylabel="y [m]", xlim=cells[:2], ylim=cells[2:])
    axes.set_title(title, fontsize=13, loc="left")


def draw(folder):
    summary = json.loads((folder / "summary.json").read_text())
    nodes = np.load(folder / "terrain.npy")
    tracks = read_tracks(folder / "wheels.csv")
    spacing = summary["grid_spacing"]
    sinkage, cells = sinkage_map(nodes, spacing, extent_of(nodes, tracks))

    figure, axes = figure_for(cells)
    colours = draw_ground(axes, sinkage, cells, spacing)
    draw_tracks(axes, tracks, cells)
    scene = pathlib.Path(summary["scene"]).stem
    label(axes, colours, cells,
          f"{scene} on {summary['soil']} after {summary['simulated_time']:.4g} s")
    return figure


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    picture_file.save(draw(folder), folder / "terrain.png", dpi=160, bbox_inches="tight")


if __name__ == "__main__":
    main()
