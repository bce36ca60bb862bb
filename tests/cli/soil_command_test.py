"""softsoil soil: the table, the entry that the catalogue reads back, and what is refused."""
import json
import math
import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

from program import BAD_INPUT, InAFolder, run, softsoil, summary_of

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
PLATE, SHEAR = DATA / "plate_sinkage.csv", DATA / "shear_test.csv"
TESTED = ["--plate", PLATE, "--shear", SHEAR]
PLATE_HEADER = "width [mm], sinkage [mm], pressure [kPa]\n"
SHEAR_HEADER = "normal_stress [kPa], displacement [mm], shear_stress [kPa]\n"

# With everything that a soil may have but moisture.
RICH = """<soils><soil name="rich">
<bearing form="reece" k_1="2e4" k_2="4e5" n="1.1" source="s"/>
<unloading k_0="0" A_u="503e6" source="s"/>
<shear form="humped" residual="0.3" cohesion="3300" friction_angle_deg="33.7" modulus="0.025"
       source="s"/>
<compaction index="410" reference_density="1290" reference_stress="98e3" initial_density="1300"
            rebound_index="20" compression_time="0.2" rebound_time="0.02" source="s"/>
<layers top="0.2 0.4" initial_density="1400 1500" source="s"/>
<stress concentration_factor="5" source="s"/>
<max_stress c_1="0.43" c_2="0.32" source="s"/>
</soil></soils>
"""


def table_of(done):
    """parameter -> its row of the printed table, in words."""
    rows = [line.split() for line in done.stdout.splitlines() if line]
    return {" ".join(row[:2]): row[2:] for row in rows if len(row) > 2}


class Soil(InAFolder):
    def identify(self, *arguments):
        done = softsoil("soil", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def test_table_of_a_class(self):
        done = self.identify("--uscs", "CL")
        rows = table_of(done)
        self.assertIn("composition: USCS CL, 47.1 % clay, 24 % silt, 28.9 % sand", done.stdout)
        self.assertEqual(rows["shear cohesion"][:4], ["26910", "Pa", "fitted", "relation"])
        self.assertEqual(rows["compaction index"][:2], ["513.3", "kg/m^3"])
        self.assertEqual(rows["compaction rebound_index"][:4],
                         ["20.28", "kg/m^3", "printed", "relation"])
        self.assertIn("shear cohesion: underdetermined", done.stdout)
        self.assertIn("CH, ML, CL, MH; clay 13.6 to 73.3 %", done.stdout)
        self.assertIn("<stress> needs --like SOIL", done.stdout)

    def test_warns_outside_the_range_of_a_relation(self):
        done = self.identify("--clay", 10, "--silt", 25, "--sand", 65)
        self.assertIn("compaction index: clay 10 % lies outside 13.6 to 73.3", done.stdout)

    def test_measured_density_gives_the_preconsolidation_stress(self):
        rows = table_of(self.identify("--uscs", "CL", "--bulk-density", 1200.2))
        self.assertAlmostEqual(float(rows["preconsolidation stress"][0]), 95930, delta=200)

    def test_fits_find_the_soil_that_the_examples_were_made_from(self):
        rows = table_of(self.identify(*TESTED))
        for name, truth in {"bearing k_c": 74600, "bearing k_phi": 2.08e6, "bearing n": 1.1,
                            "shear cohesion": 3300, "shear friction_angle_deg": 33.7,
                            "shear modulus": 0.02}.items():
            value, plus_minus, interval = rows[name][:3]
            self.assertEqual(plus_minus, "+-")
            self.assertLess(abs(float(value) - truth), float(interval), name)
            self.assertLess(abs(float(value) - truth), 0.05 * truth, name)

    def test_reece_form_and_one_plate(self):
        rows = table_of(self.identify("--plate", PLATE, "--reece"))
        self.assertEqual(rows["bearing k_1"][3], "Pa")
        one = self.write("one.csv", PLATE_HEADER + "100,10,20\n100,20,42\n100,30,60\n100,40,83\n")
        done = self.identify("--plate", one)
        self.assertIn("bearing k_e", table_of(done))
        self.assertIn("one width does not tell k_c from k_phi", done.stdout)
        rows = table_of(self.identify("--plate", one, "--frictional"))
        self.assertEqual(rows["bearing k_c"][0], "0")

    def test_entry_runs_in_a_scene(self):
        out = self.folder / "my.xml"
        done = self.identify(*TESTED, "--uscs", "CL", "--bulk-density", 1250, "--saturation", 0.5,
                             "--reference-saturation", 0.4, "--like", "tilled_yolo_loam",
                             "--name", "my_soil", "--description", "a < b & c", "--out", out)
        self.assertIn(f"written: {out}", done.stdout)
        self.assertEqual({path.name for path in self.folder.iterdir()},
                         {"my.xml", "my.png", "my.json"})
        soil = ElementTree.parse(out).getroot().find("soil")
        self.assertEqual(soil.get("description"), "a < b & c")
        for group in soil:
            self.assertTrue(group.get("source"), group.tag)
        self.assertIn("plate_sinkage.csv: 78 rows", soil.find("bearing").get("source"))
        self.assertEqual(soil.find("stress").get("source"),
                         "not identified: as of tilled_yolo_loam")
        self.assertAlmostEqual(float(soil.find("moisture").get("slope")), 476.7, delta=0.1)
        report = json.loads((self.folder / "my.json").read_text())
        self.assertEqual(len(report["plate"]["fitted"]), 78)
        results = self.folder / "run"
        ran = run(results, "--no-picture", "--set", f"soil_file={out}", "--set", "soil=my_soil",
                  seconds=0.02)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(summary_of(results)["soil"], "my_soil")

    def test_every_soil_of_the_catalogue_can_be_the_rest(self):
        names = [line.split()[0] for line in softsoil("list", "soils").stdout.splitlines()[1:]]
        for name in names:
            out = self.folder / f"{name}_2.xml"
            self.identify("--like", name, "--name", f"{name}_2", "--out", out)
            ran = run(self.folder / "run", "--no-picture", "--set", f"soil_file={out}", "--set",
                      f"soil={name}_2", seconds=0.002)
            self.assertEqual(ran.returncode, 0, ran.stderr)

    def test_tells_all_that_the_entry_has_of_another_soil(self):
        like = self.write("rich.xml", RICH)
        out = self.folder / "x.xml"
        done = self.identify("--like", "rich", "--soil-file", like, "--name", "x", "--out", out)
        rows = table_of(done)
        report = {row["parameter"]: row
                  for row in json.loads((self.folder / "x.json").read_text())["findings"]}
        for parameter, value in {"shear residual": 0.3, "unloading A_u": 5.03e8,
                                 "layers initial_density below 0.2 m": 1400,
                                 "max_stress c_1": 0.43}.items():
            self.assertEqual(report[parameter]["value"], value)
            self.assertEqual(report[parameter]["how"], "as of another")
            self.assertEqual(report[parameter]["made_from"], "rich")
        self.assertEqual(rows["max_stress c_2"][-1], "rich")
        numbers = [number for group in ElementTree.parse(out).getroot().find("soil")
                   for name, text in group.items() if name not in ("source", "form", "top")
                   for number in text.split()]
        self.assertEqual(len(numbers), len(set(report) - {"preconsolidation stress"}))

    def test_soil_like_one_of_a_file_runs(self):
        mine, out = self.folder / "mine.xml", self.folder / "wet.xml"
        self.identify("--like", "lete_sand", "--name", "mine", "--out", mine)
        self.identify("--like", "mine", "--soil-file", mine, "--uscs", "CL", "--name", "wet",
                      "--out", out)
        self.assertIn("times as of mine", out.read_text())
        ran = run(self.folder / "run", "--no-picture", "--set", f"soil_file={mine},{out}", "--set",
                  "soil=wet", seconds=0.002)
        self.assertEqual(ran.returncode, 0, ran.stderr)

    def test_clay_has_no_frictional_modulus(self):
        rows = "".join(f"{width},{z},{pressure * math.sqrt(z / width):.3f}\n"
                       for width, pressure in ((50, 50), (300, 49)) for z in range(0, 160, 10))
        plate, out = self.write("clay.csv", PLATE_HEADER + rows), self.folder / "clay.xml"
        done = self.identify("--plate", plate, "--reece", "--like", "heavy_clay_25", "--name",
                             "clay", "--out", out)
        self.assertEqual(table_of(done)["bearing k_2"][0], "0")
        self.assertIn("bearing k_2: the readings ask for -4002; fitted again without", done.stdout)
        bearing = ElementTree.parse(out).getroot().find("soil/bearing")
        self.assertEqual(bearing.get("k_2"), "0")
        ran = run(self.folder / "run", "--no-picture", "--set", f"soil_file={out}", "--set",
                  "soil=clay", seconds=0.002)
        self.assertEqual(ran.returncode, 0, ran.stderr)

    def test_picture_alone(self):
        picture = self.folder / "tests.png"
        self.identify("--shear", SHEAR, "--picture", picture)
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertFalse(list(self.folder.glob("*.part")))

    def test_overwrites_only_when_told(self):
        out = self.write("my.xml", "mine")
        arguments = ["soil", "--like", "lete_sand", "--name", "x", "--out", out]
        self.assertFails(softsoil(*arguments), BAD_INPUT, "my.xml: is there already; --force")
        self.assertEqual(out.read_text(), "mine")
        self.identify(*arguments[1:], "--force")
        self.assertIn("<soils>", out.read_text())


class Refusals(InAFolder):
    def assertRefused(self, arguments, sentence):
        """With an entry to write, which is not: no file appears."""
        before = set(self.folder.iterdir())
        with self.subTest(sentence=sentence):
            done = softsoil("soil", *arguments, "--name", "x", "--out", self.folder / "x.xml")
            self.assertEqual(done.stderr, f"softsoil: {sentence}\n")
            self.assertEqual(done.returncode, BAD_INPUT)
            self.assertEqual(done.stdout, "")
            self.assertEqual(set(self.folder.iterdir()), before)

    def test_shares(self):
        def shares(clay, silt, sand):
            return ["--like", "lete_sand", "--clay", clay, "--silt", silt, "--sand", sand]

        self.assertRefused(shares(40, 30, 29),
                           "clay, silt and sand must add up to 100 % (within 0.2 %), got 99 %")
        self.assertRefused(shares(-10, 50, 60), "clay must be >= 0 %, got -10 %")
        self.assertRefused(shares("nan", 50, 60), "clay must be >= 0 %, got nan %")
        self.assertRefused(shares(80, 5, 15), "clay must be 6.9 to 73.3 %, the range of the soils "
                           "behind the relations (Madsen 2014: CH, ML, SW, CL, MH), got 80 %; test "
                           "the soil, or take a similar one")
        self.assertRefused(["--clay", 40], "--clay needs --silt, --sand too")
        self.assertRefused(["--uscs", "CL", *shares(40, 30, 30)],
                           "--uscs and --clay, --silt, --sand exclude one another")

    def test_classes_and_states(self):
        self.assertRefused(["--uscs", "GW"], 'unknown USCS class "GW"; there are data for: CH, ML, '
                           "SW, CL, MH")
        moist = ["--saturation", 0.5, "--reference-saturation", 0.4]
        self.assertRefused(["--uscs", "SW", *moist], "moisture slope: there are no data for coarse "
                           "soils (sand > 50 %), got 90.8 % sand; leave the saturation out")
        self.assertRefused(["--uscs", "CL", *moist[:2]],
                           "--saturation needs --reference-saturation too")
        self.assertRefused(["--bulk-density", 1400], "a bulk density alone gives no virgin curve: "
                           "the composition of the soil or a similar soil must be known too")

    def test_plate_files(self):
        def refused(rows, sentence, header=PLATE_HEADER):
            path = self.write("plate.csv", header + rows)
            self.assertRefused(["--like", "lete_sand", "--plate", path], f"{path}:{sentence}")

        good = "50,10,20\n50,20,42\n50,30,60\n"
        refused("50,10,20\n50,20,42\n", "3: there must be at least 3 rows, got 2")
        refused(good, "1: column pressure is missing", "width [mm], sinkage [mm]\n")
        refused(good, '1: column width must state its unit as width [unit], one of m, cm, mm, in, '
                'got ""', "width, sinkage [mm], pressure [kPa]\n")
        refused(good + "50,40,-60\n", "5: pressure must be >= 0 Pa, got -60000 Pa")
        refused(good + "50,40,40\n", "5: pressure must not fall while the plate of width 0.05 m "
                "sinks, got 40000 Pa after 60000 Pa")
        refused(good + "50,25,70\n", "5: sinkage of the plate of width 0.05 m must rise from row "
                "to row, got 0.025 m after 0.03 m")

        few = "4: the plate of width 0.05 m must have at least 3 rows with sinkage and pressure, got"
        refused("50,1,0\n50,2,0\n50,3,40\n", f"{few} 1")

    def test_plates_that_determine_nothing(self):
        """Pressures that scatter more than they rise."""
        rows = "50,10,40\n50,20,60\n50,30,56\n300,10,55\n300,20,50\n300,30,60\n"
        plate = self.write("plate.csv", PLATE_HEADER + rows)
        self.assertRefused(["--like", "lete_sand", "--plate", plate], "the readings do not "
                           "determine bearing k_phi, bearing n: the 95 % interval holds 0; --out "
                           "needs readings with less scatter, deeper or farther, or of more "
                           "different plates or normal stresses")
        done = softsoil("soil", "--plate", plate)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("bearing n: the readings hardly determine it", done.stdout)

    def test_names_of_files_that_are_too_long(self):
        name = "a" * 300 + ".csv"
        for option in ("--plate", "--shear"):
            self.assertRefused([option, name], f"{name}: cannot read: File name too long")

    def test_shear_files(self):
        def refused(rows, sentence):
            path = self.write("shear.csv", SHEAR_HEADER + rows)
            self.assertRefused(["--like", "lete_sand", "--shear", path], f"{path}:{sentence}")

        good = "10,5,4\n10,10,6\n10,20,7\n"
        refused(good, " one normal stress, 10000 Pa, does not determine cohesion and friction "
                "angle; test a second one")
        refused(good + "20,5,-4\n", "5: shear_stress must be >= 0 Pa, got -4000 Pa")
        refused(good + "20,5,4\n", "5: the test at normal stress 20000 Pa must have at least 3 "
                "rows, got 1")

    def test_entries_that_are_incomplete(self):
        self.assertRefused(["--uscs", "CL"], "the entry is incomplete: <bearing> needs --plate "
                           "FILE or --like SOIL; <compaction> needs --like SOIL, for its times; "
                           "<stress> needs --like SOIL")
        one = self.write("one.csv", PLATE_HEADER + "100,10,20\n100,20,42\n100,30,60\n")
        self.assertRefused(["--plate", one, "--like", "lete_sand"], "the entry is incomplete: "
                           "<bearing> needs a second plate width, or --frictional to take k_c = 0")

    def test_options(self):
        def refused(*arguments, sentence):
            self.assertFails(softsoil("soil", *arguments), BAD_INPUT, sentence)

        like = ["--like", "lete_sand"]
        out = self.folder / "x.xml"
        refused(sentence="nothing is known of the soil")
        refused("--like", "cheese", sentence='unknown soil "cheese"; known are: ')
        refused(*like, "--out", out, sentence="--out needs --name")
        refused(*like, "--name", "a b", "--out", out, sentence="--name must hold no blank")
        refused(*like, "--name", "dry_sand", "--out", out, sentence="taken already")
        refused(*like, "--name", "x", "--out", self.folder / "x", sentence="--out must end in .xml")
        refused(*like, "--picture", self.folder / "x.png", sentence="--picture needs --plate")
        refused(*like, "--reece", sentence="give --plate too")
        mine = self.write("mine.xml", RICH)
        refused("--uscs", "CL", "--soil-file", mine, sentence="--soil-file holds soils for --like")
        refused("--like", "poor", "--soil-file", mine, sentence='unknown soil "poor"; known are: ')
        refused("--like", "rich", "--soil-file", self.folder / "none.xml",
                sentence="none.xml: there is no such file")
        refused("--plate", PLATE, "--frictional", sentence="for plates of one width, got 3 widths")
        refused(*like, "--clay", "much", sentence="much")


if __name__ == "__main__":
    unittest.main()
