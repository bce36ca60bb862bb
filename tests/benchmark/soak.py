#!/usr/bin/env python3
"""Ten simulated minutes of the HMMWV in a circle on loose loam: does memory level off, does speed
hold?

    python3 tests/benchmark/soak.py [MINUTES] [--keep "MACHINE"]

One row per simulated minute; with --keep they are added to tests/benchmark/soak.csv. Run it on an
idle machine. Takes libsoftsoil.so from SOFTSOIL_BUILD, else from build/release.
"""
import argparse
import ctypes
import os
import pathlib
import tempfile
import time

from keep import keep, show

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
COLUMNS = ["threads", "simulated_time [s]", "soil [MB]", "resident_memory [MB]", "steps/s"]
SETTINGS = (f"soil_file={ROOT}/tests/golden/loose_loam.xml soil=loose_loam grid_spacing=0.05 "
            "volume_height=0.05 volumes=20")
CONTROLS = "0.3 4000 0.1"  # steer [rad], drive [N m] and a brake that limits the speed
STEPS_PER_MINUTE = 60000
LEVEL, STEADY = 1.02, 1.15  # most growth of memory in the last half, most change of speed


class Ground(ctypes.Structure):
    """softsoilGround of plugin/softsoil.h."""
    _fields_ = [("soil", ctypes.c_char_p), ("grid_spacing", ctypes.c_double),
                ("soil_clock", ctypes.c_double), ("threads", ctypes.c_int),
                ("columns", ctypes.c_size_t), ("volumes", ctypes.c_size_t),
                ("bytes", ctypes.c_size_t), ("volume_bytes", ctypes.c_size_t),
                ("rut_volume", ctypes.c_double), ("displaced_volume", ctypes.c_double),
                ("densified_volume", ctypes.c_double), ("berm_volume", ctypes.c_double),
                ("stress", ctypes.c_char_p), ("direct_updates", ctypes.c_size_t),
                ("gaussian_updates", ctypes.c_size_t)]


class Drive:
    def __init__(self):
        build = os.environ.get("SOFTSOIL_BUILD", ROOT / "build/release")
        self.mujoco = ctypes.CDLL("libmujoco.so.2.2.2")
        self.softsoil = ctypes.CDLL(f"{build}/lib/libsoftsoil.so")
        self.softsoil.softsoil_error.restype = ctypes.c_char_p
        for function in self.mujoco.mj_loadXML, self.mujoco.mj_makeData:
            function.restype = ctypes.c_void_p
        self.m = ctypes.c_void_p(self.load())
        self.d = ctypes.c_void_p(self.mujoco.mj_makeData(self.m))
        self.mujoco.mj_resetDataKeyframe(self.m, self.d, 0)
        self.require(self.softsoil.softsoil_attach(self.m, self.d, SETTINGS.encode()))

    def load(self):
        """The scene of the quickstart, its controls held by a keyframe."""
        scene = (ROOT / "models/scenes/hmmwv_flat.xml").read_text()
        vehicles = os.path.relpath(ROOT / "models/vehicles", tempfile.gettempdir())
        scene = scene.replace("../vehicles", vehicles).replace(
            "</mujoco>", f'<keyframe><key ctrl="{CONTROLS}"/></keyframe></mujoco>')
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write(scene)
            file.flush()
            error = ctypes.create_string_buffer(1000)
            m = self.mujoco.mj_loadXML(file.name.encode(), None, error, len(error))
        if not m:
            raise RuntimeError(error.value.decode())
        return m

    def require(self, result):
        if result != 0:
            raise RuntimeError(self.softsoil.softsoil_error().decode())

    def minute(self):
        """Drives on; returns the size of the ground and the steps per second."""
        start = time.monotonic()
        for _ in range(STEPS_PER_MINUTE):
            self.mujoco.mj_step(self.m, self.d)
        speed = STEPS_PER_MINUTE / (time.monotonic() - start)
        ground = Ground()
        self.require(self.softsoil.softsoil_ground(self.d, ctypes.byref(ground)))
        return ground, speed


def resident_memory():
    """[MB] of this process."""
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def verdict(rows):
    """Whether memory levels off and speed holds, in words."""
    soil, resident, speed = ([row[k] for row in rows] for k in (2, 3, 4))
    half = len(rows) // 2
    says = []
    for name, values in (("soil", soil), ("resident memory", resident)):
        growth = values[-1] / values[half]
        says.append(f"{name} {'levels off' if growth < LEVEL else 'GROWS ON'}: "
                    f"x {growth:.3f} in the last half")
    drift = speed[-1] / speed[half]
    says.append(f"speed {'holds' if 1 / STEADY < drift < STEADY else 'DRIFTS'}: "
                f"x {drift:.3f} in the last half")
    return "\n".join(says)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("minutes", nargs="?", type=int, default=10)
    parser.add_argument("--keep", metavar="MACHINE")
    arguments = parser.parse_args()
    drive, rows = Drive(), []
    for minute in range(1, arguments.minutes + 1):
        ground, speed = drive.minute()
        rows.append([ground.threads, 60 * minute, round(ground.bytes / 1e6, 2),
                     round(resident_memory(), 1), round(speed)])
        show(COLUMNS, rows[-1])
        if arguments.keep:
            keep(HERE / "soak.csv", arguments.keep, COLUMNS, rows[-1])
    print(verdict(rows))


if __name__ == "__main__":
    main()
