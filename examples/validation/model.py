"""What softsoil gives for the printed cases: runs its programs and reads their files."""
import csv
import json
import math
import os
import pathlib
import subprocess

from printed import HERE, LITERAL

INCH = 0.0254  # [m]
RADIUS = 0.91  # [m]  6.2.1: diameter 1.82 m of both tractor tires
WIDTH = {"18.4R38": 18.4 * INCH, "24.5R32": 24.5 * INCH}  # [m]  nominal section
# Greatest contact width on tilled loam [m], 6.2: the width of the rigid wheel of Wong and Reece.
CONTACT_WIDTH = {"18.4R38": 0.575, "24.5R32": 0.67}
SOILS = {"tilled": "tilled_yolo_loam", "firm": "firm_yolo_loam"}
GRID = 0.025  # [m]


def program(*arguments):
    """Standard output of a program; its messages are shown if it fails."""
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{arguments[0]} {arguments[1]} failed:\n{done.stderr}")
    return done.stdout


def read_csv(path):
    """Rows with the units taken off the names of the columns."""
    with open(path, newline="") as file:
        return [{name.split(" [")[0]: value for name, value in row.items()}
                for row in csv.DictReader(file)]


def model_values(*arguments):
    tool = pathlib.Path(os.environ["SOFTSOIL_BUILD"]) / "bin" / "model_values"
    return [float(word) for word in program(tool, *arguments).split()]


def tire_name(tire, pressure):
    return f"{tire}_{pressure:g}kPa"


def drawbar(folder, row, load, slips):
    """Runs the soil bin at slips [-] for the tire and soil of a printed row; the folder."""
    name = f"{tire_name(row.tire, row.pressure)}_{row.soil}_{load:g}kN"
    out = folder / name / "_".join(f"{slip:.4f}" for slip in slips)
    program("softsoil", "drawbar", "--tire", tire_name(row.tire, row.pressure), "--soil",
            SOILS[row.soil], "--load", 1000 * load, "--slip",
            ",".join(f"{slip:.6g}" for slip in slips), "--out", out, "--no-picture",
            "--set", f"grid_spacing={GRID}")
    return out


def drawbar_rows(folder, row, slips):
    """Rows of drawbar.csv by slip, and the freely rolling wheel."""
    out = drawbar(folder, row, row.load, slips)
    rolling = json.loads((out / "summary.json").read_text())["free_rolling"]
    return [{name: float(value) for name, value in r.items()}
            for r in read_csv(out / "drawbar.csv")], rolling


def contact_width(folder, row):
    """Width [m] of the contact of a tire that stands on the soil under 27 kN."""
    bin = drawbar(folder, row, 27, [0.1])
    program("softsoil", "run", bin / "soil_bin.xml", "--time", 2, "--out", bin / "standing",
            "--no-picture", "--set", f"grid_spacing={GRID}")
    lateral = [float(r["lateral"]) for r in read_csv(bin / "standing" / "contact.csv")]
    return max(lateral) - min(lateral) + GRID


def wong_reece(folder, row, reading):
    """Pull [kN] and torque [kN m] of a Wong-Reece row under a reading of its parameters."""
    out = folder / f"wong_reece_{row.tire}_{row.soil}_{row.load:g}_{row.slip:g}_{reading[:2]}"
    soil = SOILS[row.soil] if reading == LITERAL else f"{row.soil}_mean_plus_sd"
    files = [] if reading == LITERAL else ["--soil-file", HERE / "wong_reece_soils.xml"]
    # The SAE slip of 4.8 under the reading with SD; literally the printed slip is that of 2.18.
    definition = "wong-reece" if reading == LITERAL else "sae"
    program("softsoil", "wong-reece", "--tire", tire_name(row.tire, 85), "--soil", soil, *files,
            "--load", 1000 * row.load, "--width", CONTACT_WIDTH[row.tire], "--slip",
            row.slip / 100, "--slip-definition", definition, "--no-picture", "--out", out)
    result = read_csv(out / "wong_reece.csv")[0]
    return {"drawbar pull": float(result["drawbar_pull"]) / 1000,
            "torque": float(result["torque"]) / 1000}


def flat_plate(row, crown_radius):
    """Load [N] at a deflection of 0.1 m of a spring of Tables 6.1 to 6.3, printed in 1e5 Pa."""
    printed = [1e5 * float(word) for word in row.value.strip("[]").replace(",", " ").split()]
    places = {"linear": [0], "quadratic": [0, 1], "linear_sqrt": [0, 3], "sqrt": [3],
              "cubic": [0, 1, 2]}[row.spring]
    spring = [0.0] * 4  # linear, quadratic, cubic, root
    for place, coefficient in zip(places, printed):
        spring[place] = coefficient
    return model_values("flat_plate", RADIUS, crown_radius, WIDTH[row.tire], *spring, 0.1)[0]


def cylinder_load(row):
    """Load [N] at a deflection of 2 in of the cylinders of 4.2.1, printed in psi/in."""
    stiffness = row.number * 6894.757 / INCH
    return model_values("flat_plate", 37 * INCH / 2, math.inf, 12.5 * INCH, stiffness, 0, 0, 0,
                        2 * INCH)[0]


# Initial density, then density [kg/m^3] at a stress [Pa] of the virgin curve, C, R [kg/m^3].
VOLUMES = {"USCS CL": (1266, 1204, 98e3, 513.3, 20.28),  # 3.4
           "tilled": (1200.2, 1200, 95.93e3, 513.3, 20.28),  # 6.1.1
           "firm": (1504, 1200, 98.1e3, 492.1, 28.08)}  # 6.1.2


def soil_volume(soil, speed):
    """The quantities of Table 3.2 in its units."""
    gain, energy, power, density, stress = model_values("soil_volume", speed, *VOLUMES[soil])
    return {"delta rho": gain / 1000, "energy": energy / 1000, "peak power": power / 1000,
            "rho0 end": density / 1000, "sigma0 end": stress / 1000}
