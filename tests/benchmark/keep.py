"""Prints a row of results, and adds it to a table that is kept in the tree."""
import csv
import datetime


def show(columns, row):
    for name, value in zip(columns, row):
        print(f"{name:20} {value}")


def keep(table, machine, columns, row):
    """Adds date, machine and the row to a CSV file."""
    is_new = not table.exists()
    with table.open("a", newline="") as file:
        writer = csv.writer(file)
        if is_new:
            writer.writerow(["date", "machine", *columns])
        writer.writerow([datetime.date.today().isoformat(), machine, *row])
