"""Reads the drive back and forth of 07_five_passes.sh: passes.csv, passes.png, and its claims."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from wheels_table import bare, read, write

GREEN, RUST = "#3f7d3a", "#b4552d"
FIRST, PERIOD, PASSES = 1, 4, 5  # [s] start of the first pass, [s] each, [-]
STEADY = (1, 2.5)  # [s] of a pass: what is averaged
COLUMNS = {"rut_depth": "m", "motion_resistance": "N", "drawbar_pull": "N"}


def mean_of_passes(wheel):
    """Quantity -> its mean in each pass; forces along the way that the wheel goes."""
    wheel = dict(wheel)
    for name in ("motion_resistance", "drawbar_pull"):
        wheel[name] = wheel[name] * np.sign(wheel["forward_speed"])
    within = (wheel["time"] - FIRST) % PERIOD
    number = (wheel["time"] - FIRST) // PERIOD
    steady = (within >= STEADY[0]) & (within <= STEADY[1])
    return {name: np.array([wheel[name][steady & (number == k)].mean() for k in range(PASSES)])
            for name in COLUMNS}


def draw(folder, means):
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    passes = np.arange(1, PASSES + 1)
    left.bar(passes, 100 * means["rut_depth"], color=RUST, width=0.6)
    left.set(title="Rut", xlabel="pass", ylabel="depth [cm]")
    right.bar(passes, means["motion_resistance"], color=GREEN, width=0.6)
    right.set(title="Motion resistance", xlabel="pass", ylabel="force [N]")
    bare((left, right))
    figure.savefig(folder / "passes.png", dpi=120)


def check(means):
    """The claims of the example."""
    deeper = np.diff(means["rut_depth"])
    assert (deeper > 0).all(), f"a pass did not deepen the rut: {deeper} m"
    assert (np.diff(deeper) < 0).all(), f"a pass added more than the one before: {deeper} m"
    resistance = means["motion_resistance"]
    assert resistance[1:].max() < 0.6 * resistance[0], f"a later pass is no easier: {resistance} N"


def main():
    folder = pathlib.Path(sys.argv[1])
    means = mean_of_passes(read(folder / "wheels.csv"))
    draw(folder, means)
    write(folder / "passes.csv", ["pass"] + [f"{name} [{unit}]" for name, unit in COLUMNS.items()],
          [[k + 1] + [means[name][k] for name in COLUMNS] for k in range(PASSES)])
    check(means)


main()
