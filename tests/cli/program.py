"""The program softsoil, as the tests of this folder call it. Expects it first in PATH."""
import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ET

FAILED, BAD_INPUT, NO_SUCH_PROGRAM = 1, 2, 127
COARSE = ["--no-picture", "--set", "grid_spacing=0.05", "--set", "volume_height=0.05", "--set",
          "volumes=15"]
RESULTS = ["contact.csv", "contact.png", "summary.json", "terrain.npy", "terrain.png",
           "wheels.csv"]


def softsoil(*arguments, environment=None, stdout=subprocess.PIPE):
    return subprocess.run(["softsoil", *map(str, arguments)], stdin=subprocess.DEVNULL,
                          stdout=stdout, stderr=subprocess.PIPE, text=True, timeout=300,
                          env={**os.environ, **(environment or {})})


def run(folder, *more, seconds=0.2, scene="hmmwv_flat"):
    return softsoil("run", scene, "--time", seconds, "--out", folder, *more)


def summary_of(folder):
    return json.loads((folder / "summary.json").read_text())


def rows_of(folder, name="wheels.csv"):
    """A dictionary for each row, all numbers but the wheel's name."""
    with open(folder / name, newline="") as file:
        return [{key: text if key == "wheel" else float(text) for key, text in row.items()}
                for row in csv.DictReader(file)]


def scene_in(folder, *changes):
    """A copy of the shipped scene with changes: pairs of old and new text."""
    text = pathlib.Path("models/scenes/hmmwv_flat.xml").read_text()
    vehicles = os.path.relpath("models/vehicles", folder)
    for old, new in (("../vehicles", vehicles), *changes):
        assert old in text, old
        text = text.replace(old, new)
    scene = folder / "scene.xml"
    scene.write_text(text)
    return scene


def loose_soil_in(folder):
    """A file with the soil loose_yolo_loam."""
    soil = ET.parse("models/soils/yolo_loam.xml").getroot().find("soil[@name='tilled_yolo_loam']")
    soil.set("name", "loose_yolo_loam")
    soil.find("compaction").set("initial_density", "950")
    file = folder / "soils.xml"
    file.write_text(f"<soils>{ET.tostring(soil, encoding='unicode')}</soils>")
    return file


class InAFolder(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def assertSaysOneThing(self, done):
        """Besides which soil is under which wheels."""
        lines = [line for line in done.stderr.splitlines() if " under the wheels " not in line]
        self.assertEqual(len(lines), 1, done.stderr)

    def assertFails(self, done, code, *sentences):
        self.assertEqual(done.returncode, code, done.stderr)
        for sentence in sentences:
            self.assertIn(sentence, done.stderr)
