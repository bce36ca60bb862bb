#!/usr/bin/env python3
"""Real-time factor and memory of the HMMWV on a 2.5 cm grid, as `softsoil run` reports them.

    python3 tests/benchmark/vehicle.py [SECONDS] [--keep "MACHINE"]

With --keep the row is added to tests/benchmark/vehicle.csv. Run it on an idle machine.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

from keep import keep, show

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = ["threads", "simulated_time [s]", "real_time_factor", "volumes", "bytes_per_volume",
           "bytes_per_column", "peak_memory [MB]"]


def measure(seconds):
    """Runs the scene of the quickstart; returns its summary."""
    with tempfile.TemporaryDirectory() as out:
        subprocess.run(["softsoil", "run", "hmmwv_flat", "--time", str(seconds), "--out", out,
                        "--controls", str(HERE.parents[1] / "examples/quickstart_controls.csv"),
                        "--no-picture"], check=True, stdout=subprocess.DEVNULL)
        return json.loads((pathlib.Path(out) / "summary.json").read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("seconds", nargs="?", type=float, default=10.0)
    parser.add_argument("--keep", metavar="MACHINE")
    arguments = parser.parse_args()
    summary = measure(arguments.seconds)
    row = [summary["threads"], summary["simulated_time"], round(summary["real_time_factor"], 2),
           summary["volumes"], round(summary["bytes_per_volume"], 1),
           round(summary["bytes_per_column"], 1), round(summary["peak_memory_mb"])]
    show(COLUMNS, row)
    if arguments.keep:
        keep(HERE / "vehicle.csv", arguments.keep, COLUMNS, row)


if __name__ == "__main__":
    main()
