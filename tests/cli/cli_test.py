"""The program softsoil as its users meet it: what it prints, writes, refuses and returns.

Expects softsoil first in PATH.
"""
import csv
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import matplotlib.image
import numpy as np

FAILED, BAD_INPUT, NO_SUCH_PROGRAM = 1, 2, 127
RESULTS = ["summary.json", "terrain.npy", "terrain.png", "wheels.csv"]

# A wheel that rolls, and a spring that no explicit integrator can follow.
DIVERGING = """<mujoco>
  <option timestep="0.01"/>
  <custom><text name="softsoil_soil" data="tilled_yolo_loam"/></custom>
  <worldbody>
    <geom name="soil" type="plane" size="5 5 1" contype="2" conaffinity="0"/>
    <body name="wheel" pos="0 0 0.4">
      <freejoint/>
      <geom type="sphere" size="0.01" mass="100" contype="0" conaffinity="0"/>
      <body name="tire">
        <joint name="spin" type="hinge" axis="0 1 0"/>
        <geom type="cylinder" zaxis="0 1 0" size="0.4 0.1" mass="10" contype="1" conaffinity="1"/>
      </body>
    </body>
    <body pos="0 3 3">
      <joint type="slide" axis="0 0 1" stiffness="1e9"/>
      <geom size="0.1" mass="1" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
</mujoco>
"""


def softsoil(*arguments, environment=None, stdout=subprocess.PIPE):
    return subprocess.run(["softsoil", *map(str, arguments)], stdin=subprocess.DEVNULL,
                          stdout=stdout, stderr=subprocess.PIPE, text=True, timeout=300,
                          env={**os.environ, **(environment or {})})


def run(folder, *more, seconds=0.2, scene="hmmwv_flat"):
    return softsoil("run", scene, "--time", seconds, "--out", folder, *more)


def summary_of(folder):
    return json.loads((folder / "summary.json").read_text())


class InAFolder(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def assertFails(self, done, code, *sentences):
        self.assertEqual(done.returncode, code, done.stderr)
        for sentence in sentences:
            self.assertIn(sentence, done.stderr)


class Run(unittest.TestCase):
    """One short run, looked at from all sides."""

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = pathlib.Path(cls.holder.name) / "a" / "result"
        controls = pathlib.Path(cls.holder.name) / "controls.csv"
        controls.write_text("time,drive,steer\n0,0,0\n0.2,3000,0.1\n")
        cls.done = run(cls.folder, "--controls", controls, "--threads", 2, "--interval", 0.1,
                       seconds=1.5)
        assert cls.done.returncode == 0, cls.done.stderr
        with open(cls.folder / "wheels.csv", newline="") as file:
            cls.rows = list(csv.DictReader(file))

    def test_leaves_its_results_and_nothing_else(self):
        self.assertEqual(sorted(os.listdir(self.folder)), RESULTS)

    def test_prints_a_row_for_each_wheel_and_no_progress_into_a_pipe(self):
        for word in ["wheel_fl", "wheel_fr", "wheel_rl", "wheel_rr", "load [kN]", "sinkage [cm]",
                     "rut depth [cm]", "slip [%]", "drawbar pull [kN]", "torque [kN m]",
                     "Real-time factor", str(self.folder)]:
            self.assertIn(word, self.done.stdout)
        self.assertNotIn("\r", self.done.stderr)

    def test_summary_has_every_key(self):
        summary = summary_of(self.folder)
        for key in ["real_time_factor", "wall_time", "grid_spacing", "volumes", "columns",
                    "peak_memory_mb", "rut_volume", "displaced_volume", "compaction_energy",
                    "bytes_per_column", "bytes_per_volume"]:
            self.assertGreater(summary[key], 0, key)
        self.assertAlmostEqual(summary["simulated_time"], 1.5)
        self.assertAlmostEqual(summary["real_time_factor"], summary["wall_time"] / 1.5)
        self.assertEqual(summary["wheels_averaged_over"], 1)
        self.assertEqual(summary["threads"], 2)
        self.assertEqual(summary["timestep"], 0.001)
        self.assertEqual(summary["soil_clock"], 0.01)
        self.assertEqual(summary["soil"], "tilled_yolo_loam")
        self.assertEqual(summary["scene"], "hmmwv_flat")
        self.assertEqual(summary["mujoco_version"], "2.2.2")
        self.assertEqual(summary["warnings"], [])

    def test_summary_has_every_wheel(self):
        wheels = summary_of(self.folder)["wheels"]
        self.assertEqual([w["name"] for w in wheels],
                         ["wheel_fl", "wheel_fr", "wheel_rl", "wheel_rr"])
        for wheel in wheels:
            for key in ["load", "sinkage", "rut_depth", "drawbar_pull", "torque", "slip_ratio"]:
                self.assertTrue(math.isfinite(wheel[key]), key)
        weight = 2484.9 * 9.81
        self.assertAlmostEqual(sum(w["load"] for w in wheels) / weight, 1, delta=0.05)

    def test_table_of_wheels_has_units_and_a_row_per_wheel_and_interval(self):
        self.assertTrue({"time [s]", "wheel", "x [m]", "y [m]", "load [N]", "sinkage [m]",
                         "rut depth [m]", "slip ratio [-]", "slip angle [deg]", "torque [N m]",
                         "drawbar pull [N]"} <= set(self.rows[0]))
        self.assertEqual(len(self.rows), 16 * 4)
        times = sorted({float(row["time [s]"]) for row in self.rows})
        np.testing.assert_allclose(times, np.linspace(0, 1.5, 16), atol=1e-9)
        for row in self.rows:
            self.assertTrue(all(math.isfinite(float(row[key])) for key in row if key != "wheel"))

    def test_controls_drive(self):
        self.assertGreater(float(self.rows[-1]["torque [N m]"]), 300)

    def test_terrain_holds_the_rut_below_the_wheels(self):
        terrain = np.load(self.folder / "terrain.npy")
        self.assertEqual(terrain.shape[1], 4)
        self.assertEqual(terrain.dtype, np.float32)
        self.assertTrue(np.isfinite(terrain).all())
        deepest = terrain[terrain[:, 3].argmax()]
        self.assertGreater(deepest[3], 0.005)
        distances = [math.hypot(float(r["x [m]"]) - deepest[0], float(r["y [m]"]) - deepest[1])
                     for r in self.rows]
        self.assertLess(min(distances), 0.6)

    def test_picture_shows_something(self):
        picture = matplotlib.image.imread(self.folder / "terrain.png")  # refuses what is no PNG
        self.assertGreater(min(picture.shape[:2]), 300)
        self.assertGreater(len(np.unique((picture[:, :, :3] * 31).astype(int).reshape(-1, 3),
                                         axis=0)), 50)


class RunOptions(InAFolder):
    def test_output_interval_has_no_influence_on_the_motion(self):
        ends = []
        for interval in (0.01, 0.15):
            folder = self.folder / str(interval)
            self.assertEqual(run(folder, "--interval", interval, "--no-picture").returncode, 0)
            ends.append(summary_of(folder)["wheels"])
        self.assertEqual(*ends)

    def test_settings_reach_the_soil(self):
        done = run(self.folder, "--no-picture", "--sync", "--mode", "compaction", "--soil-clock",
                   0.005, "--set", "grid_spacing=0.05", "--set", "soil=lete_sand")
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = summary_of(self.folder)
        self.assertEqual(summary["displaced_volume"], 0)
        self.assertEqual(summary["soil_clock"], 0.005)
        self.assertEqual(summary["grid_spacing"], 0.05)
        self.assertEqual(summary["soil"], "lete_sand")
        self.assertEqual(sorted(os.listdir(self.folder)),
                         [name for name in RESULTS if name != "terrain.png"])

    def test_scene_may_be_a_file(self):
        scene = pathlib.Path("models/scenes/soil_bin.xml").resolve()
        done = run(self.folder / "out", "--no-picture", scene=scene, seconds=0.05)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_results_of_an_earlier_run_are_removed(self):
        for name in RESULTS:
            self.write(name, "old")
        self.assertEqual(run(self.folder, "--no-picture", seconds=0.05).returncode, 0)
        self.assertFalse((self.folder / "terrain.png").exists())
        self.assertNotEqual((self.folder / "wheels.csv").read_text(), "old")


class BadInput(InAFolder):
    def assertRefused(self, arguments, *sentences):
        with self.subTest(arguments=arguments):
            out = self.folder / "out"
            done = softsoil("run", *arguments, "--out", out)
            self.assertFails(done, BAD_INPUT, "softsoil: ", *sentences)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertFalse(out.exists(), "refused only after the folder was made")

    def test_options(self):
        scene = "hmmwv_flat"
        self.assertRefused([scene, "--time", -1], "--time must be > 0 s, got -1")
        self.assertRefused([scene, "--time", 0], "--time must be > 0 s, got 0")
        self.assertRefused([scene, "--time", "nan"], "--time must be > 0 s, got nan")
        self.assertRefused([scene, "--time", "forty"], "forty")
        self.assertRefused([scene], "--time is required")
        self.assertRefused([scene, "--time", 1, "--interval", 0], "--interval must be > 0 s, got 0")
        self.assertRefused([scene, "--time", 1, "--mode", "rock"], "rock", "flow", "compaction")
        self.assertRefused([scene, "--time", 1, "--colour", "red"], "--colour")
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


class AFailingRun(InAFolder):
    def test_full_disk(self):
        for name in ("wheels.csv", "terrain.npy", "summary.json"):
            with self.subTest(name=name):
                out = self.folder / name
                out.mkdir()
                (out / (name + ".part")).symlink_to("/dev/full")
                done = run(out, seconds=0.05)
                self.assertFails(done, FAILED,
                                 f"{name}.part: cannot write: No space left on device")
                self.assertFalse((out / "summary.json").exists())
                self.assertFalse((out / name).exists())

    def test_full_disk_for_the_picture(self):
        (self.folder / "terrain.png.part").symlink_to("/dev/full")
        done = run(self.folder, seconds=0.05)
        self.assertFails(done, FAILED, "No space left on device", "terrain.png")
        self.assertFalse((self.folder / "terrain.png").exists())

    def test_output_that_nobody_can_read(self):
        with open("/dev/full", "w") as full:
            for arguments in (["list"], ["run", "hmmwv_flat", "--time", 0.01, "--no-picture",
                                         "--out", self.folder]):
                done = softsoil(*arguments, stdout=full)
                self.assertFails(done, FAILED, "standard output: No space left on device")

    def test_killed_midway(self):
        self.write("summary.json", "old")
        process = subprocess.Popen(["softsoil", "run", "hmmwv_flat", "--time", "1000", "--out",
                                    str(self.folder)], stdout=subprocess.DEVNULL)
        rows = self.folder / "wheels.csv.part"
        deadline = time.monotonic() + 60
        while not (rows.exists() and rows.read_text().count("\n") > 9):
            self.assertLess(time.monotonic(), deadline, "the run wrote no rows")
            time.sleep(0.05)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertEqual(os.listdir(self.folder), ["wheels.csv.part"])

    def test_model_that_diverges(self):
        scene = self.write("scene.xml", DIVERGING)
        done = run(self.folder / "out", scene=scene, seconds=2)
        self.assertFails(done, FAILED, "the model diverged at ")
        self.assertFalse((self.folder / "out" / "summary.json").exists())


class List(unittest.TestCase):
    def test_everything(self):
        done = softsoil("list")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ["soils", "tilled_yolo_loam", "Yolo clay loam, tilled", "tires",
                     "37x12.5R16.5_15psi", "scenes", "hmmwv_flat", "HMMWV on level"]:
            self.assertIn(word, done.stdout)

    def test_one_kind(self):
        done = softsoil("list", "tires")
        self.assertIn("18.4R38_85kPa", done.stdout)
        self.assertNotIn("hmmwv_flat", done.stdout)
        self.assertEqual(softsoil("list", "moons").returncode, BAD_INPUT)


class With(InAFolder):
    PRINT = "import os; print([os.environ.get(k) for k in ('LD_PRELOAD', 'SOFTSOIL_ON_ERROR')])"

    def seen_by(self, *options, environment=None):
        done = softsoil("with", *options, "--", sys.executable, "-c", self.PRINT,
                        environment=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_preloads_the_library(self):
        library = pathlib.Path(shutil.which("softsoil")).resolve().parents[1] / "lib/libsoftsoil.so"
        self.assertEqual(self.seen_by(environment={"LD_PRELOAD": ""}),
                         f"['{library}', None]\n")

    def test_keeps_what_is_preloaded(self):
        self.assertIn("libsoftsoil.so:libm.so.6'", self.seen_by(
            environment={"LD_PRELOAD": "libm.so.6"}))

    def test_passes_on_error(self):
        self.assertIn("'continue']", self.seen_by("--on-error", "continue"))
        done = softsoil("with", "--on-error", "dance", "--", "true")
        self.assertFails(done, BAD_INPUT, "dance", "stop", "continue")

    def test_returns_what_the_program_returns(self):
        done = softsoil("with", "--", "sh", "-c", "exit 7")
        self.assertEqual(done.returncode, 7)

    def test_program_that_is_not_there(self):
        done = softsoil("with", "--", "no-such-program", "--x")
        self.assertFails(done, NO_SUCH_PROGRAM, "no-such-program: No such file or directory")
        self.assertFails(softsoil("with"), BAD_INPUT, "softsoil: ")


class Help(unittest.TestCase):
    def test_is_there_for_every_command(self):
        for command in ([], ["run"], ["list"], ["with"]):
            done = softsoil(*command, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn("Usage: softsoil", done.stdout)

    def test_version(self):
        self.assertRegex(softsoil("--version").stdout, r"^\d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    unittest.main()
