#!/usr/bin/env python3
"""Soil as state in numbers: what `state_benchmark` (in PATH) tells of the HMMWV and of 100 m^2.

    python3 tests/benchmark/state.py [--keep "MACHINE"]

With --keep a row for each soil is added to tests/benchmark/state.csv. Run it on an idle machine.
"""
import argparse
import json
import pathlib
import subprocess

from keep import keep, show

HERE = pathlib.Path(__file__).resolve().parent
AREA = "compacts:{}/m2:100/real_time"
# Column: benchmark, its number, factor to the unit of the column.
NUMBERS = {
    "copy_after_100m [ms]": ("BM_CopyAfter100m/compacts:{}/real_time", "real_time", 1),
    "memory_of_copy [%]": ("BM_CopyAfter100m/compacts:{}/real_time", "more_%", 1),
    "step_with_marks [ratio]": ("BM_StepWithMarks/compacts:{}/iterations:100/manual_time", "ratio",
                                1),
    "history [MB/s]": ("BM_History/compacts:{}/allowed_MB:10000/iterations:1", "MB_per_s", 1),
    "history_allowed_10_MB [MB]": ("BM_History/compacts:{}/allowed_MB:10/iterations:1",
                                   "history_MB", 1),
    "bytes_per_m2": ("BM_Copy/" + AREA, "bytes_per_m2", 1),
    "copy [ms]": ("BM_Copy/" + AREA, "real_time", 1),
    "snapshot [ms]": ("BM_Snapshot/" + AREA, "real_time", 1),
    "restore [ms]": ("BM_Restore/" + AREA, "real_time", 1),
    "first_write [ms]": ("BM_FirstWrite/" + AREA, "real_time", 1),
    "save [GB/s]": ("BM_Save/" + AREA, "bytes_per_second", 1e-9),
    "load [GB/s]": ("BM_Load/" + AREA, "bytes_per_second", 1e-9),
    "hash [GB/s]": ("BM_Hash/" + AREA, "bytes_per_second", 1e-9),
    "memcpy [GB/s]": ("BM_Memcpy", "bytes_per_second", 1e-9),
}


def measure():
    """Runs the benchmark; returns its results by name."""
    output = subprocess.run(
        ["state_benchmark", "--benchmark_format=json",
         "--benchmark_filter=m2:100/|100m|Marks|History|Memcpy"],
        check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    return {result["name"]: result for result in json.loads(output)["benchmarks"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--keep", metavar="MACHINE")
    arguments = parser.parse_args()
    results = measure()
    columns = ["soil", *NUMBERS]
    for compacts in (0, 1):
        soil = results[f"BM_Copy/compacts:{compacts}/m2:100/real_time"]["label"]
        row = [soil] + [f"{results[name.format(compacts)][number] * factor:.3g}"
                        for name, number, factor in NUMBERS.values()]
        show(columns, row)
        if arguments.keep:
            keep(HERE / "state.csv", arguments.keep, columns, row)


if __name__ == "__main__":
    main()
