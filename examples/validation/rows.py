"""The rows of the validation table: measured, thesis' model, ours."""
import collections
import dataclasses

import model
import rigid_wheels
from printed import LITERAL, PLUS_SD, thesis_model

CANNOT = "the measured curve exists only as a figure"
FIRM = "at the printed 1.504 g/cm3 the firm soil yields above 350 kPa"


@dataclasses.dataclass
class Row:
    id: int
    section: str
    kind: str
    case: str
    quantity: str
    unit: str
    measured: float = None
    thesis: float = None
    ours: float = None
    ours_rolling: float = None  # with the slip against the rolling radius
    note: str = ""
    slip: float = None  # [%]
    speed: float = None  # [m/s]

    @property
    def reference(self):
        return self.thesis if self.measured is None else self.measured

    def error(self, value):
        """Relative error [%] of a value."""
        if value is None or self.reference in (None, 0):
            return None
        return 100 * (value / self.reference - 1)

    @property
    def thesis_error(self):
        return None if self.measured is None else self.error(self.thesis)

    @property
    def our_error(self):
        return self.error(self.ours)


def start(printed, quantity=None, **values):
    return Row(printed.id, printed.section, printed.kind, printed.case,
               quantity or printed.quantity, printed.unit, slip=printed.slip, speed=printed.speed,
               **values)


# Quantities of the experiment: column of drawbar.csv and factor to the printed unit.
COLUMNS = {"drawbar pull": ("drawbar_pull", 1e-3), "rut volume": ("compaction_volume", 1),
           "max rut depth": ("rut_depth", 1e3)}


LOW_SLIP = 20  # [%]  below it the definition of slip matters


def undeflected(slip, rolling):
    """Slip against the unloaded radius of a slip against the rolling radius."""
    return (1 + slip) * (1 + rolling["slip"]) - 1


def experiment_rows(printed, folder):
    """Wulfsohn and Upadhyaya's tests: the slips of one tire, soil and load in one run.

    Their slip may be against the unloaded or the rolling radius: the text does not say. The table
    takes the former, as equation 4.8; at low slip a column of its own tells what the latter gives.
    """
    groups = collections.defaultdict(list)
    for p in printed:
        if p.kind == "experiment" and p.quantity in COLUMNS:
            groups[(p.tire, p.soil, p.load, p.pressure)].append(p)
    rows = [row for group in groups.values() for row in rows_of_one_tire(group, printed, folder)]
    return sorted(rows, key=lambda row: row.id)


def rows_of_one_tire(group, printed, folder):
    slips = sorted({p.slip / 100 for p in group})
    ours, rolling = model.drawbar_rows(folder, group[0], slips)
    ours = dict(zip(slips, ours))
    for p in group:
        column, factor = COLUMNS[p.quantity]
        thesis, at_slip = thesis_model(p, printed)
        row = start(p, measured=p.number, thesis=thesis, ours=factor * ours[p.slip / 100][column])
        if at_slip is not None and at_slip != p.slip:
            row.note = f"thesis at {at_slip:g} %"
        if p.quantity == "drawbar pull" and p.slip < LOW_SLIP:
            slip = undeflected(p.slip / 100, rolling)
            [again], _ = model.drawbar_rows(folder, p, [slip])
            row.ours_rolling = factor * again[column]
        yield row


def width_rows(printed, folder):
    return [start(p, measured=p.number, ours=100 * model.contact_width(folder, p),
                  note="ours standing; bounded by the nominal width of the tread")
            for p in printed if p.quantity == "max contact width on tilled loam"]


def wong_reece_rows(printed, folder):
    """Ours against the printed results of the same method, under two readings."""
    rows = []
    for p in (p for p in printed if p.kind == "Wong-Reece"):
        for reading in (PLUS_SD, LITERAL):
            ours = model.wong_reece(folder, p, reading)[p.quantity]
            rows.append(start(p, thesis=p.number, ours=ours, note=reading))
    return rows


def tire_rows(printed):
    crown = {(p.tire, p.pressure): 0.01 * p.number for p in printed
             if p.quantity == "r_beta" and p.unit == "cm"}
    [plate] = [p for p in printed if p.quantity.startswith("wheel load at 0.1 m")]
    rows = []
    for p in (p for p in printed if p.kind == "tire fit"):
        if p.quantity.startswith("spring coefficients"):
            known = p.tire == plate.tire and p.pressure == plate.pressure
            row = start(p, "load at 0.1 m on a plate", thesis=plate.number if known else None,
                        ours=model.flat_plate(p, crown[(p.tire, p.pressure)]))
            row.note = "" if known else "no load is printed"
            row.unit = "N"
            rows.append(row)
        elif p.quantity.startswith("cylinder"):
            row = start(p, "load at 2 in on a plate", ours=model.cylinder_load(p),
                        note="no load is printed")
            row.unit = "N"
            rows.append(row)
        elif p.quantity in ("r_beta", "fit error (1e3)"):
            rows.append(start(p, thesis=p.number, note=f"not rerun: {CANNOT}"))
    return rows


def soil_volume_rows(printed):
    rows = []
    total = {soil: model.soil_volume(soil, 1) for soil in ("tilled", "firm")}
    for p in (p for p in printed if p.kind == "soil volume"):
        if p.section.endswith("Table 3.2"):
            ours = model.soil_volume(p.soil, p.speed)[p.quantity]
        elif p.quantity.startswith("total delta rho"):
            ours = total[p.soil]["delta rho"]
        else:
            quantity = "delta rho" if "delta rho" in p.quantity else "energy"
            firm = total["firm"][quantity]
            ours = total["tilled"][quantity] / firm if firm > 0 else None
        note = FIRM if p.section == "6.1.2" and p.soil != "tilled" else p.note
        rows.append(start(p, thesis=p.number, ours=ours, note=note))
    return rows


def rigid_wheel_rows(folder, first_id):
    return [Row(first_id + k, wheel.source, "rigid wheel", f"{wheel.name}, {100 * slip:g} % slip", quantity, unit,
                measured=measured, ours=ours, slip=100 * slip, note=f"grousers as {form}" if wheel.grousers else "")
            for k, (wheel, form, quantity, unit, slip, measured, ours)
            in enumerate(rigid_wheels.results(folder))]


def all_rows(printed, folder):
    rows = (experiment_rows(printed, folder) + width_rows(printed, folder) +
            wong_reece_rows(printed, folder) + tire_rows(printed) + soil_volume_rows(printed))
    return rows + rigid_wheel_rows(folder, first_id=1 + max(row.id for row in rows))
