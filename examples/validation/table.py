"""Writes the rows as table.csv and, with the claims on top, as table.md."""
import csv

HEADER = ["id", "section", "kind", "case", "quantity", "unit", "measured", "thesis' model", "ours",
          "ours, slip of the rolling radius", "error of thesis' model [%]", "error of ours [%]",
          "note"]


def shown(value, digits=4):
    return "" if value is None else f"{value:.{digits}g}"


def percent(value):
    return "" if value is None else f"{value:+.1f}"


def cells(row):
    return [str(row.id), row.section, row.kind, row.case, row.quantity, row.unit,
            shown(row.measured), shown(row.thesis), shown(row.ours), shown(row.ours_rolling),
            percent(row.thesis_error),
            percent(row.our_error), row.note]


def write_csv(rows, path):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(HEADER)
        writer.writerows(cells(row) for row in rows)


def write_markdown(rows, claims, path):
    lines = ["# Validation against the numbers of Madsen (2014) and tests of rigid wheels", "",
             "Errors are against the measured value; where nothing was measured, against the "
             "thesis' model.", ""]
    for sentence, holds in claims:
        lines.append(f"- {sentence}" + {None: "", True: "", False: " - NOT AS CLAIMED"}[holds])
    for kind in dict.fromkeys(row.kind for row in rows):
        lines += ["", f"## {kind}", "", "| " + " | ".join(HEADER[3:]) + " |",
                  "|---|---|---|--:|--:|--:|--:|--:|--:|---|"]
        lines += ["| " + " | ".join(cells(row)[3:]) + " |" for row in rows if row.kind == kind]
    path.write_text("\n".join(lines) + "\n")
