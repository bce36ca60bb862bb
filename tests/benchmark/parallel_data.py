#!/usr/bin/env python3
"""Time steps per second of one and of two HMMWVs at once, each mjData in a thread of its own.

    python3 tests/benchmark/parallel_data.py [REPETITIONS] [--keep "MACHINE"]

Runs the program parallel_data_benchmark with one and two by turns; every soil with sync=1
threads=1. With --keep the row is added to tests/benchmark/parallel_data.csv. Run it on an idle
machine of two processors or more; wanted: a ratio of at least 1.8.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess

from keep import keep, show

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = ["processors", "repetitions", "steps_per_second_of_1", "steps_per_second_of_2", "ratio",
           "least_ratio", "largest_ratio"]


def steps_per_second(count):
    """Of `count` mjData together."""
    out = subprocess.run(["parallel_data_benchmark", f"--benchmark_filter=data:{count}/",
                          "--benchmark_format=json"], check=True, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    (result,) = json.loads(out)["benchmarks"]
    return result["items_per_second"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("repetitions", nargs="?", type=int, default=7)
    parser.add_argument("--keep", metavar="MACHINE")
    arguments = parser.parse_args()
    pairs = [(steps_per_second(1), steps_per_second(2)) for _ in range(arguments.repetitions)]
    ratios = [two / one for one, two in pairs]
    row = [os.cpu_count(), len(pairs), *(round(statistics.median(rates)) for rates in zip(*pairs)),
           *(round(f(ratios), 2) for f in (statistics.median, min, max))]
    show(COLUMNS, row)
    if arguments.keep:
        keep(HERE / "parallel_data.csv", arguments.keep, COLUMNS, row)


if __name__ == "__main__":
    main()
