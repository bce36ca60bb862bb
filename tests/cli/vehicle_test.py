"""Vehicles on soft soil: one parked on a slope, the HMMWV driven and steered."""
import math
import unittest

from program import COARSE, InAFolder, rows_of, run, summary_of

ANGLE = 10  # [deg]
CORNERS = {"fl": "1.6 .9 0", "fr": "1.6 -.9 0", "rl": "-1.6 .9 0", "rr": "-1.6 -.9 0"}
WEIGHT = (2000 + 4 * 60) * 9.81  # [N]
PARKED = f"""
<mujoco model="parked">
  <option timestep="0.001"/>
  <custom>
    <text name="softsoil_soil" data="tilled_yolo_loam"/>
    <text name="softsoil_tire" data="37x12.5R16.5_15psi"/>
  </custom>
  <worldbody>
    <geom name="ground" type="plane" euler="0 {-ANGLE} 0" size="9 9 1" contype="0" conaffinity="0"/>
    <body pos="0 0 .48" euler="0 {-ANGLE} 0">
      <freejoint/>
      <inertial pos="0 0 .3" mass="2000" diaginertia="1000 3000 3500"/>
      {"".join(f'''<body name="{name}" pos="{place}">
        <joint name="{name}" axis="0 1 0"/>
        <geom type="cylinder" zaxis="0 1 0" size=".47 .16" mass="60" contype="0" conaffinity="0"/>
      </body>''' for name, place in CORNERS.items())}
    </body>
  </worldbody>
  <equality>{"".join(f'<joint joint1="{name}" solref=".005 1"/>' for name in CORNERS)}</equality>
</mujoco>"""


class Parked(InAFolder):
    def test_a_vehicle_with_locked_wheels_rests_on_a_slope(self):
        scene = self.write("parked.xml", PARKED)
        done = run(self.folder / "out", *COARSE, "--interval", 0.1, scene=scene, seconds=9)
        self.assertEqual(done.returncode, 0, done.stderr)
        settled = [row for row in rows_of(self.folder / "out") if row["time [s]"] > 3.95]
        for name in CORNERS:
            rows = [row for row in settled if row["wheel"] == name]
            self.assertEqual(len(rows), 51)
            places = [[row["x [m]"], row["y [m]"], row["z [m]"]] for row in rows]
            self.assertLess(max(math.dist(place, places[0]) for place in places), 1e-3)
            self.assertLess(max(abs(row["forward_speed [m/s]"]) for row in rows), 1e-3)
            self.assertLess(max(abs(row["spin [rad/s]"]) for row in rows), 1e-3)
        # Upwards and uphill, from the wheels' axes to those of the world.
        load = sum(row["load [N]"] for row in settled[-4:])
        pull = sum(row["drawbar_pull [N]"] for row in settled[-4:])
        cos, sin = math.cos(math.radians(ANGLE)), math.sin(math.radians(ANGLE))
        self.assertAlmostEqual((load * cos + pull * sin) / WEIGHT, 1, delta=0.01)
        self.assertAlmostEqual((pull * cos - load * sin) / WEIGHT, 0, delta=0.01)


class Hmmwv(InAFolder):
    def drive(self, steer):
        controls = self.write("controls.csv", f"time,drive,steer\n0,0,0\n0.5,4000,{steer}\n")
        done = run(self.folder, "--controls", controls, *COARSE, seconds=3)
        self.assertEqual(done.returncode, 0, done.stderr)
        ends = {row["wheel"]: row for row in rows_of(self.folder)[-4:]}
        middle = [sum(row[key] for row in ends.values()) / 4 for key in ("x [m]", "y [m]")]
        return middle, summary_of(self.folder)["wheels"]

    def test_goes_where_it_is_steered(self):
        for steer in (0.3, -0.3):
            (x, y), _ = self.drive(steer)
            self.assertGreater(x, 1)
            self.assertGreater(y * math.copysign(1, steer), 0.1)

    def test_goes_straight_with_the_same_torque_on_every_wheel(self):
        (x, y), wheels = self.drive(0)
        self.assertGreater(x, 1)
        self.assertAlmostEqual(y, 0, delta=1e-3)
        for wheel in wheels:
            self.assertAlmostEqual(wheel["torque"] / 1000, 1, delta=0.1, msg=wheel["name"])


if __name__ == "__main__":
    unittest.main()
