"""Tests of single rigid wheels, smooth and with grousers, beside what softsoil gives for them.

Grousers are computed twice: as the lugs of a cylinder, where the soil between two shears as one with them, and as
a mesh, where each face presses by itself.
"""
import csv
import dataclasses
import sys

import model
from printed import HERE

sys.path.insert(0, str(HERE.parent))
import grouser_wheel

STEEL = 0.5  # [-]  friction of steel on soil, as of the rigid shapes of a model (Potyondy 1961)
# Stiff: under the 10 kPa of these wheels its surface gives by 0.1 mm.
TIRE = """<tires><tire name="{name}" description="{name}">
  <shape type="cylinder" radius="{outer:g}" width="{width:g}" source="{source}"/>
  {grousers}
  <spring linear="1e8" damping="0" source="rigid"/>
  <friction coefficient="{friction:g}" source="steel on soil, Potyondy 1961"/>
</tire></tires>
"""


@dataclasses.dataclass
class Wheel:
    name: str
    source: str
    soil: str
    radius: float  # [m]  of the drum
    width: float  # [m]
    load: float  # [N]
    grousers: int = 0
    height: float = 0  # [m]  of a grouser
    thickness: float = 0  # [m]

    @property
    def outer(self):
        return self.radius + self.height

    @property
    def forms(self):
        return ("lugs", "mesh") if self.grousers else ("smooth",)


# The thickness of the grousers of Ding and of Rashid-1 is not given: 2 mm, sheet metal, is our choice.
WHEELS = [
    Wheel("Ding smooth", "Ding et al. 2011", "ding2011_simulant", 0.15735, 0.165, 80),
    Wheel("Ding grousers", "Ding et al. 2011", "ding2011_simulant", 0.15735, 0.165, 80, 30, 0.01, 0.002),
    Wheel("KLS-1 smooth", "Wang and Han 2016", "kls_1", 0.085, 0.08, 58.86),
    Wheel("KLS-1 grousers", "Wang and Han 2016", "kls_1", 0.085, 0.08, 58.86, 16, 0.01, 0.003),
    Wheel("Rashid-1", "Hurrell et al. 2025", "fjs_1_loose", 0.1, 0.08, 24.5, 14, 0.02, 0.002),
]
QUANTITIES = {"drawbar pull": "N", "sinkage": "m", "torque": "N m"}


def measured():
    """By wheel: its slips [-], each with its measured quantities; None where none is given."""
    tests = {wheel.name: {} for wheel in WHEELS}
    with open(HERE / "rigid_wheels.csv", newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            tests[row["wheel"]][float(row["slip [-]"])] = {
                quantity: float(row[f"{quantity} [{unit}]"]) if row[f"{quantity} [{unit}]"] else None
                for quantity, unit in QUANTITIES.items()}
    return tests


def grousers_xml(wheel, form, folder):
    """The element of a tire entry for the grousers of a wheel; writes their mesh beside it."""
    if form == "lugs":
        return (f'<lugs height="{wheel.height:g}" count="{wheel.grousers}" width="{wheel.thickness:g}" '
                f'source="{wheel.source}"/>')
    if form == "mesh":
        outline = grouser_wheel.outline(wheel.radius, wheel.grousers, wheel.height, wheel.thickness)
        (folder / "wheel.obj").write_text(grouser_wheel.obj(outline, wheel.width) + "\n")
        return '<mesh file="wheel.obj" source="made of those numbers"/>'
    return ""


def driven(wheel, form, slips, folder):
    """Quantities by slip 1 - v/(r w) of the wheel in the soil bin; r reaches to the tips of the grousers."""
    name = f"{wheel.name} {form}".replace(" ", "_")
    folder = folder / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "tires.xml").write_text(TIRE.format(name=name, outer=wheel.outer, width=wheel.width,
                                                  source=wheel.source, friction=STEEL,
                                                  grousers=grousers_xml(wheel, form, folder)))
    model.program("softsoil", "drawbar", "--tire", name, "--tire-file", folder / "tires.xml", "--soil", wheel.soil,
                  "--load", wheel.load, "--slip", ",".join(f"{s / (1 - s):.6g}" for s in slips), "--speed", 0.1,
                  "--set", "grid_spacing=0.01", "--set", "volume_height=0.01", "--set", "volumes=20", "--no-picture",
                  "--out", folder / "bin")
    # Sinkage of the drum, of which the tests tell: the tips are deeper by the height of a grouser.
    return {s: {"drawbar pull": float(row["drawbar_pull"]), "torque": float(row["torque"]),
                "sinkage": float(row["sinkage"]) - wheel.height}
            for s, row in zip(slips, model.read_csv(folder / "bin" / "drawbar.csv"))}


def results(folder):
    """Wheel, form, quantity, unit, slip [-], measured and computed value of every number that was measured."""
    for wheel in WHEELS:
        tests = measured()[wheel.name]
        for form in wheel.forms:
            ours = driven(wheel, form, list(tests), folder)
            for quantity, unit in QUANTITIES.items():
                for slip, values in tests.items():
                    if values[quantity] is not None:
                        yield wheel, form, quantity, unit, slip, values[quantity], ours[slip][quantity]
