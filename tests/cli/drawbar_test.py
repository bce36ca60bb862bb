"""softsoil drawbar: the soil bin at many slips, spins, and under a torque."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

from program import BAD_INPUT, softsoil, summary_of
from soil_bin_runs import GRID, LOAD, ROOT, SOIL, TIRE, Bin, drawbar, numbers, table

RADIUS, GRAVITY = 0.91, 9.81
TORQUE = 3000  # [N m]
CURVE = ["drawbar.csv", "centre_line.csv", "summary.json", "soil_bin.xml"]
UNITS = {"slip": "-", "rolling_slip": "-", "thrust": "N", "motion_resistance": "N",
         "drawbar_pull": "N", "torque": "N m", "power": "W", "sinkage": "m", "rut_depth": "m",
         "compaction_volume": "m^3", "load": "N", "steady": "-"}


class Curve(unittest.TestCase):
    """Many questions to one curve, on one thread and on two."""
    SLIPS = [0.45, -0.2, 0.05, 0.25]

    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folders = [pathlib.Path(holder.name) / threads for threads in "12"]
        for threads, folder in zip("12", cls.folders):
            done = drawbar(folder, "--slip", ",".join(map(str, cls.SLIPS)), "--threads", threads)
            assert done.returncode == 0, done.stderr
        cls.rows = numbers(folder / "drawbar.csv")

    def test_has_the_columns_and_files_it_promises(self):
        header = table(self.folders[0] / "drawbar.csv")[0].keys()
        for name, unit in UNITS.items():
            self.assertIn(f"{name} [{unit}]", header)
        self.assertEqual(sorted(os.listdir(self.folders[0])), sorted(CURVE))

    def test_may_have_its_slips_in_any_order(self):
        self.assertEqual([round(row["slip"], 5) for row in self.rows], self.SLIPS)

    def test_rises_with_slip(self):
        rows = sorted(self.rows, key=lambda row: row["slip"])
        for key in ("drawbar_pull", "torque"):
            values = [row[key] for row in rows]
            self.assertEqual(values, sorted(values), key)
        powers = [row["power"] for row in rows if row["slip"] > 0]
        self.assertEqual(powers, sorted(powers))

    def test_sums_agree(self):
        for row in self.rows:
            self.assertAlmostEqual(row["thrust"] - row["motion_resistance"],
                                   row["drawbar_pull"], delta=0.01)
            self.assertAlmostEqual(row["torque"] * row["spin"], row["power"], delta=0.01)
            self.assertAlmostEqual(row["load"] / LOAD, 1, delta=0.01)
            self.assertAlmostEqual((RADIUS * row["spin"] - row["forward_speed"])
                                   / row["forward_speed"], row["slip"], delta=1e-5)
            self.assertEqual(row["steady"], 1)

    def test_of_a_braked_wheel_pulls_back(self):
        [braked] = [row for row in self.rows if row["slip"] < 0]
        self.assertLess(braked["torque"], 0)
        self.assertLess(braked["drawbar_pull"], -braked["motion_resistance"])

    def test_has_the_same_bits_on_any_number_of_threads(self):
        for name in CURVE:
            one, two = ((folder / name).read_bytes() for folder in self.folders)
            self.assertEqual(one, two, name)


class PrescribedSlip(Bin):
    def test_rolling_slip_is_none_where_the_wheel_rolls_freely(self):
        self.rows("--slip", "0.1")
        free = json.loads((self.folder / "summary.json").read_text())["free_rolling"]
        self.assertAlmostEqual(free["rolling_radius"] * (1 + free["slip"]), RADIUS, delta=1e-6)
        self.assertGreater(free["slip"], 0)  # an elastic wheel rolls on less than its radius
        row = self.rows("--slip", free["slip"])[0]
        self.assertAlmostEqual(row["rolling_slip"], 0, delta=1e-4)
        self.assertLess(abs(row["torque"]), 0.01 * LOAD * RADIUS)
        self.assertLess(row["drawbar_pull"], 0)

    def test_a_heavier_load_sinks_deeper_and_pulls_more(self):
        light = self.rows("--slip", "0.2")[0]
        heavy = self.rows("--slip", "0.2", load=1.5 * LOAD)[0]
        for key in ("sinkage", "compaction_volume", "motion_resistance", "drawbar_pull"):
            self.assertGreater(heavy[key], light[key], key)
        self.assertAlmostEqual(heavy["load"] / (1.5 * LOAD), 1, delta=0.01)

    def test_a_small_wheel_has_a_rig_of_its_size(self):
        row = self.rows("--slip", "0.2", tire="37x12.5R16.5_15psi", load=6000)[0]
        self.assertAlmostEqual(row["load"] / 6000, 1, delta=0.01)
        self.assertEqual(row["steady"], 1)


class SoilWithoutStrength(Bin):
    """A wheel on it slides where it is pulled and spins where it is driven."""

    def slides(self, *more):
        text = (ROOT / "models" / "soils" / "yolo_loam.xml").read_text()
        soil = ET.fromstring(text).find("soil[@name='tilled_yolo_loam']")
        soil.set("name", "slurry")
        shear = soil.find("shear")
        shear.set("cohesion", "0")
        shear.set("friction_angle_deg", "0")
        soils = self.write("slurry.xml", f"<soils>{ET.tostring(soil, encoding='unicode')}</soils>")
        done = self.drawbar("--soil-file", soils, *more, soil="slurry", out=self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        return done, summary_of(self.folder / "out"), table(self.folder / "out" / "drawbar.csv")

    def test_has_no_rolling_radius_and_no_rolling_slip(self):
        for drive in (["--slip", "0.1"], ["--mode", "spin", "--spin", "1"]):
            done, summary, [row] = self.slides(*drive)
            self.assertEqual(row["rolling_slip [-]"], "")
            self.assertNotIn("rolling_radius", summary["free_rolling"])
            self.assertLess(summary["free_rolling"]["slip"], -0.9)
            self.assertIn("does not roll freely", done.stdout)
            self.assertIn("rolling_slip is left empty", done.stderr)

    def test_is_drawn_all_the_same(self):
        done, _, _ = self.slides("--slip", "0.1")
        arguments = [sys.executable, "plugin/cli/plot/drawbar.py", self.folder / "out"]
        subprocess.run(arguments, check=True, cwd=ROOT)
        self.assertTrue((self.folder / "out" / "drawbar.png").exists())


class CentreLine(Bin):
    def test_pressure_and_shear_along_the_contact(self):
        peak = {row["slip"]: row["peak_pressure"] for row in self.rows("--slip", "0.3")}
        points = numbers(self.folder / "centre_line.csv")
        self.assertEqual({point["slip"] for point in points}, {0.3})
        angles = [point["angle"] for point in points]
        self.assertEqual(angles, sorted(angles))
        self.assertLess(angles[0], -5)
        self.assertGreater(angles[-1], -angles[0])  # it sinks in ahead, behind it leaves a rut
        self.assertAlmostEqual(max(point["pressure"] for point in points) / max(peak.values()), 1,
                               delta=0.05)
        pressed = [point for point in points if point["pressure"] > 0]  # not on loose soil
        self.assertGreater(len(pressed), 0.8 * len(points))
        for point in pressed:
            self.assertGreater(point["shear"], 0)  # all of it drives at this slip
            self.assertLess(point["shear"], point["pressure"])


class PrescribedSpin(Bin):
    def test_the_rig_comes_to_roll_without_pull(self):
        rows = self.rows("--mode", "spin", "--spin", "1,3")
        for row, spin in zip(rows, (1, 3)):
            self.assertAlmostEqual(row["spin"], spin, delta=1e-5)
            self.assertGreater(row["forward_speed"], 0.9 * RADIUS * spin)
            self.assertLess(row["forward_speed"], RADIUS * spin)
            self.assertLess(abs(row["drawbar_pull"]), 0.002 * LOAD)
            self.assertGreater(row["torque"], 0)


class PrescribedTorque(Bin):
    def history(self, *more):
        done = self.drawbar("--mode", "torque", "--torque", TORQUE, "--time", 2, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return table(self.folder / "history.csv")

    def test_the_rig_speeds_up_as_its_pull_says(self):
        rows = self.history()
        speed = {float(row["time [s]"]): float(row["forward_speed [m/s]"]) for row in rows}
        self.assertEqual([min(speed), max(speed)], [0, 2])
        self.assertGreater(speed[2], speed[1])
        pulls = [float(row["drawbar_pull [N]"]) for row in rows if float(row["time [s]"]) > 1]
        pull = sum(pulls) / len(pulls)
        self.assertAlmostEqual((speed[2] - speed[1]) * LOAD / GRAVITY / pull, 1, delta=0.05)

    def test_the_centre_line_is_told_at_the_times_asked_for(self):
        self.history("--contact-times", "0.5,2")
        points = numbers(self.folder / "centre_line.csv")
        self.assertEqual({point["time"] for point in points}, {0.5, 2})

    def test_same_bits_on_any_number_of_soil_threads(self):
        files = ["history.csv", "centre_line.csv", "summary.json"]
        results = []
        for threads in (1, 2):
            self.history("--bumps", "0.05,1", "--threads", threads)
            results.append([(self.folder / name).read_bytes() for name in files])
        self.assertEqual(*results)

    def test_ground_may_be_high_and_low(self):
        starts = []
        for bumps in ("2,5", "2,5,2", "5,10,3", "5,10,6"):
            rows = self.history("--bumps", bumps)
            self.assertTrue(summary_of(self.folder)["settled"])
            starts.append(float(rows[0]["z [m]"]))
            self.assertAlmostEqual(float(rows[0]["x [m]"]), 0, delta=0.01)
        self.assertLess(min(starts), -0.9)  # in a valley, with its axle below the height 0
        self.assertGreater(max(starts), 2)

    def test_a_load_that_the_soil_cannot_carry_leaves_no_result(self):
        done = self.drawbar("--mode", "torque", "--torque", TORQUE, "--time", 1, load=500000)
        self.assertFails(done, BAD_INPUT, "--load: the soil cannot carry 500000 N")
        self.assertEqual(os.listdir(self.folder), [])

    def test_bumps_shake_the_wheel(self):
        def swing(rows):
            heights = [float(row["z [m]"]) for row in rows if float(row["time [s]"]) > 1]
            return max(heights) - min(heights)

        flat, bumpy = swing(self.history()), swing(self.history("--bumps", "0.1,1,7"))
        self.assertLess(flat, 0.002)
        self.assertGreater(bumpy, 0.004)


class RigidWheel(Bin):
    def test_stands_beside_the_tire(self):
        self.rows("--slip", "-0.1,0.1,0.3", "--wong-reece")
        slips = [float(row["slip [-]"]) for row in table(self.folder / "wong_reece.csv")]
        self.assertEqual([round(slip, 9) for slip in slips], [0.1, 0.3])  # driven ones alone
        self.assertTrue((self.folder / "rim_stress.csv").exists())

    def test_is_that_of_softsoil_wong_reece(self):
        options = ["--slip", "0.3,1.5", "--c1", "0.4", "--c2", "0.3"]
        self.rows(*options, "--wong-reece", "--wong-reece-width", "0.575")
        alone = self.folder / "alone"
        done = softsoil("wong-reece", "--tire", TIRE, "--soil", SOIL, "--load", LOAD, *options,
                        "--width", "0.575", "--no-picture", "--out", alone)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("wong_reece.csv", "rim_stress.csv", "wong_reece.json"):
            self.assertEqual((self.folder / name).read_bytes(), (alone / name).read_bytes(), name)


class Pictures(Bin):
    def drawn(self, *more):
        done = softsoil("drawbar", "--tire", TIRE, "--soil", SOIL, "--load", LOAD, "--out",
                        self.folder, *GRID, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {name for name in os.listdir(self.folder) if name.endswith(".png")}

    def test_curves_and_stress_are_drawn(self):
        self.assertEqual(self.drawn("--slip", "0.1,0.3", "--wong-reece"),
                         {"drawbar.png", "centre_line.png"})

    def test_one_slip_makes_a_picture_too(self):
        self.assertEqual(self.drawn("--slip", "0.1"), {"drawbar.png", "centre_line.png"})

    def test_a_history_is_drawn(self):
        self.assertEqual(self.drawn("--mode", "torque", "--torque", 1600, "--time", 0.5),
                         {"history.png", "centre_line.png"})


if __name__ == "__main__":
    unittest.main()
