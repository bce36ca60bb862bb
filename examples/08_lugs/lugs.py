"""Reads the two curves of 08_lugs.sh: lugs.csv, lugs.png, and its claims."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from wheels_table import bare, read, write

GREEN, GREY = "#3f7d3a", "#6b6b6b"
SMOOTH, LUGGED = "18.4R38_85kPa", "18.4R38_85kPa_lugged"
LABELS = {SMOOTH: "smooth", LUGGED: "with lugs of 38 mm"}
COLOURS = {SMOOTH: GREY, LUGGED: GREEN}
# Wulfsohn and Upadhyaya (1992) as quoted in Madsen (2014), 6.3.2: slip [-], drawbar pull [N], 17.6 kN.
MEASURED = (0.27, 9710)


def table(curves):
    """Header and rows of lugs.csv."""
    header = ["slip [-]"] + [f"{name}, {LABELS[tire]} [{unit}]" for tire in curves
                             for name, unit in (("drawbar pull", "N"), ("sinkage", "m"))]
    rows = [[float(slip)] + [curve[name][k] for curve in curves.values()
                             for name in ("drawbar_pull", "sinkage")]
            for k, slip in enumerate(curves[SMOOTH]["slip"])]
    return header, rows


def draw(folder, curves):
    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    for tire, curve in curves.items():
        axes.plot(curve["slip"], curve["drawbar_pull"] / 1000, "o-", color=COLOURS[tire],
                  label=LABELS[tire])
    axes.plot(MEASURED[0], MEASURED[1] / 1000, "kD", label="measured")
    axes.set(title="Tractor tire on tilled loam, 17.6 kN", xlabel="slip [-]",
             ylabel="drawbar pull [kN]")
    bare([axes])
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
    draw(folder, curves)
    write(folder / "lugs.csv", *table(curves))
    check(curves)


main()
