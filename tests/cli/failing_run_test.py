"""softsoil run: a run that fails midway says so and leaves no half results."""
import os
import signal
import subprocess
import time
import unittest

from program import FAILED, InAFolder, run, softsoil

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


class AFailingRun(InAFolder):
    def test_full_disk(self):
        for name in ("wheels.csv", "contact.csv", "terrain.npy", "summary.json"):
            with self.subTest(name=name):
                out = self.folder / name
                out.mkdir()
                (out / (name + ".part")).symlink_to("/dev/full")
                done = run(out, seconds=0.05)
                self.assertFails(done, FAILED,
                                 f"{name}.part: cannot write: No space left on device")
                self.assertFalse((out / "summary.json").exists())
                self.assertFalse((out / name).exists())

    def test_full_disk_for_the_pictures(self):
        for name in ("terrain.png", "contact.png"):
            with self.subTest(name=name):
                out = self.folder / name
                out.mkdir()
                (out / (name + ".part")).symlink_to("/dev/full")
                done = run(out, seconds=0.05)
                self.assertFails(done, FAILED, f"{name}.part: cannot write: No space left on device")
                self.assertNotIn("Traceback", done.stderr)
                self.assertEqual(list(out.glob(f"{name}*")), [])

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
        self.assertEqual(sorted(os.listdir(self.folder)), ["contact.csv.part", "wheels.csv.part"])

    def test_model_that_diverges(self):
        scene = self.write("scene.xml", DIVERGING)
        done = run(self.folder / "out", scene=scene, seconds=2)
        self.assertFails(done, FAILED, "the model diverged at ")
        self.assertFalse((self.folder / "out" / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
