"""softsoil run: what it prints and writes, and what its options do."""
import math
import os
import pathlib
import tempfile
import unittest

import matplotlib.image
import numpy as np

from program import COARSE, RESULTS, InAFolder, rows_of, run, summary_of


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
                       seconds=1.2)
        assert cls.done.returncode == 0, cls.done.stderr
        cls.rows = rows_of(cls.folder)

    def test_leaves_its_results_and_nothing_else(self):
        self.assertEqual(sorted(os.listdir(self.folder)), RESULTS)

    def test_prints_a_row_for_each_wheel_and_no_progress_into_a_pipe(self):
        for word in ["wheel_fl", "wheel_fr", "wheel_rl", "wheel_rr", "load [N]", "sinkage [cm]",
                     "rut depth [cm]", "slip [%]", "drawbar pull [N]", "torque [N m]",
                     "Real-time factor", "Stress direct: ", str(self.folder)]:
            self.assertIn(word, self.done.stdout)
        self.assertNotIn("\r", self.done.stderr)

    def test_summary_has_every_key(self):
        summary = summary_of(self.folder)
        for key in ["real_time_factor", "wall_time", "grid_spacing", "volumes", "columns",
                    "peak_memory_mb", "rut_volume", "displaced_volume", "bytes_per_column",
                    "bytes_per_volume"]:
            self.assertGreater(summary[key], 0, key)
        self.assertAlmostEqual(summary["simulated_time"], 1.2)
        self.assertAlmostEqual(summary["real_time_factor"], summary["wall_time"] / 1.2)
        self.assertEqual(summary["wheels_averaged_over"], 1)
        self.assertEqual(summary["threads"], 2)
        self.assertEqual(summary["timestep"], 0.001)
        self.assertEqual(summary["soil_clock"], 0.01)
        self.assertEqual(summary["stress"], "direct")
        self.assertGreater(summary["direct_updates"], 100)
        self.assertEqual(summary["gaussian_updates"], 0)
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
                         "rut_depth [m]", "slip_ratio [-]", "slip_angle [deg]", "torque [N m]",
                         "drawbar_pull [N]"} <= set(self.rows[0]))
        self.assertEqual(len(self.rows), 13 * 4)
        times = sorted({row["time [s]"] for row in self.rows})
        np.testing.assert_allclose(times, np.linspace(0, 1.2, 13), atol=1e-9)
        for row in self.rows:
            self.assertTrue(all(math.isfinite(row[key]) for key in row if key != "wheel"))

    def test_controls_drive(self):
        self.assertGreater(self.rows[-1]["torque [N m]"], 300)

    def test_terrain_holds_the_rut_below_the_wheels(self):
        terrain = np.load(self.folder / "terrain.npy")
        self.assertEqual(terrain.shape[1], 4)
        self.assertEqual(terrain.dtype, np.float32)
        self.assertTrue(np.isfinite(terrain).all())
        deepest = terrain[terrain[:, 3].argmax()]
        self.assertGreater(deepest[3], 0.005)
        distances = [math.hypot(r["x [m]"] - deepest[0], r["y [m]"] - deepest[1])
                     for r in self.rows]
        self.assertLess(min(distances), 0.6)

    def test_pictures_show_something(self):
        for name in ("terrain.png", "contact.png"):
            picture = matplotlib.image.imread(self.folder / name)  # refuses what is no PNG
            self.assertGreater(min(picture.shape[:2]), 300, name)
            self.assertGreater(len(np.unique((picture[:, :, :3] * 31).astype(int).reshape(-1, 3),
                                             axis=0)), 50, name)


class RunOptions(InAFolder):
    def test_output_interval_has_no_influence_on_the_motion(self):
        ends = []
        for interval in (0.01, 0.15):
            folder = self.folder / str(interval)
            self.assertEqual(run(folder, "--interval", interval, *COARSE).returncode, 0)
            ends.append(summary_of(folder)["wheels"])
        self.assertEqual(*ends)

    def test_settings_reach_the_soil(self):
        done = run(self.folder, "--no-picture", "--sync", "--mode", "compaction", "--soil-clock",
                   0.005, "--set", "grid_spacing=0.05", "--set", "soil=lete_sand",
                   "--set", "stress=gaussian")
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = summary_of(self.folder)
        self.assertEqual(summary["displaced_volume"], 0)
        self.assertEqual(summary["soil_clock"], 0.005)
        self.assertEqual(summary["grid_spacing"], 0.05)
        self.assertEqual(summary["soil"], "lete_sand")
        self.assertEqual(summary["stress"], "gaussian")
        self.assertEqual(summary["direct_updates"], 0)
        self.assertEqual(sorted(os.listdir(self.folder)),
                         [name for name in RESULTS if not name.endswith(".png")])

    def test_profile_tells_where_the_time_went_and_changes_nothing(self):
        plain, profiled, in_place = (self.folder / name for name in ("plain", "profiled", "in_place"))
        grid = COARSE[1:]
        for folder, options in ((plain, COARSE), (profiled, ["--profile", *grid]),
                                (in_place, ["--profile", "--sync", *COARSE])):
            done = run(folder, *options)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(os.listdir(profiled)), sorted([*RESULTS, "profile.png"]))
        matplotlib.image.imread(profiled / "profile.png")  # refuses what is no PNG
        self.assertFalse((in_place / "profile.png").exists())
        self.assertNotIn("profile", summary_of(plain))
        self.assertEqual(summary_of(profiled)["state_hash"], summary_of(plain)["state_hash"])
        for folder in (profiled, in_place):
            summary = summary_of(folder)
            run_parts, soil_update = summary["profile"]["run"], summary["profile"]["soil_update"]
            self.assertEqual(list(run_parts), ["mujoco", "contact", "flow", "waiting", "results"])
            self.assertAlmostEqual(sum(run_parts.values()), summary["wall_time"])
            for name, time in {**run_parts, **soil_update}.items():
                self.assertGreater(time, 0, name)

    def test_scene_may_be_a_file(self):
        scene = pathlib.Path("models/scenes/soil_bin.xml").resolve()
        done = run(self.folder / "out", "--no-picture", scene=scene, seconds=0.05)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_results_of_an_earlier_run_are_removed(self):
        for name in RESULTS:
            self.write(name, "old")
        self.assertEqual(run(self.folder, "--no-picture", seconds=0.05).returncode, 0)
        self.assertFalse(list(self.folder.glob("*.png")))
        self.assertNotEqual((self.folder / "wheels.csv").read_text(), "old")


if __name__ == "__main__":
    unittest.main()
