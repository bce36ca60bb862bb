"""Pictures of the validation table."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from printed import LITERAL, PLUS_SD

MEASURED, THESIS, OURS = "#222222", "#c77b30", "#2a6fb0"


def label_bars(axes, names):
    axes.set_yticks(range(len(names)), names, fontsize=8)
    axes.invert_yaxis()
    axes.grid(axis="x", alpha=0.3)
    axes.spines[["top", "right"]].set_visible(False)


def draw_pulls(rows, axes):
    """Measured drawbar pulls beside both models, by falling slip."""
    rows = sorted((r for r in rows if r.kind == "experiment" and r.quantity == "drawbar pull"),
                  key=lambda r: -r.slip)
    for place, row in enumerate(rows):
        axes.plot([row.measured], [place], "|", color=MEASURED, markersize=18, markeredgewidth=2.5)
        if row.thesis is not None:
            axes.plot([row.thesis], [place], "s", color=THESIS, markersize=6)
        axes.plot([row.ours], [place], "o", color=OURS, markersize=7)
        if row.ours_rolling is not None:
            axes.plot([row.ours_rolling], [place], "o", color=OURS, markersize=7, fillstyle="none")
    label_bars(axes, [row.case for row in rows])
    axes.axvline(0, color="black", linewidth=0.6)
    axes.set_xlabel("drawbar pull [kN]")
    axes.set_title("Tractor tires on Yolo loam (Wulfsohn and Upadhyaya)", loc="left", fontsize=11)
    for marker, colour, fill, name in (
            ("|", MEASURED, "full", "measured, with lugs"), ("s", THESIS, "full", "thesis' model"),
            ("o", OURS, "full", "softsoil, slip against the unloaded radius"),
            ("o", OURS, "none", "softsoil, slip against the rolling radius")):
        axes.plot([], [], marker, color=colour, label=name, linestyle="none", markersize=9,
                  fillstyle=fill)
    axes.legend(frameon=False, loc="upper center", bbox_to_anchor=(0.3, -0.13), ncol=2, fontsize=9)


def draw_agreement(rows, axes, title, unit):
    """Ours against printed values on the line of equality."""
    most = max(max(r.thesis, r.ours) for r, _, _ in rows) * 1.08
    axes.fill_between([0, most], [0, 0.88 * most], [0, 1.12 * most], color="black", alpha=0.07,
                      label="12 %", linewidth=0)
    axes.plot([0, most], [0, most], color="black", linewidth=0.7)
    seen = set()
    for row, marker, name in rows:
        axes.plot(row.thesis, row.ours, marker, color=OURS, markersize=6,
                  fillstyle="none" if name.endswith(LITERAL) else "full",
                  label=None if name in seen else name)
        seen.add(name)
    axes.set(xlim=(0, most), ylim=(0, most), aspect="equal", xlabel=f"printed {unit}",
             ylabel=f"softsoil {unit}")
    axes.set_title(title, loc="left", fontsize=11)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=8, loc="upper left")


def draw_soil_volume(rows, axes):
    """Table 3.2 over speed: each quantity against its value at the lowest speed."""
    for marker, quantity in (("o", "delta rho"), ("s", "energy"), ("^", "peak power")):
        of = [r for r in rows if r.kind == "soil volume" and r.quantity == quantity]
        speeds = [r.speed for r in of]
        axes.plot(speeds, [r.thesis / of[0].thesis for r in of], color=MEASURED, linewidth=0.8)
        axes.plot(speeds, [r.ours / of[0].thesis for r in of], marker, color=OURS, label=quantity,
                  linestyle="none")
    axes.set(xlabel="speed [m/s]", ylabel="relative to the printed value at 0.5 m/s")
    axes.set_title("A soil volume under three load cycles (Table 3.2)", loc="left", fontsize=11)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=9)


def draw_rigid_wheels(rows, axes):
    """Quantities of every wheel over slip: a row of axes for a wheel, a column for a quantity."""
    wheels = list(dict.fromkeys(r.case.split(",")[0] for r in rows))
    for across, wheel in zip(axes, wheels):
        for place, quantity in zip(across, ("drawbar pull", "torque", "sinkage")):
            of = [r for r in rows if r.case.startswith(f"{wheel},") and r.quantity == quantity]
            place.set_title(f"{wheel}: {quantity}", loc="left", fontsize=9)
            place.spines[["top", "right"]].set_visible(False)
            if not of:
                place.set_axis_off()
                continue
            for form, line in (("", "o-"), ("grousers as lugs", "o-"), ("grousers as mesh", "s:")):
                so = [r for r in of if r.note == form]
                place.plot([r.slip for r in so], [r.ours for r in so], line, color=OURS, linewidth=0.8, markersize=4,
                           label=f"softsoil, {form}" if form else None)
            place.plot([r.slip for r in of], [r.measured for r in of], "|", color=MEASURED, markersize=14,
                       markeredgewidth=2, label="measured")
            place.set_ylabel(of[0].unit)
            place.set_ylim(min(0, place.get_ylim()[0]))
    for place in axes[-1]:
        place.set_xlabel("slip [%]")
    axes[1][0].legend(frameon=False, fontsize=8, loc="lower right")


def draw(rows, folder):
    figure, axes = plt.subplots(figsize=(9, 4.6), constrained_layout=True)
    draw_pulls(rows, axes)
    save(figure, folder / "drawbar_pull.png")

    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 5), constrained_layout=True)
    wong_reece = [r for r in rows if r.kind == "Wong-Reece"]
    for axes, quantity, unit in ((left, "drawbar pull", "[kN]"), (right, "torque", "[kN m]")):
        marked = [(r, "o" if "tilled" in r.case else "s",
                   f"{'tilled' if 'tilled' in r.case else 'firm'}, {r.note}")
                  for r in wong_reece if r.quantity == quantity
                  and r.note in (PLUS_SD, LITERAL)]
        draw_agreement(marked, axes, f"Wong-Reece: {quantity}", unit)
    save(figure, folder / "wong_reece.png")

    figure, axes = plt.subplots(5, 3, figsize=(10, 12), constrained_layout=True)
    draw_rigid_wheels([r for r in rows if r.kind == "rigid wheel"], axes)
    save(figure, folder / "rigid_wheels.png")

    figure, axes = plt.subplots(figsize=(7, 4.6), constrained_layout=True)
    draw_soil_volume(rows, axes)
    save(figure, folder / "soil_volume.png")


def save(figure, path):
    figure.savefig(path, dpi=140)
    plt.close(figure)
