"""Reads the drives of 13_one_side_soft.sh: one_side_soft.csv, one_side_soft.png, and their claims."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from wheels_table import bare, read, write

GROUNDS = {"one_side_soft": ("right side soft", "#b4552d"), "firm": ("firm", "#3f7d3a")}
WHEELS = ["wheel_fl", "wheel_fr", "wheel_rl", "wheel_rr"]
START, BRAKES, END = 1, 6.5, 10  # [s]  of the drive
SECTION = 10  # [m]  where the ruts are shown
QUANTITIES = {"heading when the brakes come on [deg]": "heading_before", "heading at the end [deg]": "heading_after",
              "offset to the left [m]": "offset", "rut on the left [m]": "rut_left",
              "rut on the right [m]": "rut_right", "motion resistance on the left [N]": "resistance_left",
              "motion resistance on the right [N]": "resistance_right"}


class Drive:
    """The vehicle in the middle of its wheels; headings to the left."""

    def __init__(self, folder):
        wheels = {name: read(folder / "wheels.csv", name) for name in WHEELS}
        self.time = wheels[WHEELS[0]]["time"]
        self.x, self.y = (sum(wheel[axis] for wheel in wheels.values()) / 4 for axis in "xy")
        ahead = [sum(wheels[name][axis] for name in WHEELS[:2]) / 2 for axis in "xy"]
        self.heading = np.degrees(np.arctan2(ahead[1] - self.y, ahead[0] - self.x))
        self.heading_before, self.heading_after = self.at(BRAKES, self.heading), float(self.heading[-1])
        self.offset = float(self.y[-1])
        rolls = (self.time > START + 1) & (self.time < BRAKES)
        for side, names in (("left", WHEELS[::2]), ("right", WHEELS[1::2])):
            setattr(self, f"rut_{side}", wheels[names[1]]["rut_depth"][rolls].mean())
            setattr(self, f"resistance_{side}", sum(wheels[n]["motion_resistance"][rolls].mean() for n in names))
        self.farthest_right_of_the_left = min(wheels[name]["y"].min() for name in WHEELS[::2])
        ground = np.load(folder / "terrain.npy")
        self.section = ground[np.abs(ground[:, 0] - SECTION) < 0.01]

    def at(self, time, of):
        return float(np.interp(time, self.time, of))


def draw(folder, drives):
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
    for ground, (label, colour) in GROUNDS.items():
        drive = drives[ground]
        axes[0].plot(drive.x, drive.y, color=colour, label=label)
        axes[1].plot(drive.time, drive.heading, color=colour)
        axes[2].plot(drive.section[:, 1], 100 * drive.section[:, 2], color=colour)
    axes[1].axvline(BRAKES, color="#6b6b6b", linestyle=":", linewidth=1)
    axes[1].annotate("brakes", (BRAKES + 0.1, 0.03), xycoords=("data", "axes fraction"), color="#6b6b6b")
    axes[0].set(title="Path", xlabel="x [m]", ylabel="y [m]")
    axes[1].set(title="Heading, to the left", xlabel="time [s]", ylabel="angle [deg]")
    axes[2].set(title=f"Ruts at x = {SECTION} m", xlabel="y [m]", ylabel="height [cm]")
    axes[2].invert_xaxis()  # as seen from behind
    axes[0].legend(frameon=False)
    bare(axes)
    figure.savefig(folder / "one_side_soft.png", dpi=120)


def check(soft, firm):
    """The claims of the example."""
    assert soft.farthest_right_of_the_left > 0.2, f"left wheels came to y = {soft.farthest_right_of_the_left} m"
    headings = [soft.at(time, soft.heading) for time in np.arange(START + 1, BRAKES + 0.1, 0.5)]
    assert (np.diff(headings) < 0).all() and headings[-1] < -0.5, f"not pulled to the soft side: {headings} deg"
    assert soft.offset < -0.2, f"it stays in its lane: {soft.offset} m"
    assert soft.heading_after > soft.heading_before + 0.5, f"brakes turn it from {headings[-1]} to {soft.heading_after} deg"
    assert soft.rut_right > 2 * soft.rut_left, f"ruts: {soft.rut_left}, {soft.rut_right} m"
    assert soft.resistance_right > 1.5 * soft.resistance_left, "the soft side resists no more"
    assert np.abs(firm.heading).max() < 0.02 and np.abs(firm.y).max() < 0.005, "firm soil turns it"
    assert abs(firm.rut_right - firm.rut_left) < 1e-4, f"firm ruts: {firm.rut_left}, {firm.rut_right} m"


def main():
    folder = pathlib.Path(sys.argv[1])
    drives = {ground: Drive(folder / ground) for ground in GROUNDS}
    draw(folder, drives)
    write(folder / "one_side_soft.csv", ["ground", *QUANTITIES],
          [[ground] + [float(getattr(drive, name)) for name in QUANTITIES.values()]
           for ground, drive in drives.items()])
    check(drives["one_side_soft"], drives["firm"])


main()
