"""The numbers printed in the thesis, from values.csv."""
import csv
import dataclasses
import pathlib

HERE = pathlib.Path(__file__).parent
LITERAL = "as printed"
PLUS_SD = "K mean + SD"  # the reading under which the Wong-Reece results of the thesis come out


@dataclasses.dataclass
class Printed:
    """One number of the thesis. Loads in kN, pressures in kPa, slips in %, None where not given."""
    id: int
    section: str
    kind: str
    tire: str
    soil: str
    load: float
    pressure: float
    slip: float
    speed: float
    spring: str
    quantity: str
    value: str
    unit: str
    note: str

    @property
    def number(self):
        return float(self.value)

    @property
    def case(self):
        """What was tested, in words."""
        parts = [self.tire, self.soil]
        for value, unit in ((self.pressure, "kPa"), (self.load, "kN"), (self.slip, "% slip"),
                            (self.speed, "m/s")):
            parts.append("" if value is None else f"{value:g} {unit}")
        return ", ".join(part for part in parts + [self.spring] if part)


def number_or_none(text):
    return float(text) if text else None


def read():
    with open(HERE / "values.csv", newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [Printed(int(r["id"]), r["section"], r["kind"], r["tire"], r["soil"],
                        *(number_or_none(r[c]) for c in ("load [kN]", "pressure [kPa]",
                                                         "slip [%]", "speed [m/s]")),
                        *(r[c] for c in ("spring", "quantity", "value", "unit", "note")))
                for r in rows]


def thesis_model(row, printed):
    """What the thesis' own model gives for a measured value, and at which slip [%].

    Where it prints none for that slip, its neighbour counts that is closer to the measured value.
    Of a pair without slips the first stands for the lower slip.
    """
    quantity = {"rut volume": "contact patch compaction volume"}.get(row.quantity, row.quantity)
    near = [p for p in printed
            if p.kind == "dynamic tire" and p.quantity == quantity and p.tire == row.tire
            and p.soil == row.soil and p.pressure == row.pressure
            and p.load is not None and abs(p.load - row.load) < 1]
    if not near:
        return None, None
    if all(p.slip is None for p in near):
        pair = [p for p in printed if p.kind == row.kind and p.quantity == row.quantity
                and p.tire == row.tire and p.load == row.load and p.pressure == row.pressure]
        lower = row.slip == min(p.slip for p in pair)
        return near[0 if lower else 1].number, None
    below = max((p.slip for p in near if p.slip <= row.slip), default=None)
    above = min((p.slip for p in near if p.slip >= row.slip), default=None)
    neighbours = [p for p in near if p.slip in ((row.slip,) if below == above else (below, above))]
    best = min(neighbours, key=lambda p: abs(p.number - row.number))
    return best.number, best.slip
