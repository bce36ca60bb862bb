"""The soil bin of Madsen (2014), 6.3.1: tilled loam, 18.4R38 at 85 kPa, 18 kN, 1 m/s."""
import unittest

from program import InAFolder, run, summary_of
from soil_bin_runs import GRID

RADIUS = 0.91  # [m]
WEIGHT = (1653.3 + 91.85 + 91.85) * 9.81  # [N]


class SoilBin(InAFolder):
    def wheel_at(self, slip):
        spin = (1 + slip) / RADIUS
        controls = self.write("controls.csv",
                              f"time,forward,spin\n0,0,0\n0.5,0,0\n1,1,{spin}\n9,1,{spin}\n")
        done = run(self.folder, "--controls", controls, "--no-picture", *GRID,
                   seconds=3, scene="soil_bin")
        self.assertEqual(done.returncode, 0, done.stderr)
        return summary_of(self.folder)["wheels"][0]

    def test_drawbar_pull_rises_with_slip(self):
        slips = [0.05, 0.2, 0.7]
        wheels = [self.wheel_at(slip) for slip in slips]
        pulls = [wheel["drawbar_pull"] for wheel in wheels]
        self.assertLess(pulls[0], pulls[1])
        self.assertLess(pulls[1], pulls[2])
        for slip, wheel in zip(slips, wheels):
            with self.subTest(slip=slip):
                self.assertAlmostEqual(wheel["slip_ratio"], slip, delta=0.005)
                self.assertAlmostEqual(wheel["load"] / WEIGHT, 1, delta=0.01)
                self.assertGreater(wheel["motion_resistance"], 400)
                self.assertLess(wheel["motion_resistance"], 3000)


if __name__ == "__main__":
    unittest.main()
