"""softsoil run: the contact of the tires in contact.csv and contact.png."""
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import matplotlib.image

from program import COARSE, InAFolder, rows_of, run

SCRIPT = pathlib.Path("plugin/cli/plot/contact.py").resolve()
FLYING = """
<mujoco model="flying">
  <custom><text name="softsoil_soil" data="tilled_yolo_loam"/></custom>
  <worldbody>
    <geom type="plane" size="5 5 1" contype="0" conaffinity="0"/>
    <body name="low" pos="0 0 .39">
      <inertial pos="0 0 0" mass="200" diaginertia="5 5 5"/>
      <joint axis="0 1 0"/>
      <geom type="cylinder" zaxis="0 1 0" size=".4 .1" contype="0" conaffinity="0"/>
    </body>
    <body name="high" pos="0 2 1">
      <inertial pos="0 0 0" mass="200" diaginertia="5 5 5"/>
      <joint axis="0 1 0"/>
      <geom type="cylinder" zaxis="0 1 0" size=".4 .1" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
</mujoco>"""


def draw(folder, *more):
    return subprocess.run([sys.executable, SCRIPT, folder, *map(str, more)], capture_output=True,
                          text=True, timeout=300)


class Contact(unittest.TestCase):
    """One run of a vehicle."""

    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        done = run(cls.folder, *COARSE, "--contact-times", "0.5,0.5004,1", seconds=1)
        assert done.returncode == 0, done.stderr
        cls.rows = rows_of(cls.folder, "contact.csv")
        cls.last_wheels = rows_of(cls.folder)[-4:]

    def test_is_told_at_the_times_chosen_and_at_the_end(self):
        self.assertEqual({round(row["time [s]"], 9) for row in self.rows}, {0.5, 1})
        for wheel in self.last_wheels:
            self.assertGreater(len(self.nodes_at_the_end(wheel["wheel"])), 20)

    def nodes_at_the_end(self, wheel):
        return [row for row in self.rows if row["wheel"] == wheel and row["time [s]"] > 0.75]

    def test_adds_up_to_what_the_wheel_reports(self):
        for wheel in self.last_wheels:
            nodes = self.nodes_at_the_end(wheel["wheel"])
            self.assertAlmostEqual(sum(node["area [m^2]"] for node in nodes),
                                   wheel["contact_area [m^2]"], places=6)
            self.assertEqual(max(node["pressure [Pa]"] for node in nodes),
                             wheel["peak_pressure [Pa]"])
            self.assertEqual(max(node["depth [m]"] for node in nodes), wheel["sinkage [m]"])
            up = sum((node["pressure [Pa]"] * math.cos(math.radians(node["angle [deg]"]))
                      + node["shear [Pa]"] * math.sin(math.radians(node["angle [deg]"])))
                     * node["area [m^2]"] for node in nodes)
            self.assertAlmostEqual(up / wheel["load [N]"], 1, delta=1e-3)

    def test_lies_around_the_wheel(self):
        for wheel in self.last_wheels:
            for node in self.nodes_at_the_end(wheel["wheel"]):
                self.assertAlmostEqual(node["x [m]"] - wheel["x [m]"], node["ahead [m]"],
                                       delta=1e-3)
                self.assertAlmostEqual(node["y [m]"] - wheel["y [m]"], node["lateral [m]"],
                                       delta=1e-3)

    def test_picture_may_be_drawn_of_any_instant_and_wheel(self):
        done = draw(self.folder, "--time", 0.5)
        self.assertEqual(done.returncode, 0, done.stderr)
        of_four = matplotlib.image.imread(self.folder / "contact.png")
        done = draw(self.folder, "--wheel", "wheel_rr")
        self.assertEqual(done.returncode, 0, done.stderr)
        of_one = matplotlib.image.imread(self.folder / "contact.png")
        self.assertGreater(of_four.shape[0], 3 * of_one.shape[0])

    def test_picture_of_a_wheel_that_is_not_there_is_refused(self):
        done = draw(self.folder, "--wheel", "spare")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn('unknown wheel "spare"; known are: wheel_fl, wheel_fr, wheel_rl, wheel_rr',
                      done.stderr)


class InTheAir(InAFolder):
    def test_a_wheel_has_no_rows_and_an_empty_place_in_the_picture(self):
        scene = self.write("flying.xml", FLYING)
        done = run(self.folder / "out", scene=scene, seconds=0.05)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = rows_of(self.folder / "out", "contact.csv")
        self.assertEqual({row["wheel"] for row in rows}, {"low"})
        self.assertIn("contact.png", os.listdir(self.folder / "out"))
        done = draw(self.folder / "out", "--wheel", "high")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_picture_is_drawn_where_nothing_touches(self):
        scene = self.write("flying.xml", FLYING.replace("0 0 .39", "0 0 1"))
        done = run(self.folder / "out", scene=scene, seconds=0.05)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(rows_of(self.folder / "out", "contact.csv"), [])
        self.assertTrue((self.folder / "out" / "contact.png").exists())


if __name__ == "__main__":
    unittest.main()
