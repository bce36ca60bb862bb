"""Reads the column of 11_convoy.sh: convoy.csv, convoy.png, and its claims."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from wheels_table import bare, read, write

TRACK = (12, 16.5)  # [m]  what is averaged
COLUMNS = {"rut_depth": "m", "motion_resistance": "N", "torque": "N m"}
SHOWN = {1: "#d9a27f", 2: "#b4552d", 10: "#5a2412"}  # vehicles with a profile in the picture
GREEN = "#3f7d3a"


def means(rows):
    """Quantity -> its mean for each vehicle."""
    vehicles = np.unique(rows["vehicle"])
    on_track = (rows["x"] > TRACK[0]) & (rows["x"] < TRACK[1])
    return {name: np.array([rows[name][on_track & (rows["vehicle"] == k)].mean() for k in vehicles])
            for name in COLUMNS}


def draw(folder, mean, profiles):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.6), layout="constrained")
    for vehicle, colour in SHOWN.items():
        of = profiles["vehicle"] == vehicle
        left.plot(profiles["y"][of], 100 * profiles["height"][of], color=colour, label=f"after {vehicle}")
    left.set(title="Ruts across the track", xlabel="y [m]", ylabel="height [cm]")
    left.legend(frameon=False, loc="lower center")
    right.bar(np.arange(1, 11), mean["motion_resistance"], color=GREEN, width=0.6)
    right.set(title="Motion resistance", xlabel="vehicle", ylabel="force [N]", xticks=range(1, 11))
    bare((left, right))
    figure.savefig(folder / "convoy.png", dpi=120)


def check(mean):
    """The claims of the example."""
    deeper = np.diff(mean["rut_depth"])
    assert (deeper > 0).all(), f"a vehicle did not deepen the rut: {deeper} m"
    assert deeper[1:].max() < 0.6 * deeper[0], f"a later vehicle adds as much as the second: {deeper} m"
    resistance = mean["motion_resistance"]
    assert resistance[1] < 0.25 * resistance[0], f"the second is no easier: {resistance} N"
    assert abs(resistance[9]) < 0.1 * resistance[0], f"the tenth still meets resistance: {resistance} N"
    assert mean["torque"][9] < 0.1 * mean["torque"][0], f"the tenth needs torque: {mean['torque']} N m"


def main():
    folder = pathlib.Path(sys.argv[1])
    mean = means(read(folder / "vehicles.csv"))
    draw(folder, mean, read(folder / "profiles.csv"))
    write(folder / "convoy.csv", ["vehicle"] + [f"{name} [{unit}]" for name, unit in COLUMNS.items()],
          [[k + 1] + [mean[name][k] for name in COLUMNS] for k in range(10)])
    check(mean)


main()
