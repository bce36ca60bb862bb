"""Reads the drives of 12_slopes.sh: slopes.csv, slopes.png, and their claims."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from wheels_table import bare, read, write

GROUNDS = {"tilled_yolo_loam": ("tilled loam", "#b4552d"), "firm_yolo_loam": ("firm loam", "#3f7d3a"),
           "rigid_ground": ("rigid ground", "#6b6b6b")}
STRENGTH = {"tilled_yolo_loam": (7100, 21.17), "firm_yolo_loam": (35720, 23.13)}  # [Pa], [deg]
RUBBER = 0.65  # [-]  friction of the tire on soil
CURVED = 1.02  # [-]  of the bounds: shear along the curved contact carries a little of the load
WINDOW = 1     # [deg] of slope: what is averaged
HEADER = ["ground", "way", "limit [deg]", "thrust [N]", "motion resistance [N]", "Mohr-Coulomb [N]", "rubber [N]"]


class Drive:
    """One way on one ground; forces along the slope, against the way that gravity pulls."""

    def __init__(self, folder, ground, way):
        rows = read(folder / f"{ground}.{way}.csv")
        self.ground, self.way = ground, way
        self.slope, self.speed = rows["slope"], rows["speed"]
        rows["thrust"] *= 1 if way == "up" else -1
        mean = {name: self.smooth(values) for name, values in rows.items()}
        # The pull that wheels still have is what holds the vehicle on a slope: resistance helps only downhill.
        resistance = mean["motion_resistance"] * (-1 if way == "up" else 1)
        held = (mean["thrust"] + resistance) / mean["load"]
        best = np.nanargmax(held)
        self.limit = np.degrees(np.arctan(held[best]))
        self.thrust, self.resistance = mean["thrust"][best], mean["motion_resistance"][best]
        self.rubber = RUBBER * mean["load"][best]
        cohesion, angle = STRENGTH.get(ground, (np.inf, 0))
        self.soil = cohesion * mean["contact_area"][best] + mean["load"][best] * np.tan(np.radians(angle))

    def smooth(self, values):
        """Mean over the window around each row; NaN where it is cut."""
        count = int(round(WINDOW / np.median(np.diff(self.slope))))
        mean = np.full(values.shape, np.nan)
        inner = np.convolve(values, np.ones(count) / count, "valid")
        mean[count // 2: count // 2 + inner.size] = inner
        return mean

    def row(self):
        soil = self.soil if np.isfinite(self.soil) else ""
        return [self.ground, self.way, self.limit, self.thrust, self.resistance, soil, self.rubber]


def draw(folder, drives):
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.8), layout="constrained", sharey=True)
    for one, way in zip(axes, ("up", "down")):
        for ground, (label, colour) in GROUNDS.items():
            drive = drives[ground, way]
            one.plot(drive.slope, drive.smooth(drive.speed), color=colour, label=label)
            one.axvline(drive.limit, color=colour, linestyle=":", linewidth=1)
        one.set(xlabel="slope [deg]", title={"up": "Uphill", "down": "Downhill"}[way])
    axes[0].set(ylabel="speed [m/s]")
    axes[0].legend(frameon=False, title="dotted: the limit", loc="upper left")
    bare(axes)
    figure.savefig(folder / "slopes.png", dpi=120)


def check(drives):
    """The claims of the example."""
    for way in ("up", "down"):
        limits = [drives[ground, way].limit for ground in GROUNDS]
        assert limits[0] < limits[1] - 2 and limits[0] < limits[2] - 2, f"{way}: soft soil holds most: {limits} deg"
    up = {ground: drives[ground, "up"].limit for ground in GROUNDS}
    down = {ground: drives[ground, "down"].limit for ground in GROUNDS}
    assert up["firm_yolo_loam"] < up["rigid_ground"], f"firm soil holds more than rigid ground: {up} deg"
    assert down["tilled_yolo_loam"] > up["tilled_yolo_loam"] + 2, f"resistance does not hold downhill: {up}, {down} deg"
    assert abs(down["rigid_ground"] - up["rigid_ground"]) < 0.5, f"rigid ground holds unlike: {up}, {down} deg"
    for drive in drives.values():
        name = f"{drive.ground} {drive.way}"
        bound = min(drive.soil, drive.rubber)
        assert 0.85 * bound < drive.thrust < CURVED * bound, f"{name}: {drive.thrust} N of {bound} N"
        ends = drive.speed[-1]
        assert ends < 0.1 if drive.way == "up" else ends > 2.9, f"{name}: it goes on at {ends} m/s"
        assert drive.slope[-1] > drive.limit, f"{name}: it gives up before the limit"


def main():
    folder = pathlib.Path(sys.argv[1])
    drives = {(ground, way): Drive(folder, ground, way) for ground in GROUNDS for way in ("up", "down")}
    draw(folder, drives)
    write(folder / "slopes.csv", HEADER, [drive.row() for drive in drives.values()])
    check(drives)


main()
