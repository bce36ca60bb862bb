"""softsoil drawbar as its tests call it."""
import csv
import pathlib

from program import InAFolder, softsoil

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Coarser still than that of the vehicles: the tires here are twice as large.
GRID = ["--set", "grid_spacing=0.07", "--set", "volume_height=0.1", "--set", "volumes=8"]
TIRE, SOIL, LOAD = "18.4R38_85kPa", "tilled_yolo_loam", 18000


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def numbers(path):
    """Rows of a CSV file of numbers, columns without their units."""
    return [{key.split(" [")[0]: float(value) for key, value in row.items()}
            for row in table(path)]


def drawbar(out, *more, tire=TIRE, soil=SOIL, load=LOAD):
    return softsoil("drawbar", "--tire", tire, "--soil", soil, "--load", load, "--out", out,
                    "--no-picture", *GRID, *more)


class Bin(InAFolder):
    def drawbar(self, *more, out=None, **given):
        return drawbar(out or self.folder, *more, **given)

    def rows(self, *more, out=None, **given):
        done = self.drawbar(*more, out=out, **given)
        self.assertEqual(done.returncode, 0, done.stderr)
        return numbers((out or self.folder) / "drawbar.csv")
