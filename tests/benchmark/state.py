#!/usr/bin/env python3
"""Soil as state in numbers: what `state_benchmark` (in PATH) tells of the HMMWV as it drives, and of
1 to 1,000 m^2 of deformed ground.

    python3 tests/benchmark/state.py [--keep "MACHINE"]

With --keep rows are added to tests/benchmark/state.csv, one for each soil, and to state_area.csv,
one for each soil and area. Takes some minutes and 6 GB of memory; run it on an idle machine.
"""
import argparse
import json
import pathlib
import subprocess

from keep import keep, show

HERE = pathlib.Path(__file__).resolve().parent
AREAS = 1, 10, 100, 1000  # [m^2]
# Column: benchmark, its number, factor to the unit of the column.
DRIVING = {
    "copy_after_100m [ms]": ("BM_CopyAfter100m/compacts:{}/real_time", "real_time", 1),
    "memory_of_copy [%]": ("BM_CopyAfter100m/compacts:{}/real_time", "more_%", 1),
    "step_with_marks [ratio]": ("BM_StepWithMarks/compacts:{}/iterations:100/manual_time", "ratio",
                                1),
    "history [MB/s]": ("BM_History/compacts:{}/allowed_MB:10000/iterations:1", "MB_per_s", 1),
    "history_allowed_10_MB [MB]": ("BM_History/compacts:{}/allowed_MB:10/iterations:1",
                                   "history_MB", 1),
}
AREA = {
    "bytes_per_m2": ("Copy", "bytes_per_m2", 1),
    "copy [ms]": ("Copy", "real_time", 1),
    "snapshot [ms]": ("Snapshot", "real_time", 1),
    "restore [ms]": ("Restore", "real_time", 1),
    "first_write [ms]": ("FirstWrite", "real_time", 1),
    "save [ms]": ("Save", "real_time", 1),
    "load [ms]": ("Load", "real_time", 1),
    "hash [ms]": ("Hash", "real_time", 1),
    "save [GB/s]": ("Save", "bytes_per_second", 1e-9),
    "load [GB/s]": ("Load", "bytes_per_second", 1e-9),
    "hash [GB/s]": ("Hash", "bytes_per_second", 1e-9),
}


def measure():
    """Runs the benchmark; returns its results by name."""
    output = subprocess.run(["state_benchmark", "--benchmark_format=json"], check=True,
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    return {result["name"]: result for result in json.loads(output)["benchmarks"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--keep", metavar="MACHINE")
    arguments = parser.parse_args()
    results = measure()

    def tell(table, columns, row):
        show(columns, row)
        if arguments.keep:
            keep(HERE / table, arguments.keep, columns, row)

    def value(name, number, factor):
        return f"{results[name][number] * factor:.3g}"

    for compacts in (0, 1):
        soil = results[f"BM_Copy/compacts:{compacts}/m2:1/real_time"]["label"]
        tell("state.csv", ["soil", *DRIVING],
             [soil] + [value(name.format(compacts), *rest) for name, *rest in DRIVING.values()])
        for m2 in AREAS:
            tell("state_area.csv", ["soil", "area [m^2]", *AREA],
                 [soil, m2] + [value(f"BM_{name}/compacts:{compacts}/m2:{m2}/real_time", *rest)
                               for name, *rest in AREA.values()])


if __name__ == "__main__":
    main()
