"""softsoil run on loose soil, which compacts below the wheels: same bits however the soil is
computed."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from program import COARSE, loose_soil_in, run, summary_of


class LooseSoil(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        cls.soils = loose_soil_in(cls.folder)
        (cls.folder / "controls.csv").write_text("time,drive\n0,0\n0.5,0\n0.7,3000\n")
        cls.one_thread = cls.drive("one_thread", "--threads", 1)

    @classmethod
    def drive(cls, name, *more):
        out = cls.folder / name
        done = run(out, "--controls", cls.folder / "controls.csv", *COARSE, "--set",
                   f"soil_file={cls.soils}", "--set", "soil=loose_yolo_loam", *more,
                   seconds=2)
        assert done.returncode == 0, done.stderr
        return out

    def assertSameBits(self, out):
        self.assertGreater(summary_of(self.one_thread)["compaction_energy"], 1)
        for name in ("wheels.csv", "terrain.npy"):
            self.assertTrue((out / name).read_bytes() == (self.one_thread / name).read_bytes(),
                            name)

    def test_two_threads_have_no_influence(self):
        self.assertSameBits(self.drive("two_threads", "--threads", 2))

    def test_a_busy_machine_has_no_influence(self):
        busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(3)]
        try:
            out = self.drive("busy", "--threads", 2)
        finally:
            for process in busy:
                process.kill()
                process.wait()
        self.assertSameBits(out)

    def test_sync_differs_slightly(self):
        """By the soil period that a background job lags behind."""
        sync = self.drive("sync", "--sync")
        self.assertNotEqual((sync / "wheels.csv").read_bytes(),
                            (self.one_thread / "wheels.csv").read_bytes())
        for key in ("rut_volume", "compaction_energy"):
            ratio = summary_of(sync)[key] / summary_of(self.one_thread)[key]
            self.assertAlmostEqual(ratio, 1, delta=0.02, msg=key)


if __name__ == "__main__":
    unittest.main()
