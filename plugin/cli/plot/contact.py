"""Draws the contact of the tires with the ground: pressure and shear over the patch.

For each wheel: the pressure in three dimensions, the patch from above with the shear stress as
arrows, and both along the centre line of the tire. Stresses are those of the ground on the wheel.

Reads contact.csv and summary.json of `softsoil run --out FOLDER` and writes contact.png there.
"""
import argparse
import csv
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.ticker import MaxNLocator

import picture_file

MOST_WHEELS = 4  # in one picture
PRESSURE_COLOURS = LinearSegmentedColormap.from_list(
    "pressure", ["#fff3d9", "#ffd28a", "#f79a4a", "#dd5a2b", "#a82a1c"])
PRESSURE, SHEAR, ACROSS = "#c2401f", "#1f6f8b", "#8a8f3c"  # of the lines
ARROW = "#0f3a49"
MOST_ARROWS = 14  # along the patch
COLUMNS = {"angle": "angle [deg]", "ahead": "ahead [m]", "lateral": "lateral [m]",
           "pressure": "pressure [Pa]", "shear": "shear [Pa]", "across": "shear_across [Pa]",
           "area": "area [m^2]"}
SAME_ANGLE, SAME_LATERAL = 0.01, 1e-5  # [deg], [m]  nodes of one row or one ring
MOST_RINGS_PER_NODE = 0.4  # more are no rings
CELL_PER_NODE = 1.5  # size of a cell over that of a node of a mesh
CM, KPA = 1e-2, 1e3
LEAST_PRESSURE, LEAST_SHEAR = 1.0, 0.1  # [kPa]  at the top of their scales


class Patch:
    """The nodes of one tire in contact, by ring around the tire and row across it.

    Nodes of a mesh stand in neither: seen from above, they are gathered in square cells."""

    def __init__(self, rows):
        values = {key: np.array([float(row[name]) for row in rows])
                  for key, name in COLUMNS.items()}
        self.size = len(rows)
        if self.size == 0:
            return
        ring, laterals = grouped(values["lateral"], SAME_LATERAL)
        if len(laterals) > MOST_RINGS_PER_NODE * self.size:
            row, ring = self.set_cells(values)
        else:
            row, self.angle = rows_across(values["angle"], ring)
            self.lateral = laterals / CM
            self.ahead = np.array([values["ahead"][row == k].mean()
                                   for k in range(len(self.angle))]) / CM
        area = self.summed(values["area"], row, ring)
        self.touches = area > 0
        for key in ("pressure", "shear", "across"):
            force = self.summed(values["area"] * values[key] / KPA, row, ring)
            setattr(self, key, force / np.where(self.touches, area, 1))

    def set_cells(self, values):
        """Row and ring of each node."""
        cell = CELL_PER_NODE * np.sqrt(values["area"].mean())
        row, ring = (np.floor(values[key] / cell).astype(int) for key in ("ahead", "lateral"))
        self.ahead = cell / CM * (np.arange(row.min(), row.max() + 1) + 0.5)
        self.lateral = cell / CM * (np.arange(ring.min(), ring.max() + 1) + 0.5)
        order = np.argsort(values["ahead"])
        self.angle = np.interp(self.ahead, values["ahead"][order] / CM, values["angle"][order])
        return row - row.min(), ring - ring.min()

    def summed(self, values, row, ring):
        total = np.zeros((len(self.ahead), len(self.lateral)))
        np.add.at(total, (row, ring), values)
        return total

    def centre_line(self, stress):
        """Along the middle ring; halfway between the two middle ones where there is none."""
        distance = np.abs(self.lateral)
        middle = distance < distance.min() + SAME_LATERAL / CM
        return stress[:, middle].mean(axis=1)


def grouped(values, gap):
    """Number of the group that each value belongs to, and the mean of each group."""
    order = np.argsort(values)
    number = np.empty(len(values), dtype=int)
    number[order] = np.concatenate([[0], np.cumsum(np.diff(values[order]) > gap)])
    return number, np.bincount(number, weights=values) / np.bincount(number)


def rows_across(angle, ring):
    """Number of the row across the tire that each node belongs to, and the mean angle of each row.

    Lugs at an angle stagger the nodes from ring to ring: rows are then as far apart as the nodes
    of a ring, and each node is in the nearest that is free."""
    row, angles = grouped(angle, SAME_ANGLE)
    widest = np.bincount(ring).max()
    if len(angles) <= 2 * widest:
        return row, angles
    spacing = np.ptp(angle) / (widest - 1)
    row = np.round((angle - angle.min()) / spacing).astype(int)
    for k in range(ring.max() + 1):
        own = np.flatnonzero(ring == k)
        own = own[np.argsort(angle[own])]
        row[own] = np.maximum.accumulate(row[own] - np.arange(len(own))) + np.arange(len(own))
    return row, angle.min() + spacing * np.arange(row.max() + 1)


def read_rows(path):
    # Names in a model need not be UTF-8; summary.json holds them replaced in the same way.
    with open(path, newline="", encoding="utf-8", errors="replace") as file:
        return list(csv.DictReader(file))


def patches_at(rows, time, names):
    """Wheel -> Patch at the instant nearest to `time`; and that instant."""
    times = sorted({float(row["time [s]"]) for row in rows})
    nearest = min(times, key=lambda t: abs(t - time), default=time)
    now = [row for row in rows if float(row["time [s]"]) == nearest]
    return nearest, {name: Patch([row for row in now if row["wheel"] == name]) for name in names}


def edges_of(centres):
    """Between neighbours; half a distance beyond the first and the last."""
    if len(centres) == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    inner = (centres[1:] + centres[:-1]) / 2
    return np.concatenate([[2 * centres[0] - inner[0]], inner, [2 * centres[-1] - inner[-1]]])


def walled(patch):
    """The pressure with walls down to zero around the patch: grid of ahead, lateral, pressure."""
    def widened(centres):
        edges = edges_of(centres)
        return np.concatenate([edges[:1], centres, edges[-1:]])

    ahead, lateral = np.meshgrid(widened(patch.ahead), widened(patch.lateral), indexing="ij")
    return ahead, lateral, np.pad(patch.pressure, 1)


def draw_relief(axes, patch, norm):
    ahead, lateral, pressure = walled(patch)
    mean = sum(pressure[i:i - 1 or None, j:j - 1 or None] for i in (0, 1) for j in (0, 1)) / 4
    colours = PRESSURE_COLOURS(norm(mean))
    colours[mean == 0] = 0  # ground beside the patch
    surface = axes.plot_surface(ahead, lateral, pressure, facecolors=colours, rstride=1, cstride=1,
                                shade=False)
    lines = np.tile(matplotlib.colors.to_rgba("#5a1c0c", 0.4), (mean.size, 1))
    lines[mean.ravel() == 0, 3] = 0
    surface.set(edgecolor=lines, linewidth=0.4)
    axes.view_init(elev=28, azim=-125)
    length, width = np.ptp(ahead), np.ptp(lateral)
    longest = max(length, width)
    axes.set_box_aspect((length / longest, width / longest, 0.6), zoom=1.05)
    axes.set(zlim=(0, norm.vmax), xlabel="ahead [cm]", ylabel="left [cm]",
             zlabel="pressure [kPa]")
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_major_locator(MaxNLocator(4))
        axis.set_pane_color((0.97, 0.96, 0.94, 1))


def round_number(value):
    """The greatest of 1, 2, 5, 10, 20, ... that is at most `value` > 0."""
    power = 10.0 ** np.floor(np.log10(value))
    return power * max(step for step in (1, 2, 5) if step * power <= value * (1 + 1e-9))


def draw_arrows(axes, patch, longest):
    """The shear stress; the longest arrow [kPa] fills the distance to the next."""
    step = max(1, -(-max(patch.touches.shape) // MOST_ARROWS))
    some = np.zeros_like(patch.touches)
    some[step // 2::step, step // 2::step] = True
    row, ring = np.nonzero(patch.touches & some)
    spacing = step * np.diff(edges_of(patch.ahead)).max()
    arrows = axes.quiver(patch.ahead[row], patch.lateral[ring], patch.shear[row, ring],
                         patch.across[row, ring], color=ARROW, angles="xy", scale_units="xy",
                         scale=longest / spacing, pivot="mid", width=0.006, headwidth=3.5,
                         minlength=0.2)
    shown = round_number(longest)
    axes.quiverkey(arrows, 0.9, 1.05, shown, f"shear on the tire, {shown:g} kPa", labelpos="W",
                   fontproperties={"size": 9})


def draw_from_above(axes, patch, norm, longest_arrow):
    seen = np.ma.masked_array(patch.pressure, ~patch.touches)
    mesh = axes.pcolormesh(edges_of(patch.ahead), edges_of(patch.lateral), seen.T, norm=norm,
                           cmap=PRESSURE_COLOURS)
    draw_arrows(axes, patch, longest_arrow)
    axes.figure.colorbar(mesh, ax=axes, shrink=0.8, pad=0.03).set_label("pressure [kPa]")
    axes.set_title("from above", fontsize=9, loc="left")
    axes.set(xlabel="ahead of the axle [cm]", ylabel="left [cm]", aspect="equal")
    axes.margins(0.05)


def draw_centre_line(axes, patch, lowest, highest):
    for stress, name, colour in ((patch.pressure, "pressure", PRESSURE),
                                 (patch.shear, "shear", SHEAR),
                                 (patch.across, "shear to the left", ACROSS)):
        axes.plot(patch.angle, patch.centre_line(stress), color=colour, label=name, linewidth=1.8,
                  marker="o", markersize=2.5)
    axes.axhline(0, color="black", linewidth=0.7)
    axes.axvline(0, color="black", linewidth=0.7, linestyle=":")
    room = 0.08 * (highest - lowest)
    axes.set(xlabel="angle ahead of the lowest point [deg]",
             ylabel="stress on the centre line [kPa]",
             ylim=(lowest - room, highest + room))
    axes.grid(color="black", alpha=0.1, linewidth=0.6)
    axes.legend(frameon=False, fontsize=8)


def draw_wheel(figure, places, name, patch, scales):
    """The three views of a wheel at three places of the figure."""
    norm, longest_arrow, lowest, highest = scales
    projection = "3d" if patch.size > 0 else None
    left = figure.add_subplot(places[0], projection=projection)
    left.set_title(name, fontsize=12, weight="bold", loc="left")
    if patch.size == 0:
        left.axis("off")
        left.text(0, 0.5, "no contact with the ground", transform=left.transAxes)
        return
    draw_relief(left, patch, norm)
    draw_from_above(figure.add_subplot(places[1]), patch, norm, longest_arrow)
    draw_centre_line(figure.add_subplot(places[2]), patch, lowest, highest)


def scales_for(patches):
    """The same for all wheels: colours, the longest arrow, bounds of the centre lines [kPa]."""
    touching = [patch for patch in patches if patch.size > 0]
    highest = max([patch.pressure.max() for patch in touching], default=0)
    longest = max([np.hypot(patch.shear, patch.across).max() for patch in touching], default=0)
    longest = max(longest, LEAST_SHEAR)
    lines = [patch.centre_line(stress) for patch in touching
             for stress in (patch.pressure, patch.shear, patch.across)]
    lowest = min([line.min() for line in lines], default=0)
    most = max([line.max() for line in lines], default=0)
    return (Normalize(0, max(highest, LEAST_PRESSURE)), longest, min(lowest, 0),
            max(most, LEAST_PRESSURE))


def draw(folder, time, wheels):
    summary = json.loads((folder / "summary.json").read_text())
    rows = read_rows(folder / "contact.csv")
    known = [wheel["name"] for wheel in summary["wheels"]]
    unknown = [name for name in wheels if name not in known]
    if unknown:
        sys.exit(f"contact.py: unknown wheel \"{unknown[0]}\"; known are: {', '.join(known)}")
    names = wheels or known[:MOST_WHEELS]
    time, patches = patches_at(rows, summary["simulated_time"] if time is None else time, names)

    figure = plt.figure(figsize=(15, 3.9 * len(names) + 0.5), layout="constrained")
    grid = figure.add_gridspec(len(names), 3)
    scales = scales_for(patches.values())
    for row, (name, patch) in enumerate(patches.items()):
        draw_wheel(figure, [grid[row, k] for k in range(3)], name, patch, scales)
    scene = pathlib.Path(summary["scene"]).stem
    some = "" if len(known) <= len(names) else f", {len(names)} of {len(known)} wheels"
    figure.suptitle(f"{scene} on {summary['soil']} at {time:.4g} s: contact of the tires{some}",
                    fontsize=13)
    figure.get_layout_engine().set(h_pad=0.12, wspace=0.04, rect=(0.012, 0, 0.988, 1))
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--time", type=float, help="instant in contact.csv [s]; else the last")
    parser.add_argument("--wheel", action="append", default=[], metavar="NAME",
                        help=f"wheel to draw, once for each; else the first {MOST_WHEELS}")
    given = parser.parse_args()
    picture_file.save(draw(given.folder, given.time, given.wheel), given.folder / "contact.png", dpi=130)


if __name__ == "__main__":
    main()
