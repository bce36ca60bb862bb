#!/usr/bin/env python3
"""Time of a drawbar curve of eight slips on a 2.5 cm grid: `softsoil drawbar` without pictures.

    python3 tests/benchmark/drawbar.py [--keep "MACHINE"]

With --keep the row is added to tests/benchmark/drawbar.csv. Run it on an idle machine.
"""
import argparse
import os
import pathlib
import subprocess
import tempfile
import time

from keep import keep, show

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = ["threads", "slips", "time [s]"]


def measure():
    """Wall time [s] of the curve."""
    with tempfile.TemporaryDirectory() as out:
        start = time.monotonic()
        subprocess.run(["softsoil", "drawbar", "--tire", "18.4R38_85kPa", "--soil",
                        "tilled_yolo_loam", "--load", "18000", "--slip", "0.05:0.4:0.05",
                        "--no-picture", "--out", out], check=True, stdout=subprocess.DEVNULL)
        return time.monotonic() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--keep", metavar="MACHINE")
    arguments = parser.parse_args()
    row = [os.cpu_count(), 8, round(measure(), 1)]
    show(COLUMNS, row)
    if arguments.keep:
        keep(HERE / "drawbar.csv", arguments.keep, COLUMNS, row)


if __name__ == "__main__":
    main()
