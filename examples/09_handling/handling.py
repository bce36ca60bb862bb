"""Reads the drives of 09_handling.sh: handling.csv, handling.png, and their claims."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from wheels_table import bare, read, write

GROUNDS = {"tilled_yolo_loam": ("tilled loam", "#b4552d"), "firm_yolo_loam": ("firm loam", "#3f7d3a"),
           "rigid_ground": ("rigid ground", "#6b6b6b")}
MANOEUVRES = ["straight", "step_steer", "lane_change"]
WHEELS = ["wheel_fl", "wheel_fr", "wheel_rl", "wheel_rr"]


class Drive:
    """The vehicle in the middle of its wheels."""

    def __init__(self, folder):
        wheels = {name: read(folder / "wheels.csv", name) for name in WHEELS}
        self.time = wheels[WHEELS[0]]["time"]
        x, y = (sum(wheel[axis] for wheel in wheels.values()) / 4 for axis in "xy")
        self.x, self.y = x, y
        self.speed = np.hypot(np.gradient(x, self.time), np.gradient(y, self.time))
        ahead = [sum(wheels[name][axis] for name in WHEELS[:2]) / 2 for axis in "xy"]
        self.heading = np.unwrap(np.arctan2(ahead[1] - y, ahead[0] - x))
        self.rut = max(wheel["rut_depth"].max() for wheel in wheels.values())

    def at(self, time, of):
        return float(np.interp(time, self.time, of))


def numbers(drives):
    """Rows of handling.csv: manoeuvre, ground, quantity, value."""
    for ground in GROUNDS:
        drive = drives["straight", ground]
        slow = drive.time > 5
        slow &= drive.speed < 1
        yield "straight", ground, "speed after 3 s of drive [m/s]", drive.at(4.5, drive.speed)
        yield "straight", ground, "braking distance to 1 m/s [m]", drive.x[slow][0] - drive.at(5, drive.x)
        yield "straight", ground, "deepest rut [m]", drive.rut
        drive = drives["step_steer", ground]
        turn = drive.at(10, drive.heading) - drive.at(8, drive.heading)
        path = drive.at(9, drive.speed) * 2
        yield "step_steer", ground, "radius of the turn [m]", path / turn
        yield "step_steer", ground, "speed in the turn [m/s]", drive.at(9, drive.speed)
        drive = drives["lane_change", ground]
        yield "lane_change", ground, "greatest offset [m]", drive.y.max()
        yield "lane_change", ground, "heading at the end [deg]", np.degrees(drive.heading[-1])


def draw(folder, drives):
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.8), layout="constrained")
    for ground, (label, colour) in GROUNDS.items():
        drive = drives["straight", ground]
        axes[0].plot(drive.time, drive.speed, color=colour, label=label)
        for side, manoeuvre in zip(axes[1:], MANOEUVRES[1:]):
            drive = drives[manoeuvre, ground]
            side.plot(drive.x, drive.y, color=colour)
    axes[0].set(title="Accelerate and brake", xlabel="time [s]", ylabel="speed [m/s]")
    axes[1].set(title="Step steer", xlabel="x [m]", ylabel="y [m]", aspect="equal")
    axes[2].set(title="Double lane change", xlabel="x [m]", ylabel="y [m]")
    bare(axes)
    axes[0].legend(frameon=False)
    figure.savefig(folder / "handling.png", dpi=120)


def check(values):
    """The claims of the example."""
    def rises(manoeuvre, quantity):
        by_ground = [values[manoeuvre, ground, quantity] for ground in GROUNDS]
        assert by_ground == sorted(by_ground), f"{quantity} from soft to rigid: {by_ground}"

    rises("straight", "speed after 3 s of drive [m/s]")
    rises("straight", "braking distance to 1 m/s [m]")
    rises("step_steer", "speed in the turn [m/s]")
    rut = [values["straight", ground, "deepest rut [m]"] for ground in GROUNDS]
    assert rut[0] > 0.02 and rut[0] > rut[1] > rut[2] and rut[2] < 0.001, f"ruts: {rut} m"


def main():
    folder = pathlib.Path(sys.argv[1])
    drives = {(manoeuvre, ground): Drive(folder / manoeuvre / ground)
              for manoeuvre in MANOEUVRES for ground in GROUNDS}
    rows = list(numbers(drives))
    draw(folder, drives)
    write(folder / "handling.csv", ["manoeuvre", "ground", "quantity", "value"], rows)
    check({row[:3]: row[3] for row in rows})


main()
