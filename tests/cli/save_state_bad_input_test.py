"""softsoil run --save-state and --load-state refuse bad input before anything is run or written."""
import pathlib
import struct
import tempfile
import unittest

from program import BAD_INPUT, COARSE, InAFolder, loose_soil_in, run, scene_in


class Refused(InAFolder):
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
                               "--save-state must be within the run, 0 to 0.2 s, got ")
        for option in (f"--save-state=0.049:{self.folder}/x", "--contact-times=0.26"):
            self.assertRefused([*COARSE, "--load-state", self.state, option],
                               "must be within the run, 0.05 to 0.25 s, got 0.")

    def test_what_is_no_time_and_file(self):
        for text in ("x", "0.1", "0.1:", ":x", "soon:x", "nan:x", "0.1 :x", "0x1:x"):
            self.assertRefused([f"--save-state={text}"],
                               "--save-state must be T:FILE with T [s], such as 2.5:ruts.state, "
                               f'got "{text}"')

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
        self.assertRefused(load, "a.state: the state is of another soil: grid_spacing is 0.025 "
                                 "here, there 0.05")
        for more, sentence in ((["--set", "soil=lete_sand"], "soil is lete_sand here, there "
                                                             "tilled_yolo_loam"),
                               (["--mode", "compaction"], "mode is compaction here, there flow"),
                               (["--soil-clock", 0.02], "clock is 0.02 here, there 0.01"),
                               (["--sync"], "sync is 1 here, there 0"),
                               (["--set", "stress=auto"], "stress is auto here, there direct")):
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
        for path, sentence in ((self.folder / "none", "No such file"),
                               (self.folder, "is a folder")):
            self.assertRefused([*COARSE, "--load-state", path], sentence)


if __name__ == "__main__":
    unittest.main()
