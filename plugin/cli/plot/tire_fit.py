"""Draws load-deflection data of a tire on a flat plate against the fitted springs.

Usage: python3 tire_fit.py FITS.json PICTURE.png

One panel per inflation pressure: the loads above, the errors of the fits below.
"""
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import picture_file

COLOURS = {"linear": "#4477aa", "quadratic": "#66ccee", "linear + root": "#aa3377",
           "root": "#228833", "cubic": "#ccbb44"}  # told apart by the colour-blind too
WIDTH, HEIGHT = 5.2, 5.6  # [in] of a panel
KILO = 1e-3
CENTI = 1e2


def draw_loads(axes, test):
    axes.plot(CENTI * np.array(test["deflection"]), KILO * np.array(test["load"]), "o",
              color="black", markersize=5, markerfacecolor="none", label="measured", zorder=3)
    for alike in alike_fits(test["fits"]):
        fit = alike[0]
        axes.plot(CENTI * np.array(fit["deflection"]), KILO * np.array(fit["load"]),
                  label=label_of(alike), **style_of(fit))
    axes.set_ylabel("load [kN]")
    axes.set_title(test["name"], fontsize=11, loc="left")
    axes.legend(frameon=False, fontsize=9, loc="upper left")


def draw_errors(axes, test):
    """Fit minus measurement, at the rows."""
    z, load = np.array(test["deflection"]), np.array(test["load"])
    for fit, *_ in alike_fits(test["fits"]):
        error = np.interp(z, fit["deflection"], fit["load"]) - load
        axes.plot(CENTI * z, KILO * error, marker=".", markersize=4, **style_of(fit))
    axes.axhline(0, color="black", linewidth=0.8, zorder=1)
    axes.set(xlabel="deflection [cm]", ylabel="fit - measured [kN]")


def alike_fits(fits):
    """Lists of fits that are the same spring, as a term was lost; the best is first in its list."""
    lists = []
    for fit in fits:
        same = [one for one in lists if np.allclose(one[0]["load"], fit["load"], rtol=1e-6)]
        if same:
            same[0].append(fit)
        else:
            lists.append([fit])
    return [sorted(one, key=lambda fit: not fit["best"]) for one in lists]


def style_of(fit):
    best = fit["best"]
    return {"color": COLOURS[fit["form"]], "linewidth": 2.4 if best else 1.1,
            "zorder": 2.5 if best else 2, "linestyle": "-" if best else "--"}


def label_of(alike):
    names = ", ".join(fit["form"] for fit in alike)
    rms = alike[0]["rms"]
    digits = f"{rms:,.0f}" if rms >= 10 else f"{rms:.2g}"
    return f"{names}: rms {digits} N{'  (best)' if alike[0]['best'] else ''}"


def draw(fits):
    tests = fits["tests"]
    figure, axes = plt.subplots(2, len(tests), sharex="col", sharey="row", squeeze=False,
                                figsize=(WIDTH * len(tests) + 0.4, HEIGHT),
                                height_ratios=[2.4, 1], layout="constrained")
    for column, test in enumerate(tests):
        draw_loads(axes[0, column], test)
        draw_errors(axes[1, column], test)
    for panel in axes.flat:
        panel.grid(color="black", alpha=0.08, linewidth=0.6)
        panel.spines[["top", "right"]].set_visible(False)
    for panel in axes[:, 1:].flat:
        panel.set_ylabel("")
    for panel in axes[0]:
        panel.set_ylim(bottom=0)
    for panel in axes[1]:
        panel.set_xlim(left=0)
    figure.suptitle(f"{fits['title']}: load on a flat plate", fontsize=13, x=0.01, ha="left")
    return figure


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    picture_file.save(draw(json.loads(pathlib.Path(sys.argv[1]).read_text())), sys.argv[2], dpi=160)


if __name__ == "__main__":
    main()
