"""softsoil drawbar: what it refuses, and what it warns of."""
import os
import unittest

from program import BAD_INPUT, summary_of
from soil_bin_runs import Bin, numbers, table


class BadInput(Bin):
    def refused(self, sentence, *more, **given):
        out = self.folder / "out"
        self.assertFails(self.drawbar(*more, out=out, **given), BAD_INPUT, sentence)
        self.assertFalse(out.exists())

    def test_names_that_nobody_knows_are_answered_by_those_that_are_known(self):
        self.refused('unknown tire "round"; known are: ', "--slip", "0.1", tire="round")
        self.refused('unknown soil "mud"; known are: ', "--slip", "0.1", soil="mud")

    def test_numbers_out_of_range(self):
        self.refused("--slip must be -0.99 to 9, got -1", "--slip=-1")
        self.refused("--slip must be -0.99 to 9, got 10; it is a ratio, 0.1 for 10 %", "--slip",
                     "10:40:10")
        self.refused("--wong-reece-width must be 0.001 to 10 m, got 0", "--slip", "0.1",
                     "--wong-reece", "--wong-reece-width", "0")
        self.refused("--load must be 0.1 to 1e+07 N, got 0", "--slip", "0.1", load=0)
        self.refused("--load must be", "--slip", "0.1", load="nan")
        self.refused("--speed must be 0.01 to 100 m/s, got 0", "--slip", "0.1", "--speed", "0")
        self.refused("--slip must be 1 to 200 numbers, got 1001", "--slip", "0:1:0.001")
        self.refused("--slip", "--slip", "0.1:0.3:0")
        self.refused("--slip", "--slip", "0.1:0.3:-0.1")
        self.refused("--threads must be 1 to 1024, got 0", "--slip", "0.1", "--threads", "0")
        self.refused("--contact-times must be 0 to 1 s, got 2", "--mode", "torque", "--torque",
                     "10", "--time", "1", "--contact-times", "2")

    def test_every_mode_says_what_it_needs(self):
        self.refused("--mode slip needs --slip")
        self.refused("--mode spin needs --spin", "--mode", "spin")
        self.refused("--mode torque needs --time", "--mode", "torque", "--torque", "100")
        self.refused("--spin is for --mode spin, not for --mode slip", "--slip", "0.1", "--spin",
                     "1")
        self.refused("--bumps is for --mode torque", "--slip", "0.1", "--bumps", "0.1,1")

    def test_settings(self):
        self.refused("--set soil: is chosen by --soil", "--slip", "0.1", "--set", "soil=lete_sand")
        self.refused("--set mode: is given twice", "--slip", "0.1", "--set", "mode=flow", "--set",
                     "mode=compaction")
        self.refused("softsoil_clock: must be 0.0001 to 10 s, got 99", "--slip", "0.1", "--set",
                     "clock=99")
        self.refused("softsoil_bumps", "--mode", "torque", "--torque", "100", "--time", "1",
                     "--bumps", "high")

    def test_soil_that_does_not_say_where_it_presses_most(self):
        self.refused("has no <max_stress", "--slip", "0.1", "--wong-reece", soil="lete_sand")

    def test_a_rigid_wheel_without_a_slip(self):
        self.refused("--wong-reece: the rigid wheel is driven, so one --slip must be >= 0, got "
                     "-0.1", "--slip=-0.2,-0.1", "--wong-reece")
        self.refused("--wong-reece-width is for --wong-reece", "--slip", "0.1",
                     "--wong-reece-width", "0.5")

    def test_a_path_with_a_comma(self):
        for option in ("--soil-file", "--tire-file"):
            self.refused(f"{option}: the path must not hold a comma, got ", "--slip", "0.1", option,
                         self.write("a,b.xml", ""))

    def test_a_folder_that_cannot_be_written(self):
        file = self.write("file", "")
        self.assertFails(self.drawbar("--slip", "0.1", out=file), BAD_INPUT,
                         "cannot write into this folder")

    def test_a_load_that_the_soil_cannot_carry_leaves_no_result(self):
        self.write("drawbar.csv", "of an earlier run")
        done = self.drawbar("--slip", "0.1", load=500000)
        self.assertFails(done, BAD_INPUT, "--load: the soil cannot carry 500000 N",
                         "sinks to its axle")
        self.assertEqual(os.listdir(self.folder), [])


class NotSteady(Bin):
    def test_what_never_becomes_steady_is_said_so(self):
        # So light that the wheel hops from node to node of the coarse grid.
        done = self.drawbar("--slip", "0.1", load=1)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(table(self.folder / "drawbar.csv")[0]["steady [-]"], "0")
        self.assertIn("not steady after", done.stderr)
        self.assertIn("not steady", done.stdout)
        self.assertIs(summary_of(self.folder)["steady"], False)

    def test_the_freely_rolling_wheel_counts_too(self):
        done = self.drawbar("--slip", "0.1", load=1)
        summary = summary_of(self.folder)
        self.assertEqual([summary["free_rolling"]["steady"], summary["steady"]], [False, False])
        self.assertIn("the wheel without torque, to which rolling_slip refers", done.stderr)
        done = self.drawbar("--slip", "0.1")
        summary = summary_of(self.folder)
        self.assertEqual([summary["free_rolling"]["steady"], summary["steady"]], [True, True])
        self.assertNotIn("warning", done.stderr)

    def test_digits_are_those_of_the_load(self):
        done = self.drawbar("--slip", "0.3", tire="37x12.5R16.5_15psi", load=165)
        [row] = numbers(self.folder / "drawbar.csv")
        self.assertIn(f"{row['drawbar_pull']:.2f}", done.stdout)


if __name__ == "__main__":
    unittest.main()
