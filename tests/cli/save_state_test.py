"""softsoil run --save-state and --load-state: a run that goes on from a state has the same bits as one
that was not interrupted."""
import os
import pathlib
import signal
import struct
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree as ET

from program import BAD_INPUT, COARSE, FAILED, InAFolder, run, softsoil, summary_of

SOILS = pathlib.Path("models/soils/yolo_loam.xml")
END = 1.3         # [s]
BETWEEN = 0.234   # [s]  neither a soil update nor a row of wheels.csv
ON_A_ROW = 0.25   # [s]


def scene_in(folder, *changes):
    """A copy of the shipped scene with changes: pairs of old and new text."""
    text = pathlib.Path("models/scenes/hmmwv_flat.xml").read_text()
    vehicles = os.path.relpath("models/vehicles", folder)
    for old, new in (("../vehicles", vehicles), *changes):
        assert old in text, old
        text = text.replace(old, new)
    scene = folder / "scene.xml"
    scene.write_text(text)
    return scene


def loose_soil_in(folder):
    """A file with the soil loose_yolo_loam."""
    soil = ET.parse(SOILS).getroot().find("soil[@name='tilled_yolo_loam']")
    soil.set("name", "loose_yolo_loam")
    soil.find("compaction").set("initial_density", "950")
    file = folder / "soils.xml"
    file.write_text(f"<soils>{ET.tostring(soil, encoding='unicode')}</soils>")
    return file


def lines_from(file, start):
    """Header and rows of a table from that time on."""
    header, *rows = file.read_text().splitlines()
    return [header] + [row for row in rows if float(row.split(",")[0]) >= start - 1e-9]


class GoesOn(unittest.TestCase):
    """On loose soil, which compacts below the wheels."""

    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        cls.soils = loose_soil_in(cls.folder)
        (cls.folder / "controls.csv").write_text("time,drive,steer\n0,0,0\n1,6000,0.3\n")
        cls.whole = cls.drive("whole", 0, END, BETWEEN, ON_A_ROW)

    @classmethod
    def drive(cls, name, start, end, *saves, load=None, more=(), scene="hmmwv_flat"):
        """The folder of the results, with the states saved at 0 and the end, and at times more."""
        out = cls.folder / name
        saves = {start, *saves, end}
        contacts = [str(t) for t in (0.3, 1.0) if start <= t <= end]
        done = run(out, "--controls", cls.folder / "controls.csv", *COARSE, "--set",
                   f"soil_file={cls.soils}", "--set", "soil=loose_yolo_loam",
                   *(["--contact-times", ",".join(contacts)] if contacts else []),
                   *(["--load-state", load] if load else []),
                   *(f"--save-state={t}:{out}/{t}.state" for t in saves), *more,
                   seconds=end - start, scene=scene)
        assert done.returncode == 0, done.stderr
        assert done.stderr.count("\n") == 1, done.stderr  # which soil is under which wheels
        return out

    def assertSameFrom(self, start, whole, part):
        for name in ("wheels.csv", "contact.csv"):
            lines = lines_from(part / name, start)
            self.assertGreater(len(lines), 10)
            self.assertEqual(lines, lines_from(whole / name, start), name)
        for name in ("terrain.npy", f"{END}.state"):
            self.assertTrue((part / name).read_bytes() == (whole / name).read_bytes(), name)
        for key in ("wheels", "state_hash", "compaction_energy", "rut_volume", "displaced_volume",
                    "columns"):
            self.assertEqual(summary_of(part)[key], summary_of(whole)[key], key)
        self.assertGreater(summary_of(part)["compaction_energy"], 1)

    def assertGoesOn(self, name, more, scene="hmmwv_flat", loaded_with=None):
        whole = self.drive(name + "_whole", 0, END, BETWEEN, more=more, scene=scene)
        part = self.drive(name + "_part", BETWEEN, END, load=whole / f"{BETWEEN}.state",
                          more=loaded_with or more, scene=scene)
        self.assertSameFrom(BETWEEN, whole, part)
        return whole

    def test_from_a_time_between_soil_updates(self):
        state = self.whole / f"{BETWEEN}.state"
        part = self.drive("between", BETWEEN, END, load=state)
        self.assertSameFrom(BETWEEN, self.whole, part)
        self.assertGreater(lines_from(part / "wheels.csv", 0)[1], "0.25,", "no row of its own at T")
        summary = summary_of(part)
        self.assertEqual((summary["start_time"], summary["loaded_state"]), (BETWEEN, str(state)))
        self.assertAlmostEqual(summary["simulated_time"], END - BETWEEN)
        self.assertEqual((summary_of(self.whole)["start_time"],
                          summary_of(self.whole)["loaded_state"]), (0, ""))
        self.assertTrue((part / state.name).read_bytes() == state.read_bytes(), "saved again at once")

    def test_from_a_time_of_a_row(self):
        part = self.drive("on_a_row", ON_A_ROW, END, load=self.whole / f"{ON_A_ROW}.state")
        self.assertSameFrom(ON_A_ROW, self.whole, part)
        self.assertTrue(lines_from(part / "wheels.csv", 0)[1].startswith("0.25,"))

    def test_from_the_start(self):
        part = self.drive("start", 0, END, load=self.whole / "0.state")
        self.assertSameFrom(0, self.whole, part)

    def test_twice(self):
        first = self.drive("first", BETWEEN, 0.617, load=self.whole / f"{BETWEEN}.state")
        second = self.drive("second", 0.617, END, load=first / "0.617.state",
                            more=["--threads", 1])
        for name in ("terrain.npy", f"{END}.state"):
            self.assertTrue((second / name).read_bytes() == (self.whole / name).read_bytes(), name)
        self.assertEqual(lines_from(second / "wheels.csv", 0.617),
                         lines_from(self.whole / "wheels.csv", 0.617))

    def test_from_the_end_of_a_run_as_from_the_middle_of_one(self):
        part = self.drive("short", 0, BETWEEN)
        self.assertTrue((part / f"{BETWEEN}.state").read_bytes() ==
                        (self.whole / f"{BETWEEN}.state").read_bytes())

    def test_on_any_number_of_threads(self):
        two = self.assertGoesOn("threads", ["--threads", 2], loaded_with=["--threads", 1])
        self.assertSameFrom(0, self.whole, two)

    def test_with_the_soil_updated_in_place(self):
        sync = self.assertGoesOn("sync", ["--sync"])
        self.assertNotEqual(summary_of(sync)["state_hash"], summary_of(self.whole)["state_hash"])

    def test_under_rk4_and_with_the_mark_in_userdata(self):
        scene = scene_in(self.folder, ("Euler", "RK4"),
                         ("</mujoco>", '<size nuserdata="2"/></mujoco>'))
        self.assertGoesOn("rk4", [], scene=scene)

    def test_rows_have_no_influence(self):
        rare = self.drive("rare", 0, END, BETWEEN, more=["--interval", 10])
        for name in (f"{BETWEEN}.state", f"{END}.state"):
            self.assertTrue((rare / name).read_bytes() == (self.whole / name).read_bytes(), name)


class Refused(InAFolder):
    """Before anything is run or written."""

    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.state = pathlib.Path(holder.name) / "a.state"
        done = run(holder.name, *COARSE, "--save-state", f"0.05:{cls.state}", seconds=0.05)
        assert done.returncode == 0, done.stderr

    def assertRefused(self, arguments, *sentences, out="out", scene="hmmwv_flat"):
        with self.subTest(arguments=arguments):
            before = self.state.read_bytes(), sorted(self.folder.iterdir())
            done = run(self.folder / out, *arguments, scene=scene)
            self.assertFails(done, BAD_INPUT, "softsoil: ", *sentences)
            self.assertSaysOneThing(done)
            self.assertEqual((self.state.read_bytes(), sorted(self.folder.iterdir())), before)

    def test_time_outside_of_the_run(self):
        for t in ("-0.1", "0.201", "1e300"):
            self.assertRefused([f"--save-state={t}:{self.folder}/x"],
                               f"--save-state must be within the run, 0 to 0.2 s, got ")
        for option in (f"--save-state=0.049:{self.folder}/x", "--contact-times=0.26"):
            self.assertRefused([*COARSE, "--load-state", self.state, option],
                               "must be within the run, 0.05 to 0.25 s, got 0.")

    def test_what_is_no_time_and_file(self):
        for text in ("x", "0.1", "0.1:", ":x", "soon:x", "nan:x", "0.1 :x", "0x1:x"):
            self.assertRefused([f"--save-state={text}"],
                               f'--save-state must be T:FILE with T [s], such as 2.5:ruts.state, got "{text}"')

    def test_file_that_the_run_writes_twice(self):
        (self.folder / "link").symlink_to(self.folder)
        for other in ("x", "./x", "link/x", "../" + self.folder.name + "/x", "x.part"):
            self.assertRefused(["--save-state", f"0.1:{self.folder}/x", "--save-state",
                                f"0.2:{self.folder}/{other}"],
                               f"{other}: this run would write it twice")
        for name in ("wheels.csv", "summary.json", "contact.csv.part", "terrain.png"):
            self.assertRefused(["--save-state", f"0.1:{self.folder}/out/../out/{name}"],
                               f"{name}: this run would write it twice")

    def test_file_that_is_an_input(self):
        controls = self.write("c.csv", "time,drive\n0,0\n")
        scene = scene_in(self.folder)
        soils = loose_soil_in(self.folder)
        part = self.folder / "x.part"
        part.write_bytes(self.state.read_bytes())
        for file in (controls, scene):
            self.assertRefused(["--controls", controls, "--save-state", f"0.1:{file}"],
                               f"{file.name}: is an input", scene=scene)
        self.assertRefused([*COARSE, "--load-state", self.state, "--save-state",
                            f"0.1:{self.state}"], "a.state: is an input")
        self.assertRefused([*COARSE, "--load-state", part, "--save-state",
                            f"0.1:{self.folder}/x"], "x.part: is an input")
        self.assertRefused(["--set", f"soil_file={soils}", "--save-state", f"0.1:{soils}"],
                           "soils.xml: is there and is no state file: it would be lost")

    def test_result_that_is_the_loaded_state(self):
        (self.folder / "out").mkdir()
        state = self.folder / "out" / "summary.json"
        state.write_bytes(self.state.read_bytes())
        done = run(self.folder / "out", *COARSE, "--load-state", state)
        self.assertFails(done, BAD_INPUT, "summary.json: is an input")
        self.assertEqual(state.read_bytes(), self.state.read_bytes())

    def test_place_where_no_file_can_be(self):
        (self.folder / "full.part").mkdir()
        for file, sentence in (("no/x", "no/x: its folder is not there"),
                               ("out/no/x", "no/x: its folder is not there"),
                               (".", "is a folder"), ("", "is a folder"), ("out/", "is a folder"),
                               ("full", "full.part: is a folder"),
                               ("x" * 300, "cannot be written: File name too long")):
            self.assertRefused(["--save-state", f"0.1:{self.folder}/{file}"], sentence)
        for file in ("/dev/null", self.write("notes.txt", "softsoil")):
            self.assertRefused(["--save-state", f"0.1:{file}"],
                               "is there and is no state file: it would be lost")

    def test_state_of_something_else(self):
        load = ["--load-state", self.state]
        self.assertRefused(load, "a.state: the state is of another soil: grid_spacing is 0.025 here, "
                                 "there 0.05")
        for more, sentence in ((["--set", "soil=lete_sand"], "soil is lete_sand here, there "
                                                             "tilled_yolo_loam"),
                               (["--mode", "compaction"], "mode is compaction here, there flow"),
                               (["--soil-clock", 0.02], "clock is 0.02 here, there 0.01")):
            self.assertRefused([*load, *COARSE, *more], "a.state: the state is of another soil: ",
                               sentence)
        self.assertRefused([*load, *COARSE], "a.state: the state is of another soil: ",
                           scene="hmmwv_slope")
        self.assertRefused([*load, *COARSE, "--set", "tire=37x12.5R16.5_35psi"],
                           "a.state: the state is of another soil: ")
        scene = scene_in(self.folder, ("</worldbody>", '<body name="more"/></worldbody>'))
        self.assertRefused([*load, *COARSE], "a.state: the state is of another model", scene=scene)

    def test_file_that_is_no_state(self):
        whole = self.state.read_bytes()
        flipped = bytearray(whole)
        flipped[len(whole) // 2] ^= 1
        for name, content, sentence in (
                ("empty", b"", "is no file of softsoil_save()"),
                ("text", b"time,drive\n0,1\n", "is no file of softsoil_save()"),
                ("short", whole[:-1], "is damaged"), ("flipped", flipped, "is damaged"),
                ("newer", whole[:16] + struct.pack("<I", 99) + whole[20:], "has version 99")):
            (self.folder / name).write_bytes(content)
            self.assertRefused([*COARSE, "--load-state", self.folder / name], f"{name}: {sentence}")
        for path, sentence in ((self.folder / "none", "No such file"), (self.folder, "is a folder")):
            self.assertRefused([*COARSE, "--load-state", path], sentence)


class OnItsWay(InAFolder):
    def test_full_disk(self):
        (self.folder / "x.state.part").symlink_to("/dev/full")
        done = run(self.folder / "out", *COARSE, "--save-state", f"0.05:{self.folder}/x.state",
                   seconds=0.1)
        self.assertFails(done, FAILED, "x.state.part: cannot write: No space left on device")
        self.assertEqual(os.listdir(self.folder), ["out"])
        self.assertFalse((self.folder / "out" / "summary.json").exists())

    def test_killed_midway(self):
        """The states of an earlier run go, what is saved is complete, and no other file is there."""
        reached, writing, later = (self.folder / name for name in ("reached", "writing", "later"))
        later.write_bytes(b"softsoil state\n")
        pipe = self.folder / "writing.part"
        os.mkfifo(pipe)
        process = subprocess.Popen(
            ["softsoil", "run", "hmmwv_flat", "--time", "1000", "--out", self.folder / "out",
             *COARSE, "--save-state", f"0.05:{reached}", "--save-state", f"0.1:{writing}",
             "--save-state", f"900:{later}"], stdout=subprocess.DEVNULL)
        with open(pipe, "rb") as half:  # waits for the program to write
            self.assertEqual(len(half.read(100)), 100)
            process.send_signal(signal.SIGKILL)
            process.wait()
        self.assertEqual(sorted(os.listdir(self.folder)), ["out", "reached", "writing.part"])
        done = run(self.folder / "out", *COARSE, "--load-state", reached, seconds=0.05)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_older_state_is_replaced(self):
        sizes = []
        for seconds in (0.05, 0.1):
            done = run(self.folder / "out", *COARSE, "--save-state",
                       f"{seconds}:{self.folder}/out/x.state", seconds=seconds)
            self.assertEqual(done.returncode, 0, done.stderr)
            sizes.append((self.folder / "out" / "x.state").read_bytes())
        self.assertNotEqual(*sizes)

    def test_hash_is_told(self):
        done = run(self.folder / "out", *COARSE, seconds=0.05)
        self.assertIn("state hash " + summary_of(self.folder / "out")["state_hash"], done.stdout)
        self.assertRegex(summary_of(self.folder / "out")["state_hash"], "^[0-9a-f]{16}$")


if __name__ == "__main__":
    unittest.main()
