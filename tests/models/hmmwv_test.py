"""The HMMWV of models/ as MuJoCo compiles it: masses, places and links."""
import pathlib
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ET

SCENE = pathlib.Path(__file__).resolve().parents[2] / "models/scenes/hmmwv_flat.xml"
CORNERS = ("fl", "fr", "rl", "rr")


def place(body):
    return [float(word) for word in body.get("pos", "0 0 0").split()]


class Hmmwv(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            compiled = pathlib.Path(folder) / "hmmwv.xml"
            subprocess.run(["mujoco-compile", SCENE, compiled], check=True, cwd=folder,
                           stdout=subprocess.DEVNULL, timeout=60)
            cls.root = ET.parse(compiled).getroot()
        cls.chassis = cls.root.find("worldbody/body[@name='chassis']")
        cls.uprights = {corner: cls.chassis.find(f"body[@name='upright_{corner}']")
                        for corner in CORNERS}

    def test_has_the_published_mass(self):
        masses = [float(inertial.get("mass")) for inertial in self.chassis.iter("inertial")]
        self.assertEqual(len(masses), 10)  # chassis, rack, uprights, wheels
        self.assertAlmostEqual(sum(masses), 2484.9, delta=0.1)

    def test_has_the_published_wheelbase_and_track(self):
        wheels = {}
        for corner, upright in self.uprights.items():
            wheel = upright.find(f"body[@name='wheel_{corner}']")
            wheels[corner] = [a + b for a, b in zip(place(upright), place(wheel))]
        for side in "lr":
            self.assertAlmostEqual(wheels["f" + side][0] - wheels["r" + side][0], 3.30)
        for axle in "fr":
            self.assertAlmostEqual(wheels[axle + "l"][1] - wheels[axle + "r"][1], 1.82)

    def test_holds_every_upright_by_four_links_and_a_spring_with_damper(self):
        on_chassis = {site.get("name") for site in self.chassis.findall("site")}
        of_constant_length = {equality.get("tendon1")
                              for equality in self.root.findall("equality/tendon")}
        for corner, upright in self.uprights.items():
            on_upright = {site.get("name") for site in upright.findall("site")}
            tendons = {tendon.get("name"): tendon for tendon in self.root.findall("tendon/spatial")}
            links = [f"{corner}_{arm}_{end}" for arm in ("upper", "lower")
                     for end in ("front", "rear")]
            for name in [*links, f"{corner}_shock"]:
                start, end = [site.get("site") for site in tendons[name].findall("site")]
                self.assertIn(start, on_chassis)
                self.assertIn(end, on_upright)
            self.assertLessEqual(set(links), of_constant_length)
            shock = tendons[f"{corner}_shock"]
            self.assertNotIn(f"{corner}_shock", of_constant_length)
            self.assertGreater(float(shock.get("stiffness")), 0)
            self.assertGreater(float(shock.get("damping")), 0)

    def test_drives_four_wheels_equally(self):
        driven = {joint.get("joint"): float(joint.get("coef")) for joint in
                  self.root.findall("tendon/fixed[@name='drive_shaft']/joint")}
        self.assertEqual(driven, {f"{corner}_spin": 0.25 for corner in CORNERS})
        motor = self.root.find("actuator/*[@name='drive']")
        self.assertEqual(motor.get("tendon"), "drive_shaft")


if __name__ == "__main__":
    unittest.main()
