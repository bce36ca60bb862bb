"""What the examples share: tables that softsoil writes, and plain axes."""
import csv

import numpy as np


def read(path, wheel=None):
    """Column without its unit -> array, empty cells are NaN; of one wheel where several are in the table."""
    with open(path, newline="") as file:
        rows = [row for row in csv.DictReader(file) if wheel in (None, row.get("wheel"))]
    return {key.split(" [")[0]: np.array([float(row[key] or "nan") for row in rows])
            for key in rows[0] if key != "wheel"}


def write(path, header, rows):
    """Writes a table and prints it. Numbers have four digits."""
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(header)
        table.writerows([f"{cell:.4g}" if isinstance(cell, float) else cell for cell in row] for row in rows)
    print(path.read_text(), end="")


def bare(axes):
    """Without a frame at the top and on the right."""
    for one in axes:
        one.spines[["top", "right"]].set_visible(False)
