"""libsoftsoil.so exports the C API of plugin/softsoil.h, nothing else, and does not need libmujoco."""
import os
import pathlib
import re
import subprocess
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LIBRARY = pathlib.Path(os.environ["SOFTSOIL_BUILD"]) / "lib" / "libsoftsoil.so"


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Exports(unittest.TestCase):
    def test_are_the_functions_that_the_header_declares(self):
        header = re.sub(r"//[^\n]*|/\*.*?\*/", "", (SOURCE / "plugin/softsoil.h").read_text(), flags=re.S)
        declared = set(re.findall(r"\b(softsoil_\w+)\s*\(", header))
        self.assertTrue(declared, "plugin/softsoil.h declares no function")
        lines = run("nm", "--dynamic", "--defined-only", "--format=posix", LIBRARY).splitlines()
        exported = {line.split()[0] for line in lines}
        self.assertEqual(exported, declared)

    def test_library_does_not_need_libmujoco(self):
        needed = re.findall(r"NEEDED.*\[(.*)\]", run("readelf", "--dynamic", "--wide", LIBRARY))
        self.assertTrue(needed)
        self.assertFalse([name for name in needed if "mujoco" in name])


if __name__ == "__main__":
    unittest.main()
