"""Reads the two curves of 08_lugs.sh: lugs.csv, lugs.png, and its claims."""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

GREEN, GREY = "#3f7d3a", "#6b6b6b"
SMOOTH, LUGGED = "18.4R38_85kPa", "18.4R38_85kPa_lugged"
LABELS = {SMOOTH: "smooth", LUGGED: "with lugs of 38 mm"}
COLOURS = {SMOOTH: GREY, LUGGED: GREEN}
# Wulfsohn and Upadhyaya (1992) as quoted in Madsen (2014), 6.3.2: slip [-], drawbar pull [N], 17.6 kN.
MEASURED = (0.27, 9710)


def read(path):
    """Column without its unit -> array."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {key.split(" [")[0]: np.array([float(row[key] or "nan") for row in rows])
            for key in rows[0]}


def write(folder, curves):
    with open(folder / "lugs.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["slip [-]"] + [f"{name}, {LABELS[tire]} [{unit}]" for tire in curves
                                       for name, unit in (("drawbar pull", "N"), ("sinkage", "m"))])
        for k, slip in enumerate(curves[SMOOTH]["slip"]):
            cells = [curve[name][k] for curve in curves.values()
                     for name in ("drawbar_pull", "sinkage")]
            table.writerow([f"{slip:g}"] + [f"{cell:.5g}" for cell in cells])


def draw(folder, curves):
    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    for tire, curve in curves.items():
        axes.plot(curve["slip"], curve["drawbar_pull"] / 1000, "o-", color=COLOURS[tire],
                  label=LABELS[tire])
    axes.plot(MEASURED[0], MEASURED[1] / 1000, "kD", label="measured")
    axes.set(title="Tractor tire on tilled loam, 17.6 kN", xlabel="slip [-]",
             ylabel="drawbar pull [kN]")
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, loc="lower right")
    figure.savefig(folder / "lugs.png", dpi=120)


def check(curves):
    """The claims of the example."""
    smooth, lugged = curves[SMOOTH], curves[LUGGED]
    slips = smooth["slip"] > 0.2
    assert (lugged["drawbar_pull"] > 1.05 * smooth["drawbar_pull"])[slips].all(), "lugs do not pull"
    assert (lugged["sinkage"] > smooth["sinkage"]).all(), "lugs do not dig in"
    error = {tire: abs(np.interp(MEASURED[0], curve["slip"], curve["drawbar_pull"]) - MEASURED[1])
             for tire, curve in curves.items()}
    assert error[LUGGED] < error[SMOOTH], f"lugs are farther from the measured pull: {error} N"


def main():
    folder = pathlib.Path(sys.argv[1])
    curves = {tire: read(folder / tire / "drawbar.csv") for tire in (SMOOTH, LUGGED)}
    write(folder, curves)
    draw(folder, curves)
    print((folder / "lugs.csv").read_text(), end="")
    check(curves)


main()
