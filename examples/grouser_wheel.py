"""Writes the mesh of a rigid wheel with straight grousers across it, as OBJ in metres, about the y axis.

  grouser_wheel.py RADIUS WIDTH [--grousers COUNT --height HEIGHT --thickness THICKNESS] > wheel.obj

RADIUS is that of the drum; grousers of HEIGHT stand on it. Without grousers it is smooth.
"""
import argparse
import math


def corners_of(theta, distance, along):
    """The point at a distance from the axis in the direction theta, and so far along the rim."""
    return (distance * math.sin(theta) + along * math.cos(theta), distance * math.cos(theta) - along * math.sin(theta))


def outline(radius, grousers, height, thickness, facets=120):
    """Corners of the wheel's outline in the x, z plane, clockwise seen along +y."""
    if grousers == 0:
        return [corners_of(2 * math.pi * k / facets, radius, 0) for k in range(facets)]
    pitch, half = 2 * math.pi / grousers, math.asin(thickness / 2 / radius)
    between = max(1, round(facets / grousers))
    points = []
    for g in range(grousers):
        foot = radius * math.cos(half)
        for distance, along in ((foot, -1), (radius + height, -1), (radius + height, 1), (foot, 1)):
            points.append(corners_of(g * pitch, distance, along * thickness / 2))
        for k in range(1, between):
            points.append(corners_of(g * pitch + half + (pitch - 2 * half) * k / between, radius, 0))
    return points


def obj(points, width):
    """The prism over the outline: two discs and the tread between them."""
    n = len(points)
    lines = [f"v 0 {-width / 2:g} 0", f"v 0 {width / 2:g} 0"]
    lines += [f"v {x:.9g} {y:g} {z:.9g}" for y in (-width / 2, width / 2) for x, z in points]
    for k in range(n):
        a, b = 3 + k, 3 + (k + 1) % n  # OBJ counts from 1
        lines += [f"f 1 {b} {a}", f"f 2 {a + n} {b + n}", f"f {a} {b} {b + n} {a + n}"]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("radius", type=float, help="of the drum [m]")
    parser.add_argument("width", type=float, help="[m]")
    parser.add_argument("--grousers", type=int, default=0)
    parser.add_argument("--height", type=float, default=0.01, help="of a grouser [m]")
    parser.add_argument("--thickness", type=float, default=0.002, help="of a grouser [m]")
    options = parser.parse_args()
    points = outline(options.radius, options.grousers, options.height, options.thickness)
    print(obj(points, options.width))


if __name__ == "__main__":
    main()
