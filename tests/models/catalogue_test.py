"""Files in models/ agree with one another: scenes name soils and tires that there are, and every number in the
catalogues says which publication it is from or that it is our choice.
"""
import pathlib
import re
import unittest
import xml.etree.ElementTree as ET

MODELS = pathlib.Path(__file__).resolve().parents[2] / "models"
SOURCE = re.compile(r"\b(19|20)\d\d\b|\bour choice\b|\bnominal\b|\bestimated\b")


def entries(kind):
    return [entry for path in sorted((MODELS / f"{kind}s").glob("*.xml"))
            for entry in ET.parse(path).getroot().iter(kind)]


def chosen(path, key):
    """What a scene says in <custom><text name="softsoil_KEY" data="..."/>."""
    texts = ET.parse(path).getroot().iter("text")
    return [text.get("data") for text in texts if text.get("name") == f"softsoil_{key}"]


class Catalogues(unittest.TestCase):
    def test_say_where_every_number_comes_from(self):
        groups = [group for kind in ("soil", "tire") for entry in entries(kind) for group in entry]
        self.assertGreater(len(groups), 40)
        for group in groups:
            self.assertRegex(group.get("source", ""), SOURCE)

    def test_have_one_entry_of_a_name(self):
        for kind in ("soil", "tire"):
            names = [entry.get("name") for entry in entries(kind)]
            self.assertEqual(sorted(names), sorted(set(names)))

    def test_describe_every_entry(self):
        for kind in ("soil", "tire"):
            for entry in entries(kind):
                self.assertTrue(entry.get("description"), entry.get("name"))


class Scenes(unittest.TestCase):
    def test_name_soils_and_tires_that_there_are(self):
        soils = {entry.get("name") for entry in entries("soil")}
        tires = {entry.get("name") for entry in entries("tire")}
        scenes = sorted((MODELS / "scenes").glob("*.xml"))
        self.assertGreaterEqual(len(scenes), 3)
        for scene in scenes:
            with self.subTest(scene=scene.name):
                self.assertEqual(len(chosen(scene, "soil")), 1)
                self.assertLessEqual(set(chosen(scene, "soil")), soils)
                used = {part.split("=")[-1] for text in chosen(scene, "tire") for part in text.split()}
                self.assertTrue(used)
                self.assertLessEqual(used, tires)


if __name__ == "__main__":
    unittest.main()
