"""Reads the two curves of 10_grousers.sh: grousers.csv, grousers.png, and their claims."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from wheels_table import bare, read, write

WHEELS = {"smooth_wheel": ("smooth", "#6b6b6b"), "grouser_wheel": ("30 grousers of 1 cm", "#b4552d")}
QUANTITIES = {"drawbar_pull": "N", "torque": "N m", "sinkage": "m"}
# Ding et al. (2011), Figure 9: slip 1 - v/(r w) [-], drawbar pull [N].
MEASURED = {"smooth_wheel": ((0.1, 0.2, 0.4, 0.6), (11, 14.5, 15, 15)),
            "grouser_wheel": ((0.1, 0.2, 0.4, 0.6), (14, 20, 23, 24.5))}


def table(curves):
    """Header and rows of grousers.csv."""
    header = ["slip (r w - v)/v [-]"] + [f"{name.replace('_', ' ')}, {label} [{unit}]" for label, _ in WHEELS.values()
                                         for name, unit in QUANTITIES.items()]
    rows = [[float(slip)] + [float(curve[name][k]) for curve in curves.values() for name in QUANTITIES]
            for k, slip in enumerate(curves["smooth_wheel"]["slip"])]
    return header, rows


def draw(folder, curves):
    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    for wheel, (label, colour) in WHEELS.items():
        slip = curves[wheel]["slip"]
        axes.plot(slip / (1 + slip), curves[wheel]["drawbar_pull"], "o-", color=colour, label=label)
        axes.plot(*MEASURED[wheel], "D", color=colour, fillstyle="none", label=f"{label}, measured")
    axes.set(title="Rigid rover wheel on planetary simulant, 80 N", xlabel="slip 1 - v/(r w) [-]",
             ylabel="drawbar pull [N]")
    axes.set_ylim(bottom=0)
    bare([axes])
    axes.legend(frameon=False, loc="lower right")
    figure.savefig(folder / "grousers.png", dpi=120)


def check(curves):
    """The claims of the example."""
    smooth, grousers = curves["smooth_wheel"], curves["grouser_wheel"]
    assert (grousers["drawbar_pull"] > 1.2 * smooth["drawbar_pull"]).all(), "grousers do not pull"
    gain = grousers["drawbar_pull"] - smooth["drawbar_pull"]
    assert gain[-1] > gain[0], "grousers do not gain with slip"
    assert (grousers["sinkage"] > smooth["sinkage"]).all(), "grousers do not dig in"


def main():
    folder = pathlib.Path(sys.argv[1])
    curves = {wheel: read(folder / wheel / "drawbar.csv") for wheel in WHEELS}
    write(folder / "grousers.csv", *table(curves))
    draw(folder, curves)
    check(curves)


main()
