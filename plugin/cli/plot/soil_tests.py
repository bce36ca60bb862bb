"""Draws soil tests against the laws fitted to them.

Usage: python3 soil_tests.py REPORT.json PICTURE.png

Reads the report of `softsoil soil` with plate-sinkage tests, shear tests or both.
"""
import json
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import picture_file

COLOURS = ["#7b3022", "#c8782a", "#3f7f8c", "#6a5a9e", "#4e8a3a", "#b03a6a"]
MARKERS = ["o", "s", "^", "D", "v", "P"]
LINE = {"linewidth": 1.8, "zorder": 2}
POINT = {"linestyle": "none", "markersize": 5, "markerfacecolor": "white", "markeredgewidth": 1.3,
         "zorder": 3, "clip_on": False}


def groups_of(column):
    """Each value of a column with the mask of its rows, a colour and a marker."""
    column = np.array(column)
    for number, value in enumerate(np.unique(column)):
        yield (value, column == value, COLOURS[number % len(COLOURS)],
               MARKERS[number % len(MARKERS)])


def with_interval(findings, parameter, factor, unit):
    """`12.3 ± 0.4 kPa`: as many digits as the interval has meaning."""
    finding = next(f for f in findings if f["parameter"] == parameter)
    value, interval = finding["value"] * factor, finding.get("confidence_95", 0) * factor
    if interval > 0:
        decimals = max(0, 1 - math.floor(math.log10(interval)))
        text = f"{value:.{decimals}f} ± {interval:.{decimals}f}"
    else:
        text = f"{value:.4g}"
    return text + (" " + unit if unit else "")


def spread(heights, gap):
    """Rising heights moved as little as needed to lie at least a gap apart."""
    heights = np.array(heights, dtype=float)
    for _ in range(200):
        for lower in range(len(heights) - 1):
            lacking = gap - (heights[lower + 1] - heights[lower])
            if lacking > 0:
                heights[lower] -= lacking / 2
                heights[lower + 1] += lacking / 2
    return heights


def label_ends(axes, ends, title):
    """Writes beside the end of each curve what it is; ends are (x, y, text, colour)."""
    ends = sorted(ends, key=lambda end: end[1])
    top = axes.get_ylim()[1]
    gap = 0.055 * top
    heights = spread([y for _, y, _, _ in ends], gap)
    right = max(x for x, *_ in ends)
    style = {"xytext": (9, 0), "textcoords": "offset points", "va": "center",
             "annotation_clip": False}
    for height, (x, _, text, colour) in zip(heights, ends):
        axes.annotate(text, (x, height), color=colour, fontsize=10, **style)
    axes.annotate(title, (right, heights[-1] + 1.3 * gap), color="#444444", fontsize=9, **style)
    axes.set_ylim(top=max(top, heights[-1] + 2 * gap))
    axes.set_xlim(right=1.25 * right)


def plate_pressure(plate, width, sinkage):
    """The fitted law [Pa]; Bekker or Reece."""
    if plate["form"] == "reece":
        modulus, depth = plate["cohesive"] + plate["frictional"] * width, sinkage / width
    else:
        modulus, depth = plate["cohesive"] / width + plate["frictional"], sinkage
    return modulus * depth ** plate["n"]


def plate_title(plate, findings):
    n = "$n$ " + with_interval(findings, "bearing n", 1, "")
    if any(f["parameter"] == "bearing k_e" for f in findings):
        modulus = with_interval(findings, "bearing k_e", 1e-3, "kN/m$^{n+2}$")
        return f"$p = k_e\\,z^n$\n$k_e$ {modulus}\n{n}"
    if plate["form"] == "reece":
        names = (("$k_1$ ", "bearing k_1", "kPa"), ("$k_2$ ", "bearing k_2", "kPa/m"))
        law = "$p = (k_1 + k_2 b)\\,(z/b)^n$"
    else:
        names = (("$k_c$ ", "bearing k_c", "kN/m$^{n+1}$"),
                 ("$k_\\phi$ ", "bearing k_phi", "kN/m$^{n+2}$"))
        law = "$p = (k_c/b + k_\\phi)\\,z^n$"
    moduli = [label + with_interval(findings, name, 1e-3, unit) for label, name, unit in names]
    return "\n".join([law, *moduli, n])


def draw_plates(axes, plate, findings):
    sinkage, pressure = np.array(plate["sinkage"]), np.array(plate["pressure"])
    ends = []
    for width, rows, colour, marker in groups_of(plate["width"]):
        z = np.linspace(0, sinkage[rows].max(), 200)
        axes.plot(100 * z, plate_pressure(plate, width, z) / 1e3, color=colour, **LINE)
        axes.plot(100 * sinkage[rows], pressure[rows] / 1e3, marker, color=colour, **POINT)
        ends.append((100 * z[-1], plate_pressure(plate, width, z[-1]) / 1e3,
                     f"{100 * width:.3g} cm", colour))
    axes.set(xlabel="sinkage [cm]", ylabel="pressure below the plate [kPa]")
    free = "upper left" if plate["n"] > 0.9 else "lower right"  # above or below the curves
    finish(axes, "Plate sinkage", plate_title(plate, findings), free)
    label_ends(axes, ends, "plate width")


def draw_slip(axes, shear):
    slip, stress = np.array(shear["displacement"]), np.array(shear["shear_stress"])
    ends = []
    for sigma, rows, colour, marker in groups_of(shear["normal_stress"]):
        j = np.linspace(0, slip[rows].max(), 200)
        strength = shear["cohesion"] + sigma * np.tan(shear["friction_angle"])
        tau = strength * -np.expm1(-j / shear["modulus"]) / 1e3
        axes.plot(100 * j, tau, color=colour, **LINE)
        axes.plot(100 * slip[rows], stress[rows] / 1e3, marker, color=colour, **POINT)
        ends.append((100 * j[-1], tau[-1], f"{sigma / 1e3:.3g} kPa", colour))
    axes.set(xlabel="slip displacement [cm]", ylabel="shear stress [kPa]")
    finish(axes, "Shear")
    label_ends(axes, ends, "normal stress")


def draw_strength(axes, shear, findings):
    """The line of Mohr-Coulomb and the greatest shear stress of each test."""
    normal, stress = np.array(shear["normal_stress"]), np.array(shear["shear_stress"])
    line = np.array([0, 1.15 * normal.max()])
    axes.plot(line / 1e3, (shear["cohesion"] + line * np.tan(shear["friction_angle"])) / 1e3,
              color="#444444", **LINE)
    for sigma, rows, colour, marker in groups_of(normal):
        axes.plot(sigma / 1e3, stress[rows].max() / 1e3, marker, color=colour, **POINT)
    axes.set(xlabel="normal stress [kPa]", ylabel="shear strength [kPa]")
    text = ["line: fitted strength", "points: greatest stress measured",
            "$c$ " + with_interval(findings, "shear cohesion", 1e-3, "kPa"),
            "$\\phi$ " + with_interval(findings, "shear friction_angle_deg", 1, "deg"),
            "$K$ " + with_interval(findings, "shear modulus", 1e2, "cm")]
    finish(axes, "Strength", "\n".join(text), "lower right")


def finish(axes, title, text="", place="lower right"):
    axes.set_title(title, loc="left", fontsize=12)
    axes.set_xlim(left=0)
    axes.set_ylim(0, 1.08 * axes.dataLim.y1)
    axes.grid(color="black", alpha=0.08, linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    if text:
        x, align = (0.97, "right") if place.endswith("right") else (0.03, "left")
        y, edge = (0.04, "bottom") if place.startswith("lower") else (0.97, "top")
        axes.text(x, y, text, transform=axes.transAxes, ha=align, va=edge, fontsize=9,
                  linespacing=1.5)


def draw(report):
    has_plate, has_shear = "plate" in report, "shear" in report
    columns = has_plate + 2 * has_shear
    figure, axes = plt.subplots(1, columns, figsize=(4.8 * columns, 4.4), squeeze=False,
                                layout="constrained")
    panels = list(axes[0])
    if has_plate:
        draw_plates(panels.pop(0), report["plate"], report["findings"])
    if has_shear:
        draw_slip(panels.pop(0), report["shear"])
        draw_strength(panels.pop(0), report["shear"], report["findings"])
    name = report["name"] or "soil"
    figure.suptitle(f"{name}: tests (points) and fit (lines), ± 95 %", x=0.01, ha="left",
                    fontsize=13)
    return figure


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1]) as file:
        report = json.load(file)
    picture_file.save(draw(report), sys.argv[2], dpi=160)


if __name__ == "__main__":
    main()
