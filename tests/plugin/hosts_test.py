#!/usr/bin/env python3
"""Soft soil in programs that know nothing of it: mujoco-testspeed, mujoco-simulate, a shell,
Python."""

import os
import re
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
LIBRARY = os.path.join(os.environ["SOFTSOIL_BUILD"], "lib", "libsoftsoil.so")
HMMWV = os.path.join(SOURCE, "models", "scenes", "hmmwv_flat.xml")

ONE_WHEEL = """
<mujoco model="one_wheel">
  <option timestep="0.002"/>
  <custom>{custom}</custom>
  <worldbody>
    <geom name="field" type="plane" size="9 9 1" {plane}/>
    <body name="hub" pos="0 0 .4">
      <inertial pos="0 0 0" mass="190" diaginertia="5 5 5"/>
      <joint type="slide" axis="0 0 1" damping="3000"/>
      <body name="wheel">
        <joint axis="0 1 0"/>
        <geom type="cylinder" zaxis="0 1 0" size=".4 .1" mass="10"/>
      </body>
    </body>
  </worldbody>
</mujoco>"""
PROBE = r"probe: wheels 4 load (\S+) weight (\S+) contacts 0"
SOIL = '<text name="softsoil_soil" data="tilled_yolo_loam"/>'


def run(command, preload=(LIBRARY,), timeout=300, **environment):
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=timeout, check=False,
                          env={**os.environ, "LD_PRELOAD": ":".join(preload), **environment})


@unittest.skipIf(os.environ.get("SOFTSOIL_SANITIZE"),
                 "a sanitized library cannot be preloaded into a plain program")
class Hosts(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def scene(self, custom=SOIL, plane='contype="2" conaffinity="0"'):
        path = os.path.join(self.folder.name, "scene.xml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(ONE_WHEEL.format(custom=custom, plane=plane))
        return path

    def probe(self):
        path = os.path.join(self.folder.name, "probe.so")
        subprocess.run(["cc", "-shared", "-fPIC", "-I", SOURCE, "-o", path,
                        os.path.join(HERE, "load_probe.c")], check=True)
        return path

    def test_testspeed_in_two_threads_rests_the_hmmwv_on_soil(self):
        result = run(["mujoco-testspeed", HMMWV, "2010", "2"], preload=(LIBRARY, self.probe()),
                     timeout=800, PROBE_TIME="2")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr.count('softsoil: soil "tilled_yolo_loam"'), 1)
        self.assertNotIn("warning", result.stderr)
        probes = re.findall(PROBE, result.stderr)
        self.assertEqual(len(probes), 2, result.stderr)
        for load, weight in probes:
            self.assertAlmostEqual(float(load) / float(weight), 1, delta=0.01)

    def test_simulate_shows_the_hmmwv_on_soil(self):
        """Preloaded for simulate alone: the probe needs a program with MuJoCo."""
        preload = f"LD_PRELOAD={LIBRARY}:{self.probe()}"
        result = run(["xvfb-run", "-a", "timeout", "200", "env", preload, "PROBE_TIME=2",
                      "PROBE_IS_LAST=1", "mujoco-simulate", HMMWV], preload=())
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn('softsoil: soil "tilled_yolo_loam"', result.stderr)
        self.assertNotIn("softsoil: warning", result.stderr)
        load, weight = re.search(PROBE, result.stderr).groups()
        self.assertAlmostEqual(float(load) / float(weight), 1, delta=0.01)

    def test_rigid_contact_is_gone_from_the_first_step_on_request(self):
        remove = '<text name="softsoil_rigid_contact" data="remove"/>'
        for custom, contacts in ((SOIL, r"[1-9]\S*"), (SOIL + remove, r"0\.00")):
            result = run(["mujoco-testspeed", self.scene(custom, plane=""), "100"])
            self.assertRegex(result.stdout, r"Contacts per step\s*: " + contacts)

    def test_a_bad_model_ends_the_program(self):
        result = run(["mujoco-testspeed", self.scene(SOIL.replace("tilled", "titled")), "10", "2"])
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn('softsoil: softsoil_soil: unknown soil "titled_yolo_loam"; known are: ',
                      result.stderr)

    def test_a_bad_model_goes_on_without_soil_if_so_configured(self):
        result = run(["mujoco-testspeed", self.scene(SOIL.replace("tilled", "titled")), "10", "2"],
                     SOFTSOIL_ON_ERROR="continue")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn("; the model runs without soft soil", result.stderr)

    def test_a_model_that_wants_no_soil_runs_without(self):
        result = run(["mujoco-testspeed", self.scene(custom="", plane=""), "10", "2"])
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr, 'softsoil: model "one_wheel" names no soil (<custom> '
                         '<text name="softsoil_soil">): it runs without\n')

    def test_a_wrong_error_policy_is_refused(self):
        result = run(["mujoco-testspeed", self.scene(), "10"], SOFTSOIL_ON_ERROR="ignore")
        self.assertEqual(result.stderr, "softsoil: SOFTSOIL_ON_ERROR: must be stop or continue, "
                         'got "ignore"; soft soil is off\n')

    def test_processes_without_mujoco_hear_nothing(self):
        result = run(["sh", "-c", "ls / >/dev/null; exit 3"])
        self.assertEqual((result.returncode, result.stdout, result.stderr), (3, "", ""))

    def test_finds_a_mujoco_that_is_loaded_for_one_caller_alone(self):
        code = f"""
import ctypes
mujoco = ctypes.CDLL("libmujoco.so.2.2.2", mode=ctypes.RTLD_LOCAL)
softsoil = ctypes.CDLL({LIBRARY!r})
for function in mujoco.mj_loadXML, mujoco.mj_makeData:
    function.restype = ctypes.c_void_p
softsoil.softsoil_error.restype = ctypes.c_char_p
m = ctypes.c_void_p(mujoco.mj_loadXML({self.scene()!r}.encode(), None, None, 0))
d = ctypes.c_void_p(mujoco.mj_makeData(m))
assert softsoil.softsoil_attach(m, d, None) == 0, softsoil.softsoil_error()
for _ in range(200):
    mujoco.mj_step(m, d)
height = ctypes.c_double(1)
assert softsoil.softsoil_height(d, ctypes.c_double(0), ctypes.c_double(0),
                                ctypes.byref(height)) == 0
print("height", height.value)
assert height.value < -0.001
"""
        result = run([sys.executable, "-c", code], preload=())
        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
