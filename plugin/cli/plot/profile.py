"""Draws where the time of a run went.

Usage: python3 profile.py FOLDER

Reads the profile in summary.json of `softsoil run --profile --out FOLDER` and writes profile.png.
"""
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import picture_file

COLOURS = {"mujoco": "#6b6b6b", "contact": "#b4552d", "flow": "#e0a458", "waiting": "#d9d2c5", "results": "#a8bcc9",
           "stress": "#2f6690", "compaction": "#3f7d3a"}
NAMES = {"mujoco": "MuJoCo", "waiting": "waiting for the soil update"}
DARK = ("mujoco", "contact", "stress", "compaction")
LEAST_NAMED = 0.08  # [-]  of the axis: narrower parts have no number


def draw(profile, summary):
    figure, axes = plt.subplots(figsize=(8, 2.4), layout="constrained")
    rows = {"run": profile["run"], "soil update": profile["soil_update"]}
    longest = max(sum(parts.values()) for parts in rows.values())
    for place, parts in enumerate(rows.values()):
        left = 0
        for name, time in parts.items():
            axes.barh(place, time, left=left, height=0.6, color=COLOURS[name], label=NAMES.get(name, name))
            if time > LEAST_NAMED * longest:
                axes.text(left + time / 2, place, f"{time:.2g} s", ha="center", va="center", fontsize=9,
                          color="white" if name in DARK else "black")
            left += time
    axes.set_yticks(range(len(rows)), rows)
    axes.invert_yaxis()
    axes.set_xlabel("wall time [s]")
    axes.set_title(f"{summary['simulated_time']:g} s simulated in {summary['wall_time']:.1f} s", loc="left",
                   fontsize=11, fontweight="bold")
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=9, ncols=4, loc="upper center", bbox_to_anchor=(0.5, -0.3))
    return figure


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    summary = json.loads((folder / "summary.json").read_text())
    picture_file.save(draw(summary["profile"], summary), folder / "profile.png", dpi=120)


if __name__ == "__main__":
    main()
