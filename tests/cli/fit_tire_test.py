"""softsoil fit-tire: from load-deflection data to a tire that a scene can use."""
import json
import math
import pathlib
import unittest
import xml.etree.ElementTree as ET

from program import BAD_INPUT, InAFolder, run, softsoil

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
LOADS = DATA / "18.4R38_load_deflection.csv"
WIDTHS = DATA / "18.4R38_contact_width.csv"
SIZE = ["--radius", 0.91, "--width", 0.467]
TORUS = [*SIZE, "--contact-width", WIDTHS]
ENTRY = ["--name", "mine", "--load", 18000, "--like", "18.4R38_85kPa"]
# The load in kN of a linear cylinder, r 0.47 m, w 0.32 m, 2 MPa/m, and none of one pressure.
ONE_TEST = "deflection [cm], load [kN]\n1, 0.79\n3, 4.0\n5, 8.5\n7, 13.9\n9, 20.1\n"


class FitTire(InAFolder):
    def fit(self, *arguments):
        return softsoil("fit-tire", *arguments)

    def assertFits(self, *arguments):
        done = self.fit(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def assertRefused(self, arguments, *sentences):
        with self.subTest(arguments=arguments):
            before = set(self.folder.iterdir())
            done = self.fit(*arguments)
            self.assertFails(done, BAD_INPUT, "softsoil: ", *sentences)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertEqual(set(self.folder.iterdir()), before)

    def test_tells_the_error_of_each_form_and_marks_the_best(self):
        said = self.assertFits(LOADS, *TORUS)
        self.assertIn("torus: radius 0.91 m, width 0.467 m, crown radius 0.66", said)
        for pressure in ("85 kPa, 13 rows", "125 kPa, 13 rows"):
            self.assertIn(pressure, said)
        forms = [line[2:].split("  ")[0] for line in said.splitlines() if " p0 " in line]
        self.assertEqual(forms, 2 * ["linear", "quadratic", "linear + root", "root", "cubic"])
        best = [line for line in said.splitlines() if line.startswith("* ") and " p0 " in line]
        self.assertEqual([line.split()[1] for line in best], ["root", "root"])

    def test_finds_the_tire_that_made_the_example(self):
        out = self.folder / "mine.xml"
        self.assertFits(LOADS, *TORUS, *ENTRY, "--out", out)
        soft, hard = ET.parse(out).getroot()
        self.assertEqual([soft.get("name"), hard.get("name")], ["mine_85kPa", "mine_125kPa"])
        self.assertAlmostEqual(float(soft.find("shape").get("crown_radius")) / 0.661, 1, delta=0.05)
        self.assertAlmostEqual(float(soft.find("spring").get("root")) / 3.469e5, 1, delta=0.05)
        self.assertAlmostEqual(float(hard.find("spring").get("root")) / 5.345e5, 1, delta=0.05)
        self.assertEqual(soft.find("inflation").get("pressure"), "85000")
        self.assertEqual(soft.find("friction").get("coefficient"), "0.65")
        self.assertIn("zeta 0.05, 18 kN", soft.find("spring").get("source"))

    def test_writes_entries_that_a_scene_can_use(self):
        out = self.folder / "mine.xml"
        self.assertFits(LOADS, *TORUS, *ENTRY, "--out", out)
        results = self.folder / "run"
        done = run(results, "--no-picture", "--set", f"tire_file={out}", "--set",
                   "tire=mine@100kPa", scene="soil_bin")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("mine@100kPa", done.stderr)

    def test_fits_a_cylinder_at_an_unknown_pressure(self):
        data, out = self.write("one.csv", ONE_TEST), self.folder / "one.xml"
        said = self.assertFits(data, "--radius", 0.47, "--width", 0.32, "--cylinder", "--spring",
                               "linear", "--name", "one", "--damping", 5000, "--friction", 0.6,
                               "--out", out)
        self.assertIn("unknown pressure, 5 rows", said)
        tire, = ET.parse(out).getroot()
        self.assertEqual(tire.get("name"), "one")
        self.assertEqual(tire.find("shape").get("type"), "cylinder")
        self.assertAlmostEqual(float(tire.find("spring").get("linear")) / 2e6, 1, delta=0.05)
        self.assertEqual(tire.find("spring").get("damping"), "5000")
        self.assertIsNone(tire.find("inflation"))

    def test_draws_a_picture_and_keeps_its_numbers(self):
        picture, numbers = self.folder / "fit.png", self.folder / "fit.json"
        said = self.assertFits(LOADS, *TORUS, "--picture", picture)
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
        self.assertGreater(picture.stat().st_size, 20000)
        self.assertEqual(len(json.loads(numbers.read_text())["tests"]), 2)
        self.assertEqual(set(self.folder.iterdir()), {picture, numbers})
        self.assertEqual(said.splitlines()[-2:], [f"written: {picture}", f"written: {numbers}"])

    def test_draws_beside_the_entry_unless_told_not_to(self):
        out = self.folder / "mine.xml"
        self.assertFits(LOADS, *TORUS, *ENTRY, "--out", out)
        self.assertEqual(self.names(), {"mine.xml", "mine.png", "mine.json"})
        self.assertFits(LOADS, *TORUS, *ENTRY, "--out", self.folder / "2/mine.xml", "--no-picture")
        self.assertEqual({path.name for path in (self.folder / "2").iterdir()},
                         {"mine.xml", "mine.json"})

    def names(self):
        return {path.name for path in self.folder.iterdir()}

    def test_overwrites_only_by_force(self):
        out = self.folder / "mine.xml"
        for name in ("mine.xml", "mine.png", "mine.json", "mine.png.json"):
            self.write(name, "precious")
            if name == "mine.png.json":
                continue
            self.assertRefused([LOADS, *TORUS, *ENTRY, "--out", out],
                               ": is there already; --force overwrites it")
            self.assertEqual((self.folder / name).read_text(), "precious")
            (self.folder / name).unlink()
        (self.folder / "a.png").mkdir()
        self.assertRefused([LOADS, *TORUS, "--picture", self.folder / "a.png"], "is a folder")
        self.write("mine.xml", "precious")
        self.assertFits(LOADS, *TORUS, *ENTRY, "--out", out, "--force")
        self.assertIn("<tires>", out.read_text())
        self.assertEqual((self.folder / "mine.png.json").read_text(), "precious")

    def test_fits_the_crown_below_the_width_of_the_tread(self):
        widths = "deflection [m], contact_width [m]\n" + "".join(
            f"{z}, {min(0.467, 2 * math.sqrt(z * (2 * 0.661 - z)))}\n"
            for z in (0.02, 0.025, 0.03, 0.035, 0.04, 0.05, 0.06, 0.08, 0.1))
        said = self.assertFits(LOADS, *SIZE, "--contact-width", self.write("w.csv", widths))
        self.assertIn("crown radius 0.661 m", said)
        self.assertIn("which grow to 0.467 m and no more", said)
        flat = self.write("flat.csv", "deflection [m], contact_width [m]\n" + "".join(
            f"{z}, 0.467\n" for z in (0.05, 0.06, 0.08, 0.1)))
        self.assertRefused([LOADS, *SIZE, "--contact-width", flat],
                           "flat.csv: the contact widths do not tell the crown radius")

    def test_takes_the_friction_of_a_tire_in_another_file(self):
        other, out = self.folder / "other.xml", self.folder / "mine.xml"
        self.assertFits(LOADS, *TORUS, *ENTRY[:1], "other", *ENTRY[2:4], "--friction", 0.55,
                        "--out", other, "--no-picture")
        like = ["--load", 18000, "--like", "other_85kPa", "--tire-file", other]
        self.assertFits(LOADS, *TORUS, "--name", "mine", *like, "--out", out)
        friction = ET.parse(out).getroot()[0].find("friction")
        self.assertEqual(friction.get("coefficient"), "0.55")
        self.assertEqual(friction.get("source"), "that of other_85kPa")
        third = ["--out", self.folder / "third.xml"]
        self.assertRefused([LOADS, *TORUS, "--name", "other", *like, *third], "taken already")
        self.assertRefused([LOADS, *TORUS, "--name", "third", *like[:-2], *third], "unknown tire")

    def test_writes_no_entry_that_a_scene_would_refuse(self):
        out = ["--out", self.folder / "mine.xml"]
        for name in ("a b", "c=d", "18.4R38", "18.4R38_85kPa", "auto"):
            self.assertRefused([LOADS, *TORUS, *out, "--name", name, *ENTRY[2:]], "--name")
        near = LOADS.read_text().replace("\n125,", "\n85.05,")
        self.assertRefused([self.write("near.csv", near), *TORUS, *out, *ENTRY],
                           "mine.xml:", '"mine_85kPa" is the tire of the family "mine" at 85.05')

    def test_python_without_matplotlib(self):
        self.write("matplotlib.py", "raise ImportError")
        done = softsoil("fit-tire", LOADS, *TORUS, *ENTRY, "--out", self.folder / "mine.xml",
                        environment={"PYTHONPATH": str(self.folder)})
        self.assertFails(done, BAD_INPUT, "matplotlib")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["matplotlib.py"])

    def test_bad_options(self):
        self.assertRefused([LOADS, *SIZE], "one of --crown-radius, --contact-width and --cylinder")
        self.assertRefused([LOADS, *TORUS, "--cylinder"], "must be given, got 2")
        self.assertRefused([LOADS, "--radius", -1, "--width", 1, "--cylinder"],
                           "--radius must be 0.001 to 100 m, got -1")
        self.assertRefused([LOADS, *SIZE, "--crown-radius", 0.2],
                           "crown_radius must be >= width / 2 = 0.2335 m, got 0.2")
        self.assertRefused([LOADS, *TORUS, "--spring", "rubber"], "linear + root", '"rubber"')

    def test_an_entry_needs_what_the_data_do_not_tell(self):
        out = ["--out", self.folder / "mine.xml"]
        self.assertRefused([LOADS, *TORUS, *out], "--out needs --name")
        self.assertRefused([LOADS, *TORUS, *out, "--name", "a@b"], "must hold no blank, comma")
        self.assertRefused([LOADS, *TORUS, *out, "--name", "mine"], "--damping, or --load")
        self.assertRefused([LOADS, *TORUS, *out, "--name", "mine", "--damping", 0], "--friction")
        self.assertRefused([LOADS, *TORUS, *out, *ENTRY[:-1], "moon"],
                           '--like: unknown tire "moon"')
        self.assertRefused([LOADS, *TORUS, *out, *ENTRY, "--friction", 0.5], "--friction", "--like")
        self.assertRefused([LOADS, *TORUS, *out, *ENTRY[:3], 1e9, *ENTRY[4:]],
                           "the tire does not carry")

    def test_bad_data(self):
        def refused(text, *sentences):
            out = self.folder / "mine.xml"
            data = self.write("t.csv", text)
            self.assertRefused([data, *TORUS, *ENTRY, "--out", out], *sentences)

        refused(ONE_TEST.replace(" [kN]", ""), "t.csv:1: column load must state its unit")
        refused(ONE_TEST.replace("5, 8.5", "3, 8.5"), "t.csv:4: deflection must rise")
        refused(ONE_TEST.replace("5, 8.5", "5, 1"), "t.csv:4: load must rise with deflection")
        refused(ONE_TEST.replace("5, 8.5", "5, -1"), "t.csv:4: load must be >= 0 N, got -1000 N")
        refused(ONE_TEST.replace("1, 0.79", "0, 0.79"), "t.csv:2: load must be 0 N at deflection 0")
        refused(ONE_TEST.replace("9, 20", "99, 20"), "t.csv:6: deflection must be < the tire's")
        refused("\n".join(ONE_TEST.splitlines()[:4]), "t.csv: there must be at least 4 rows")
        self.assertRefused([self.folder / "no.csv", *TORUS], "no.csv: cannot read")
        widths = self.write("w.csv", "deflection [mm], contact_width [cm]\n20, 10\n40, 14\n")
        self.assertRefused([LOADS, *SIZE, "--contact-width", widths], "crown_radius must be >=")


if __name__ == "__main__":
    unittest.main()
