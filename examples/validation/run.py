"""Reruns what the thesis prints and writes one table, and pictures of it.

Usage: python3 run.py FOLDER, with the program softsoil in PATH and its build in SOFTSOIL_BUILD.
Ends with an error if a claim of the README does not hold.
"""
import pathlib
import sys

import pictures
import printed
import rows
import table
from claims import claims


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    values = printed.read()
    result = rows.all_rows(values, folder / "runs")
    judged = list(claims(result))
    table.write_csv(result, folder / "table.csv")
    table.write_markdown(result, judged, folder / "table.md")
    pictures.draw(result, folder)
    for sentence, holds in judged:
        print(("" if holds is not False else "NOT AS CLAIMED: ") + sentence)
    print(f"\n{len(result)} rows in {folder / 'table.md'}, pictures beside it")
    if any(holds is False for _, holds in judged):
        sys.exit(1)


if __name__ == "__main__":
    main()
