"""softsoil wong-reece: what it writes and prints, and what it refuses."""
import csv
import json
import os
import pathlib
import unittest

import matplotlib.image
import numpy as np

from program import BAD_INPUT, InAFolder, softsoil

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = ["rim_stress.csv", "wong_reece.csv", "wong_reece.json", "wong_reece.png"]
WHEEL = ["--tire", "18.4R38_85kPa", "--soil", "tilled_yolo_loam", "--load", 18000]


def table(path):
    """Column -> values; texts in the column mode."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {key: [row[key] if key == "mode" else float(row[key]) for row in rows]
            for key in rows[0]}


class WongReece(InAFolder):
    def solve(self, *options, wheel=WHEEL):
        out = self.folder / "out"
        done = softsoil("wong-reece", *wheel, *options, "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done, out

    def test_driven_and_towed(self):
        done, out = self.solve("--slip", "0.1:0.7:0.2", "--towed")
        self.assertEqual(sorted(os.listdir(out)), FILES)
        forces = table(out / "wong_reece.csv")
        self.assertEqual(forces["mode"], ["towed"] + 4 * ["driven"])
        np.testing.assert_allclose(forces["slip [-]"][1:], [0.1, 0.3, 0.5, 0.7])
        slip = np.array(forces["slip [-]"])
        np.testing.assert_allclose(forces["slip_i [-]"], slip / (1 + slip), rtol=1e-8)
        np.testing.assert_allclose(forces["load [N]"], 18000)
        np.testing.assert_allclose(
            np.subtract(forces["thrust [N]"], forces["motion_resistance [N]"]),
            forces["drawbar_pull [N]"], rtol=1e-6)
        np.testing.assert_allclose(
            forces["sinkage [m]"],
            0.91 * (1 - np.cos(np.radians(forces["entry_angle [deg]"]))), rtol=1e-7)
        self.assertLess(forces["slip [-]"][0], 0)
        self.assertAlmostEqual(forces["torque [N m]"][0], 0, places=5)
        for word in ["18.4R38_85kPa", "tilled_yolo_loam", "drawbar pull [N]", "towed", "driven",
                     f"{forces['drawbar_pull [N]'][-1]:.1f}"]:
            self.assertIn(word, done.stdout)

    def test_stress_along_the_rim(self):
        _, out = self.solve("--slip", "0.1,0.7", "--towed", "--no-picture")
        forces, rim = table(out / "wong_reece.csv"), table(out / "rim_stress.csv")
        for row, slip in enumerate(forces["slip [-]"]):
            here = np.array(rim["slip [-]"]) == slip
            angle, pressure, shear = (np.array(rim[name])[here] for name in
                                      ("angle [deg]", "pressure [Pa]", "shear [Pa]"))
            self.assertEqual(angle[0], 0)
            self.assertEqual(angle[-1], forces["entry_angle [deg]"][row])
            self.assertEqual((pressure[-1], shear[-1]), (0, 0))
            peak = angle[np.argmax(pressure)]
            self.assertAlmostEqual(peak, forces["max_stress_angle [deg]"][row], delta=angle[1])
            torque = 0.91 ** 2 * 0.467 * np.trapz(shear, np.radians(angle))
            self.assertAlmostEqual(torque, forces["torque [N m]"][row], delta=0.002 * 18000)

    def test_picture(self):
        _, out = self.solve("--slip", "0.1:0.7:0.1")
        curves = matplotlib.image.imread(out / "wong_reece.png")
        self.assertGreater(min(curves.shape[:2]), 800)
        self.assertGreater(curves[:, :, :3].std(), 0.05)
        self.solve("--towed")
        self.assertLess(matplotlib.image.imread(out / "wong_reece.png").shape[0], curves.shape[0])
        self.solve("--towed", "--no-picture")  # the old one does not stay
        self.assertEqual(sorted(os.listdir(out)), FILES[:-1])

    def test_slip_by_wong_and_reece(self):
        _, out = self.solve("--slip", 0.5, "--slip-definition", "wong-reece", "--no-picture")
        forces = table(out / "wong_reece.csv")
        self.assertEqual(forces["slip_i [-]"], [0.5])
        self.assertEqual(forces["slip [-]"], [1.0])

    def test_slip_beyond_one(self):
        _, out = self.solve("--slip", "0.5,1.5,9", "--no-picture")
        forces = table(out / "wong_reece.csv")
        np.testing.assert_allclose(forces["slip_i [-]"], [1 / 3, 0.6, 0.9])
        self.assertEqual(forces["sinkage [m]"], sorted(forces["sinkage [m]"]))

    def test_options_override_tire_and_soil(self):
        def inputs(*options):
            _, out = self.solve("--slip", 0.1, "--no-picture", *options)
            return json.loads((out / "wong_reece.json").read_text())

        catalogue = inputs()
        self.assertEqual(catalogue["width"], 0.467)
        self.assertAlmostEqual(catalogue["bearing_modulus"], 6800 / 0.467 + 1134000)
        self.assertEqual((catalogue["c_1"], catalogue["c_2"]), (0.43, 0.32))
        given = inputs("--width", 0.575, "--c1", 0.3, "--c2", 0.2)
        self.assertEqual(given["width"], 0.575)
        self.assertAlmostEqual(given["bearing_modulus"], 6800 / 0.575 + 1134000)
        self.assertEqual((given["c_1"], given["c_2"]), (0.3, 0.2))

    def test_more_tires_and_soils(self):
        def copy(kind, source, old, new):
            text = (ROOT / "models" / kind / source).read_text()
            return self.write(source, text.replace(f'="{old}', f'="{new}'))

        tires = copy("tires", "wrangler.xml", "37x", "my_37x")
        self.assertIn("my_37x12.5R16.5_15psi", tires.read_text())
        self.solve("--slip", 0.1, "--no-picture", "--tire-file", tires,
                   wheel=["--tire", "my_37x12.5R16.5_15psi", *WHEEL[2:4], "--load", 5000])


class BadInput(InAFolder):
    def assertRefused(self, options, *sentences, wheel=WHEEL):
        with self.subTest(options=options, wheel=wheel):
            out = self.folder / "out"
            done = softsoil("wong-reece", *wheel, *options, "--out", out)
            self.assertFails(done, BAD_INPUT, "softsoil: ", *sentences)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertFalse(out.exists(), "refused only after the folder was made")

    def test_names(self):
        slip = ["--slip", 0.1]
        self.assertRefused(slip, 'unknown tire "moon"', "18.4R38_85kPa",
                           wheel=["--tire", "moon", *WHEEL[2:]])
        self.assertRefused(slip, 'unknown soil "cheese"', "tilled_yolo_loam",
                           wheel=[*WHEEL[:2], "--soil", "cheese", *WHEEL[4:]])
        self.assertRefused([*slip, "--soil-file", "/nowhere.xml"], "/nowhere.xml")

    def test_load(self):
        def refused(load, *sentences, options=("--slip", "0.1,0.2")):
            self.assertRefused(options, *sentences, wheel=[*WHEEL[:4], f"--load={load}"])

        refused(0, "--load must be > 0 N, got 0")
        refused(-3, "--load must be > 0 N, got -3")
        refused("nan", "--load must be > 0 N, got nan")
        refused("heavy", "heavy")
        refused(1e7, "slip ratio 0.1: load must be < ",
                " N, which the soil carries at an entry angle of 89 deg, got ")
        refused(1e7, "towed: load must be < ", options=["--towed"])

    def test_slip(self):
        self.assertRefused(["--slip", "10:70:10"],
                           "--slip must be 0 to 9, got 10; it is a ratio, 0.1 for 10 %")
        self.assertRefused(["--slip=-0.1"], "--slip must be 0 to 9, got -0.1")
        self.assertRefused(["--slip", "0.1:0.7"],
                           '--slip: a range must be first:last:step, got "0.1:0.7"')
        self.assertRefused(["--slip", "0.7:0.1:0.1"], "--slip: a range must not end below")
        self.assertRefused(["--slip", "some"], '--slip: must be numbers', '"some"')
        self.assertRefused([], "--slip for a driven wheel or --towed is required")
        self.assertRefused(["--slip", 0.1, "--slip-definition", "mine"], "mine", "sae")
        self.assertRefused(["--slip", 1, "--slip-definition", "wong-reece"],
                           "--slip must be 0 to 0.9, got 1")

    def test_width_and_place_of_the_greatest_stress(self):
        self.assertRefused(["--slip", 0.1, "--width", 0], "--width must be > 0 m, got 0")
        self.assertRefused(["--slip", 0.1, "--c1", 0.4], "--c1 and --c2 must be given together")
        self.assertRefused(["--slip", "0.1,0.8", "--c1", 0.9, "--c2", 0.3], "slip ratio 0.8: ",
                           "c_1 + c_2 i must be > 0 and < 1")
        sand = [*WHEEL[:2], "--soil", "lete_sand", *WHEEL[4:]]
        self.assertRefused(["--slip", 0.1], 'soil "lete_sand" has no <max_stress',
                           "give --c1 and --c2", wheel=sand)
        out = self.folder / "towed"  # needs none
        done = softsoil("wong-reece", *sand, "--towed", "--no-picture", "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_python_without_matplotlib(self):
        self.write("matplotlib.py", "raise ImportError")
        out = self.folder / "out"
        done = softsoil("wong-reece", *WHEEL, "--slip", 0.1, "--out", out,
                        environment={"PYTHONPATH": str(self.folder)})
        self.assertFails(done, BAD_INPUT, "matplotlib", "--no-picture")
        self.assertFalse(out.exists())

    def test_folder_that_cannot_be_written(self):
        done = softsoil("wong-reece", *WHEEL, "--slip", 0.1, "--out", self.write("file", ""))
        self.assertFails(done, BAD_INPUT, "cannot write into this folder")


if __name__ == "__main__":
    unittest.main()
