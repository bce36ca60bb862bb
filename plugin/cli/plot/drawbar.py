"""Draws what a tire does in the soil bin.

Usage: python3 drawbar.py FOLDER

Reads the results of `softsoil drawbar --out FOLDER`. Of steady motion it draws drawbar.png, the
curves of drawbar.csv, of a drive by torque history.png, and of both centre_line.png. Where there is
a wong_reece.csv, the rigid wheel of Wong and Reece is drawn beside, dashed.
"""
import csv
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D

import picture_file

GREEN, RUST, BLUE, GREY = "#3f7d3a", "#b4552d", "#2f6690", "#6b6b6b"
LOW_TO_HIGH = ["#e0a458", "#b4552d", "#4a2c2a"]
RIGID_NAME = "rigid wheel, Wong and Reece"
RIGID = {"linestyle": (0, (5, 2.5)), "linewidth": 1.3}
TEXTS = ["wheel", "mode"]  # columns that hold no numbers
STYLE = {"axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
         "grid.color": "black", "grid.alpha": 0.08, "axes.axisbelow": True, "axes.titlesize": 11,
         "axes.titleweight": "bold", "axes.titlelocation": "left", "legend.edgecolor": "none",
         "legend.framealpha": 0.85, "lines.linewidth": 1.9, "lines.markersize": 4.5,
         "font.size": 10}


def number(text):
    """NaN where the cell is empty: what is not defined has no value."""
    return float(text) if text else np.nan


def read_table(path):
    """Column without its unit -> array; None if there is no such file."""
    if not path.exists():
        return None
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    names = [name.split(" [")[0] for name in (rows[0] if rows else {})]
    values = [[row[key] for row in rows] for key in (rows[0] if rows else {})]
    return {name: np.array(column if name in TEXTS else [number(text) for text in column])
            for name, column in zip(names, values)}


def read_rigid_wheel(folder, summary):
    """None if it was not asked for, or rolls at no slip."""
    rigid = read_table(folder / "wong_reece.csv")
    if not rigid:
        return None
    rigid["power"] = rigid["torque"] * (1 + rigid["slip"]) * summary["speed"] / summary["radius"]
    return {key: values[np.argsort(rigid["slip"])] for key, values in rigid.items()}


def title_of(summary):
    return f"{summary['tire']} on {summary['soil']}, {summary['load'] / 1000:g} kN"


def save(figure, folder, name):
    picture_file.save(figure, folder / name, dpi=150)
    plt.close(figure)


class Curves:
    """Panels over slip, or over spin where spin is prescribed."""

    def __init__(self, ours, rigid, over_spin):
        self.ours, self.rigid, self.over_spin = ours, rigid, over_spin
        self.x = ours["spin"] if over_spin else 100 * ours["slip"]
        self.order = np.argsort(self.x)

    def draw(self, axes, key, colour, label=None, scale=1.0, compare=True):
        x, y = self.x[self.order], scale * self.ours[key][self.order]
        axes.plot(x, y, color=colour, marker="o", label=label)
        unsteady = self.ours["steady"][self.order] == 0
        axes.plot(x[unsteady], y[unsteady], "o", color="white", markeredgecolor=colour)
        if compare and self.rigid is not None:
            axes.plot(100 * self.rigid["slip"], scale * self.rigid[key], color=colour, **RIGID)

    def mark_rolling(self, axes, slip):
        """Where the wheel would roll freely."""
        if not self.over_spin:
            axes.axvline(100 * slip, color=GREY, linewidth=0.9, linestyle=":")

    def label(self, axes, title, unit):
        axes.set_title(title)
        axes.set_ylabel(unit)
        slip = "slip (rω − v)/v, unloaded radius [%]"
        axes.set_xlabel("spin [rad/s]" if self.over_spin else slip)
        axes.margins(x=0.02)


def legend_above(axes, handles=None):
    """In the row of the title, where it covers no line."""
    handles = handles or axes.get_legend_handles_labels()[0]
    axes.legend(handles=handles, loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=len(handles),
                borderaxespad=0.1, columnspacing=1.1, handlelength=1.7, handletextpad=0.5,
                fontsize=9)


def from_zero(axes):
    """Zero at the edge or inside, and room for the markers."""
    low, high = axes.dataLim.intervaly
    if low > high or low == high == 0:  # nothing is drawn, or nothing but zeros
        return
    room = 0.05 * (max(high, 0) - min(low, 0))
    axes.set_ylim(min(0, low) - room * (low < 0), max(0, high) + room * (high > 0))


def draw_forces(curves, axes):
    for key, name, colour in [("thrust", "thrust", GREEN), ("drawbar_pull", "drawbar pull", RUST),
                              ("motion_resistance", "motion resistance", GREY)]:
        curves.draw(axes, key, colour, name, 1e-3)
    curves.label(axes, "Forces", "[kN]")
    from_zero(axes)
    legend_above(axes)


def draw_torque(curves, axes):
    curves.draw(axes, "torque", BLUE, scale=1e-3)
    curves.label(axes, "Torque", "[kN m]")
    from_zero(axes)


def draw_power(curves, axes):
    curves.draw(axes, "power", BLUE, scale=1e-3)
    curves.label(axes, "Power", "[kW]")
    from_zero(axes)


def draw_sinkage(curves, axes):
    curves.draw(axes, "sinkage", RUST, "wheel", 100)
    curves.draw(axes, "rut_depth", GREY, "rut", 100, compare=False)
    curves.label(axes, "Sinkage", "[cm]")
    axes.set_ylim(0, 1.15 * axes.get_ylim()[1])
    axes.invert_yaxis()
    legend_above(axes)


def name_lines(axes, ours, rigid):
    """Says in one panel what full and dashed lines are in all."""
    handles = [Line2D([], [], color="#222222", marker="o", label="softsoil")]
    if np.any(ours["steady"] == 0):
        handles.append(Line2D([], [], color="#222222", marker="o", markerfacecolor="white",
                              label="not steady"))
    if rigid is not None:
        handles.append(Line2D([], [], color="#222222", label=RIGID_NAME, **RIGID))
    if len(handles) > 1:
        legend_above(axes, handles)


def subtitle_of(summary):
    free = summary["free_rolling"]
    where = f"at {summary['speed']:g} m/s" if summary["mode"] == "spin" else "(dotted)"
    slip, resistance = 100 * free["slip"], free["motion_resistance"] / 1000
    if "rolling_radius" not in free:
        return f"does not roll freely: without torque {slip:.1f} % slip {where}"
    return (f"rolling freely {where}: {slip:.1f} % slip, rolling radius "
            f"{free['rolling_radius']:.3f} m, resistance {resistance:.3g} kN")


def draw_curves(folder, summary):
    ours = read_table(folder / "drawbar.csv")
    over_spin = summary["mode"] == "spin"
    rigid = read_rigid_wheel(folder, summary)
    figure, panels = plt.subplots(2, 2, figsize=(10, 7.4), layout="constrained")
    curves = Curves(ours, rigid, over_spin)
    for draw, axes in zip([draw_forces, draw_torque, draw_sinkage, draw_power], panels.flat):
        draw(curves, axes)
        curves.mark_rolling(axes, summary["free_rolling"]["slip"])
    speed = "" if over_spin else f" at {summary['speed']:g} m/s"
    figure.suptitle(f"{title_of(summary)}{speed}\n", fontsize=13, x=0.012, ha="left")
    figure.text(0.012, 0.945, subtitle_of(summary), color=GREY, fontsize=10)
    name_lines(panels[0, 1], ours, rigid)
    save(figure, folder, "drawbar.png")


def chosen(values):
    """Lowest, middle and highest of some values."""
    values = np.unique(values)
    return values[np.unique([0, len(values) // 2, len(values) - 1])]


def named(key, value, summary):
    if key == "time":
        return f"{value:g} s"
    if summary["mode"] == "spin":
        return f"{value:g} rad/s"
    return f"{100 * value:.3g} % slip"


def draw_centre_line(folder, summary):
    lines = read_table(folder / "centre_line.csv")
    rigid = read_table(folder / "rim_stress.csv") or None
    figure, (above, below) = plt.subplots(2, 1, figsize=(8.5, 7), sharex=True,
                                          layout="constrained")
    key = next(iter(lines), "slip")
    values = chosen(lines[key]) if lines else []
    for value, colour in zip(values, LOW_TO_HIGH[-len(values):]):
        for table, style in ((lines, {}), (rigid, RIGID)):
            if table is None:
                continue
            here = np.isclose(table[key], value, rtol=1e-4)
            label = named(key, value, summary) if table is lines else None
            above.plot(table["angle"][here], table["pressure"][here] / 1000, color=colour,
                       label=label, **style)
            below.plot(table["angle"][here], table["shear"][here] / 1000, color=colour, **style)
    above.set_title("Pressure")
    below.set_title("Shear stress, driving forward")
    for axes in (above, below):
        axes.set_ylabel("[kPa]")
        axes.axvline(0, color="#00000040", linewidth=0.8)
        from_zero(axes)
    below.set_xlabel("angle on the circumference from the lowest point, positive ahead [deg]")
    handles = above.get_legend_handles_labels()[0]
    if rigid is not None:
        handles.append(Line2D([], [], color="#222222", label=RIGID_NAME, **RIGID))
    if handles:
        legend_above(above, handles)
    if not lines:
        above.text(0.5, 0.5, "A mesh has no rings of nodes: contact.png of softsoil run shows its contact.",
                   transform=above.transAxes, ha="center", va="center")
    figure.suptitle(f"{title_of(summary)}: stress along the centre line", fontsize=13, x=0.012,
                    ha="left")
    save(figure, folder, "centre_line.png")


def draw_history(folder, summary):
    run = read_table(folder / "history.csv")
    figure, (speeds, slip, forces) = plt.subplots(3, 1, figsize=(9, 8.5), sharex=True,
                                                  layout="constrained")
    time = run["time"]
    speeds.plot(time, summary["radius"] * run["spin"], color=BLUE, label="rim, rω")
    speeds.plot(time, run["forward_speed"], color=RUST, label="wheel, v")
    speeds.set(title="Speeds", ylabel="[m/s]")
    moving = run["forward_speed"] > 0.05  # slip has no meaning on the spot
    slip.plot(time[moving], 100 * run["slip_ratio"][moving], color=BLUE)
    slip.set(title="Slip", ylabel="[%]")
    for key, colour in [("thrust", GREEN), ("drawbar_pull", RUST), ("motion_resistance", GREY)]:
        forces.plot(time, run[key] / 1000, color=colour, label=key.replace("_", " "),
                    linewidth=1.4)
    forces.set(title="Forces", ylabel="[kN]", xlabel="time since the torque set in [s]")
    for axes in (speeds, forces):
        legend_above(axes)
    speeds.margins(x=0.01)
    ground = f", bumps {summary['bumps']}" if summary["bumps"] else ""
    figure.suptitle(f"{title_of(summary)}, {summary['torque']:g} N m{ground}", fontsize=13, x=0.012,
                    ha="left")
    save(figure, folder, "history.png")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    summary = json.loads((folder / "summary.json").read_text())
    with plt.rc_context(STYLE):
        draw = draw_history if summary["mode"] == "torque" else draw_curves
        draw(folder, summary)
        draw_centre_line(folder, summary)


if __name__ == "__main__":
    main()
