"""Reads the drive back and forth of 07_five_passes.sh: passes.csv, passes.png, and its claims."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from wheels_table import bare, read, write

GREEN, RUST, GREY = "#3f7d3a", "#b4552d", "#6b6b6b"
FIRST, PERIOD, PASSES = 1, 4, 6  # [s] start of the first pass, [s] each, [-]
STEADY = (2, 3.8)  # [s] of a pass: what is averaged
RADIUS = 0.91  # [m]
COLUMNS = {"wheel_sinkage": "m", "rut_depth": "m", "motion_resistance": "N"}
# Madsen (2014), 7.1: sinkage of the wheel [m], of its axle, that is, as his angles of contact show.
THESIS = np.array([0.132, 0.153, 0.164, 0.169, 0.172, 0.174])


def mean_of_passes(wheel):
    """Quantity -> its mean in each pass; forces along the way that the wheel goes."""
    wheel = dict(wheel)
    wheel["motion_resistance"] = wheel["motion_resistance"] * np.sign(wheel["forward_speed"])
    wheel["wheel_sinkage"] = RADIUS - wheel["z"]
    within = (wheel["time"] - FIRST) % PERIOD
    number = (wheel["time"] - FIRST) // PERIOD
    steady = (within >= STEADY[0]) & (within <= STEADY[1])
    return {name: np.array([wheel[name][steady & (number == k)].mean() for k in range(PASSES)])
            for name in COLUMNS}


def draw(folder, means):
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    passes = np.arange(1, PASSES + 1)
    left.plot(passes, 100 * means["wheel_sinkage"], "o-", color=RUST, label="wheel")
    left.plot(passes, 100 * THESIS, "D", color=GREY, fillstyle="none", label="wheel, thesis")
    left.bar(passes, 100 * means["rut_depth"], color=RUST, alpha=0.4, width=0.6, label="rut")
    left.set(title="Sinkage", xlabel="pass", ylabel="depth [cm]")
    left.legend(frameon=False, ncols=3, loc="upper center", bbox_to_anchor=(0.5, -0.18))
    right.bar(passes, means["motion_resistance"], color=GREEN, width=0.6)
    right.set(title="Motion resistance", xlabel="pass", ylabel="force [N]")
    bare((left, right))
    figure.savefig(folder / "passes.png", dpi=120)


def check(means):
    """The claims of the example."""
    sinkage = means["wheel_sinkage"]
    assert abs(sinkage[0] / THESIS[0] - 1) < 0.2, f"the first pass is not that of the thesis: {sinkage[0]} m"
    deeper = np.diff(sinkage)
    assert (deeper > 0).all(), f"a pass did not sink deeper: {deeper} m"
    assert (np.diff(deeper) < 0).all(), f"a pass added more than the one before: {deeper} m"
    assert 0.02 < deeper.sum() < 0.06, f"the later passes add too little or too much: {deeper.sum()} m"
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
