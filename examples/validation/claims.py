"""What the README claims, worked out from the table, and whether it holds."""
import math
import statistics

from printed import LITERAL, PLUS_SD


def root_mean_square(values):
    return math.sqrt(sum(v * v for v in values) / len(values))


def mean_size(values):
    return sum(abs(v) for v in values) / len(values)


def pulls(rows, least_slip, most_slip=math.inf):
    """Measured drawbar pulls at slips above and up to a bound [%]."""
    return [r for r in rows if r.kind == "experiment" and r.quantity == "drawbar pull"
            and least_slip < r.slip <= most_slip]


# What is claimed of rigid wheels: bounds [%] of the median error, by source, form of grousers and quantity.
RIGID_WHEEL_BOUNDS = {("Ding et al. 2011", "lugs", "drawbar pull"): 20, ("Ding et al. 2011", "lugs", "sinkage"): 40,
                      ("Ding et al. 2011", "lugs", "torque"): 10, ("Ding et al. 2011", "mesh", "torque"): 10,
                      ("Wang and Han 2016", "mesh", "torque"): 20, ("Hurrell et al. 2025", "mesh", "sinkage"): 30}


def rigid_wheel_claims(rows):
    """Smooth wheels count with either form of grousers."""
    rows = [r for r in rows if r.kind == "rigid wheel" and r.our_error is not None]
    for source, quantity in dict.fromkeys((r.section, r.quantity) for r in rows):
        for form in ("lugs", "mesh"):
            errors = [abs(r.our_error) for r in rows if (r.section, r.quantity) == (source, quantity)
                      and r.note in ("", f"grousers as {form}")]
            median = statistics.median(errors)
            bound = RIGID_WHEEL_BOUNDS.get((source, form, quantity))
            yield (f"rigid wheels of {source}, grousers as {form}, {quantity}: median error {median:.0f} % in "
                   f"{len(errors)} cases", None if bound is None else median <= bound)


def claims(rows):
    """Sentences with their numbers, and whether each holds (None: no bound is claimed)."""
    high, low = pulls(rows, 20), pulls(rows, 0, 20)
    ours, thesis = ([r.our_error for r in high], [r.thesis_error for r in high])
    yield (f"drawbar pull above 20 % slip: mean error {mean_size(ours):.0f} % in {len(high)} cases "
           f"(the thesis' own model {mean_size(thesis):.0f} %)", mean_size(ours) <= 20)
    closer = sum(abs(a) < abs(b) for a, b in zip(ours, thesis))
    yield f"closer than the thesis' own model in {closer} of {len(high)}", closer == len(high)
    rolling = [r.error(r.ours_rolling) for r in low]
    ours = mean_size([r.our_error for r in low])
    yield (f"below 20 % slip: mean error {ours:.0f} % in {len(low)} cases, "
           f"{mean_size(rolling):.0f} % with the slip against the rolling radius (the "
           f"thesis' own model {mean_size([r.thesis_error for r in low]):.0f} %)", None)
    for quantity in ("delta rho", "energy", "peak power"):
        errors = [r.our_error for r in rows if r.kind == "soil volume" and r.quantity == quantity]
        rms = root_mean_square(errors)
        yield f"soil volume, Table 3.2, {quantity}: rms error {rms:.1f} %", rms <= 5
    for soil in ("tilled", "firm"):
        for reading in (PLUS_SD, LITERAL):
            errors = [r.our_error for r in rows if r.kind == "Wong-Reece" and soil in r.case
                      and r.note == reading]
            worst, rms = max(abs(e) for e in errors), root_mean_square(errors)
            bound = worst <= 12 if (soil, reading) == ("tilled", PLUS_SD) else None
            yield (f"Wong-Reece, {soil}, {reading}: rms error {rms:.0f} %, worst {worst:.0f} %",
                   bound)
    yield from rigid_wheel_claims(rows)
