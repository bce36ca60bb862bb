"""softsoil list, with, --help and --version."""
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from program import BAD_INPUT, NO_SUCH_PROGRAM, InAFolder, softsoil


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


LIBRARY = pathlib.Path(shutil.which("softsoil")).resolve().parents[1] / "lib/libsoftsoil.so"


def is_sanitized(library):
    return "san.so" in subprocess.run(["ldd", library], stdout=subprocess.PIPE, text=True).stdout


@unittest.skipIf(is_sanitized(LIBRARY), "a sanitizer must be preloaded before everything else")
@unittest.skipIf(os.environ.get("SOFTSOIL_SANITIZE"),
                 "a sanitized library cannot be preloaded into a plain program")
class With(InAFolder):
    PRINT = "import os; print([os.environ.get(k) for k in ('LD_PRELOAD', 'SOFTSOIL_ON_ERROR')])"

    def seen_by(self, *options, environment=None):
        done = softsoil("with", *options, "--", sys.executable, "-c", self.PRINT,
                        environment=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_preloads_the_library(self):
        self.assertEqual(self.seen_by(environment={"LD_PRELOAD": ""}),
                         f"['{LIBRARY}', None]\n")

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
        for command in ([], ["run"], ["list"], ["with"], ["soil"], ["fit-tire"], ["wong-reece"],
                        ["drawbar"]):
            done = softsoil(*command, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn("Usage: softsoil", done.stdout)

    def test_version(self):
        self.assertRegex(softsoil("--version").stdout, r"^\d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    unittest.main()
