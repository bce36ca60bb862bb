"""softsoil run --save-state and --load-state: a run that goes on from a state has the same bits as
one that was not interrupted."""
import os
import pathlib
import select
import signal
import subprocess
import tempfile
import unittest

from program import COARSE, FAILED, InAFolder, loose_soil_in, run, scene_in, summary_of

END = 0.7         # [s]
BETWEEN = 0.234   # [s]  neither a soil update nor a row of wheels.csv
ON_A_ROW = 0.25   # [s]


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
        contacts = [str(t) for t in (0.3, 0.6) if start <= t <= end]
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
        for key in ("state_hash", "compaction_energy", "rut_volume", "displaced_volume",
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
        self.assertTrue((part / state.name).read_bytes() == state.read_bytes(), "saved again")

    def test_from_a_time_of_a_row(self):
        part = self.drive("on_a_row", ON_A_ROW, END, load=self.whole / f"{ON_A_ROW}.state")
        self.assertSameFrom(ON_A_ROW, self.whole, part)
        self.assertTrue(lines_from(part / "wheels.csv", 0)[1].startswith("0.25,"))

    def test_from_the_start(self):
        part = self.drive("start", 0, END, load=self.whole / "0.state")
        self.assertSameFrom(0, self.whole, part)

    def test_twice(self):
        first = self.drive("first", BETWEEN, 0.417, load=self.whole / f"{BETWEEN}.state")
        second = self.drive("second", 0.417, END, load=first / "0.417.state",
                            more=["--threads", 1])
        for name in ("terrain.npy", f"{END}.state"):
            self.assertTrue((second / name).read_bytes() == (self.whole / name).read_bytes(), name)
        self.assertEqual(lines_from(second / "wheels.csv", 0.417),
                         lines_from(self.whole / "wheels.csv", 0.417))

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


class OnItsWay(InAFolder):
    def test_full_disk(self):
        (self.folder / "x.state.part").symlink_to("/dev/full")
        done = run(self.folder / "out", *COARSE, "--save-state", f"0.05:{self.folder}/x.state",
                   seconds=0.1)
        self.assertFails(done, FAILED, "x.state.part: cannot write: No space left on device")
        self.assertEqual(os.listdir(self.folder), ["out"])
        self.assertFalse((self.folder / "out" / "summary.json").exists())

    def test_killed_midway(self):
        """No half file, and none of an earlier run. The pipe holds less than the state."""
        reached, writing, later = (self.folder / name for name in ("reached", "writing", "later"))
        later.write_bytes(b"softsoil state\n")
        os.mkfifo(self.folder / "writing.part")
        process = subprocess.Popen(
            ["softsoil", "run", "hmmwv_flat", "--time", "1000", "--out", self.folder / "out",
             *COARSE, "--save-state", f"0.05:{reached}", "--save-state", f"0.1:{writing}",
             "--save-state", f"900:{later}"], stdout=subprocess.DEVNULL)
        pipe = os.open(self.folder / "writing.part", os.O_RDONLY | os.O_NONBLOCK)
        written, _, _ = select.select([pipe], [], [], 60)
        self.assertTrue(written, "the run wrote no state")
        process.send_signal(signal.SIGKILL)
        process.wait()
        os.close(pipe)
        self.assertGreater(reached.stat().st_size, 100000)
        self.assertEqual(sorted(os.listdir(self.folder)), ["out", "reached", "writing.part"])
        done = run(self.folder / "out", *COARSE, "--load-state", reached, seconds=0.05)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_older_state_is_replaced(self):
        states = []
        for seconds in (0.05, 0.1):
            done = run(self.folder / "out", *COARSE, "--save-state",
                       f"{seconds}:{self.folder}/out/x.state", seconds=seconds)
            self.assertEqual(done.returncode, 0, done.stderr)
            states.append((self.folder / "out" / "x.state").read_bytes())
        self.assertNotEqual(*states)

    def test_hash_is_told(self):
        done = run(self.folder / "out", *COARSE, seconds=0.05)
        self.assertIn("state hash " + summary_of(self.folder / "out")["state_hash"], done.stdout)
        self.assertRegex(summary_of(self.folder / "out")["state_hash"], "^[0-9a-f]{16}$")


if __name__ == "__main__":
    unittest.main()
