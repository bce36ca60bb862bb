"""Draws what softsoil wong-reece has found: forces, torque and sinkage over slip, rim stress.

Usage: python3 wong_reece.py FOLDER

Reads wong_reece.csv, rim_stress.csv and wong_reece.json of `softsoil wong-reece --out FOLDER` and
writes wong_reece.png.
"""
import csv
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import picture_file

FORCES = {"thrust [N]": ("thrust", "#1f6f8b"),
          "motion_resistance [N]": ("motion resistance", "#c2401f"),
          "drawbar_pull [N]": ("drawbar pull", "#2d2a26")}
ALONE = "#7a4f9a"  # of a curve without others beside it
SLIP_COLOURS = matplotlib.colormaps["viridis"]
TOWED_COLOUR = "#c2401f"
MOST_RIMS = 5  # drawn of the driven ones
KILO, CM = 1e3, 1e-2


def read_rows(path):
    """Rows of a table; numbers in all columns but the mode."""
    with open(path, newline="") as file:
        return [{key: text if key == "mode" else float(text) for key, text in row.items()}
                for row in csv.DictReader(file)]


def driven_by_slip(rows):
    return sorted((row for row in rows if row["mode"] == "driven"), key=lambda r: r["slip [-]"])


def column(rows, name, unit):
    return np.array([row[name] for row in rows]) / unit


def draw_curve(axes, rows, name, unit, **style):
    """Driven wheels as a curve; the towed one, at its skid, as an open circle."""
    driven, towed = driven_by_slip(rows), [row for row in rows if row["mode"] == "towed"]
    axes.plot(100 * column(driven, "slip [-]", 1), column(driven, name, unit), marker="o",
              markersize=3, linewidth=1.8, **style)
    axes.plot(100 * column(towed, "slip [-]", 1), column(towed, name, unit), marker="o",
              markersize=7, markerfacecolor="none", linestyle="none", color=style["color"])


def finish(axes, xlabel, ylabel):
    axes.set(xlabel=xlabel, ylabel=ylabel)
    axes.margins(y=0.08)
    axes.grid(color="black", alpha=0.1, linewidth=0.6)


def draw_forces(axes, rows):
    for name, (words, colour) in FORCES.items():
        draw_curve(axes, rows, name, KILO, color=colour, label=words)
    if any(row["mode"] == "towed" for row in rows):
        axes.plot([], [], marker="o", markersize=7, markerfacecolor="none", linestyle="none",
                  color="black", label="towed")
    axes.axhline(0, color="black", linewidth=0.7)
    axes.legend(frameon=False, fontsize=9)
    finish(axes, "slip ratio [%]", "force [kN]")


def draw_alone(axes, rows, name, unit, words):
    draw_curve(axes, rows, name, unit, color=ALONE)
    finish(axes, "slip ratio [%]", words)
    axes.set_ylim(bottom=min(0, axes.get_ylim()[0]))


def rims_of(stresses):
    """Slip and mode -> rows along the rim, in the order of the slip."""
    rims = {}
    for row in stresses:
        rims.setdefault((row["slip [-]"], row["mode"]), []).append(row)
    return dict(sorted(rims.items()))


def chosen(rims):
    """The towed wheel and a few of the driven ones, the first and the last among them."""
    driven = [key for key in rims if key[1] == "driven"]
    if len(driven) > MOST_RIMS:
        places = np.linspace(0, len(driven) - 1, MOST_RIMS).round().astype(int)
        driven = [driven[place] for place in places]
    return [key for key in rims if key[1] == "towed"] + driven


def colour_of(key, keys):
    if key[1] == "towed":
        return TOWED_COLOUR
    driven = [k for k in keys if k[1] == "driven"]
    return SLIP_COLOURS(0.85 * driven.index(key) / max(len(driven) - 1, 1))


def draw_rims(pressure, shear, stresses):
    rims = rims_of(stresses)
    keys = chosen(rims)
    for key in keys:
        slip, mode = key
        words = f"{mode}, slip ratio {100 * slip:.3g} %"
        angle = column(rims[key], "angle [deg]", 1)
        for axes, name in ((pressure, "pressure [Pa]"), (shear, "shear [Pa]")):
            axes.plot(angle, column(rims[key], name, KILO), color=colour_of(key, keys),
                      linewidth=1.8, label=words)
    for axes, name in ((pressure, "pressure [kPa]"), (shear, "shear on the rim [kPa]")):
        axes.axhline(0, color="black", linewidth=0.7)
        finish(axes, "angle ahead of the lowest point [°]", name)
    pressure.set_ylim(bottom=0)
    pressure.legend(frameon=False, fontsize=9)


def panels(over_slip):
    """A figure; its panels of forces, torque and sinkage over slip, if any; of pressure, shear."""
    figure = plt.figure(figsize=(12, 8 if over_slip else 4.4), layout="constrained")
    if not over_slip:
        return figure, [], figure.subplots(1, 2)
    above, below = figure.subfigures(2, 1)
    return figure, above.subplots(1, 3), below.subplots(1, 2)


def draw(folder):
    inputs = json.loads((folder / "wong_reece.json").read_text())
    rows = read_rows(folder / "wong_reece.csv")
    over_slip = len(rows) > 1
    figure, above, below = panels(over_slip)
    draw_rims(*below, read_rows(folder / "rim_stress.csv"))
    if over_slip:
        draw_forces(above[0], rows)
        draw_alone(above[1], rows, "torque [N m]", KILO, "torque [kN m]")
        draw_alone(above[2], rows, "sinkage [m]", CM, "sinkage [cm]")
    figure.suptitle(f"{inputs['tire']} on {inputs['soil']}, {inputs['load'] / KILO:g} kN: rigid "
                    f"wheel by Wong and Reece, radius {inputs['radius']:.4g} m, width "
                    f"{inputs['width']:.4g} m", fontsize=12)
    figure.get_layout_engine().set(h_pad=0.1, w_pad=0.1)
    return figure


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    picture_file.save(draw(folder), folder / "wong_reece.png", dpi=140)


if __name__ == "__main__":
    main()
