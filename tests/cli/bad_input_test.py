"""softsoil run refuses bad input before it runs or writes anything."""
import unittest

from program import BAD_INPUT, InAFolder, run, softsoil


class BadInput(InAFolder):
    def assertRefused(self, arguments, *sentences):
        with self.subTest(arguments=arguments):
            out = self.folder / "out"
            done = softsoil("run", *arguments, "--out", out)
            self.assertFails(done, BAD_INPUT, "softsoil: ", *sentences)
            self.assertSaysOneThing(done)
            self.assertFalse(out.exists(), "refused only after the folder was made")

    def test_options(self):
        scene = "hmmwv_flat"
        self.assertRefused([scene, "--time", -1], "--time must be > 0 s, got -1")
        self.assertRefused([scene, "--time", 0], "--time must be > 0 s, got 0")
        self.assertRefused([scene, "--time", "nan"], "--time must be > 0 s, got nan")
        self.assertRefused([scene, "--time", "forty"], "forty")
        self.assertRefused([scene], "--time is required")
        self.assertRefused([scene, "--time", 1, "--interval", 0], "--interval must be > 0 s, got 0")
        for times in ("0.5,2", "-0.1", "nan", "soon"):
            sentence = "must be within the run, 0 to 1 s, got " if times != "soon" else "soon"
            self.assertRefused([scene, "--time", 1, "--contact-times=" + times],
                               "--contact-times", sentence)
        self.assertRefused([scene, "--time", 1, "--mode", "rock"], "rock", "flow", "compaction")
        self.assertRefused([scene, "--time", 1, "--colour", "red"], "--colour")
        self.assertRefused([scene, "--time", 1, "--controls", ""],
                           "an argument is empty: the one after --controls")
        self.assertRefused([scene, "--time", 1, "--set", "soil"], "KEY=VALUE", '"soil"')
        self.assertRefused([scene, "--time", 1, "--set", "soil=a b"], "KEY=VALUE", '"soil=a b"')

    def test_settings(self):
        scene = "hmmwv_flat"
        self.assertRefused([scene, "--time", 1, "--threads", -1], "threads", "-1")
        self.assertRefused([scene, "--time", 1, "--soil-clock", 0], "clock", "got 0")
        self.assertRefused([scene, "--time", 1, "--set", "color=red"], "color")
        self.assertRefused([scene, "--time", 1, "--set", "soil=cheese"], "cheese", "lete_sand")

    def test_scenes(self):
        self.assertRefused(["moon", "--time", 1], 'unknown scene "moon"', "hmmwv_flat",
                           "hmmwv_slope", "soil_bin")
        self.assertRefused([self.write("bad.xml", "<mujoco"), "--time", 1], "bad.xml")
        self.assertRefused([self.write("rock.xml", "<mujoco/>"), "--time", 1], "rock.xml", "soil")

    def test_controls(self):
        def refused(text, *sentences):
            path = self.write("c.csv", text)
            self.assertRefused(["hmmwv_flat", "--time", 1, "--controls", path], *sentences)

        refused("time,gas\n0,1\n", "c.csv:1: ", '"gas"', "steer, drive, brake")
        refused("time,drive\n0,1\n0,2\n", "c.csv:3: time must be greater")
        refused("time,drive\n0,\n", "c.csv:2: drive is missing")
        refused("time,drive\n0,99999\n", "c.csv:2: drive must be -12000 to 12000, got 99999")
        self.assertRefused(["hmmwv_flat", "--time", 1, "--controls", self.folder / "no.csv"],
                           "no.csv: cannot read: No such file or directory")

    def test_folder_that_cannot_be_written(self):
        path = self.write("file", "")
        for out in (path, path / "below", "/proc/softsoil"):
            with self.subTest(out=out):
                self.assertFails(run(out), BAD_INPUT, f"{out}: cannot write into this folder")

    def test_python_without_matplotlib(self):
        self.write("matplotlib.py", "raise ImportError")
        arguments = ["run", "hmmwv_flat", "--time", 0.05, "--out", self.folder / "out"]
        blind = {"PYTHONPATH": str(self.folder)}
        done = softsoil(*arguments, environment=blind)
        self.assertFails(done, BAD_INPUT, "matplotlib", "--no-picture")
        self.assertFalse((self.folder / "out").exists())
        done = softsoil(*arguments, "--no-picture", environment=blind)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_unknown_command_and_none(self):
        self.assertFails(softsoil("fly"), BAD_INPUT, "softsoil: ")
        self.assertFails(softsoil(), BAD_INPUT, "softsoil: ")


if __name__ == "__main__":
    unittest.main()
