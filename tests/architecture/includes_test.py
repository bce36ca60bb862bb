"""No folder includes what its place in the house forbids.

    terrain  <----  contact  <----+
       ^                          +----  plugin
       +----  cuda  <-------------+

mujoco.h is included in plugin/, its tests in tests/plugin/, tests/faults/ and tests/golden/, tests/benchmark/ and examples/ and
nowhere else. The tests of a folder obey the rule of that folder. Run with no arguments: checks this tree, and that the check itself finds
every kind of breach in a tree made for the purpose.
"""
import pathlib
import posixpath
import re
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

FORBIDDEN = {
    "terrain": {"contact", "cuda", "plugin", "mujoco"},
    "contact": {"cuda", "plugin", "mujoco"},
    "cuda": {"contact", "plugin", "mujoco"},
    "plugin": set(),
    "tests/terrain": {"contact", "cuda", "plugin", "mujoco"},
    "tests/contact": {"cuda", "plugin", "mujoco"},
    "tests/cuda": {"contact", "plugin", "mujoco"},
    "tests/plugin": set(),
    "tests/faults": set(),
    "tests/golden": set(),
    "tests/benchmark": set(),
    "tests": {"mujoco"},
    "examples": set(),
    # An oracle shares nothing with what it judges.
    "tests/reference": {"terrain", "contact", "cuda", "plugin", "mujoco"},
}
CODE_FOLDERS = ("terrain", "contact", "cuda", "plugin")
SUFFIXES = {".h", ".hpp", ".inl", ".c", ".cc", ".cpp", ".cu", ".cuh"}

COMMENT = re.compile(r"/\*.*?\*/", re.S)
DIRECTIVE = re.compile(r"^[ \t]*#[ \t]*(?:include|include_next|import)\b[ \t]*(.*)$", re.M)
OPERAND = re.compile(r'^"([^"]+)"|^<([^>]+)>')


def rule_of(path):
    """The longest entry of FORBIDDEN that holds the file, or None."""
    folders = [str(parent) for parent in pathlib.PurePosixPath(path).parents]
    return next((folder for folder in folders if folder in FORBIDDEN), None)


def target_of(root, path, name, quoted):
    """What an include reaches: a code folder, 'mujoco' or None."""
    if re.search(r"(^|/)(mujoco/|mujoco\.h$|mj[a-z]+\.h$)", name):
        return "mujoco"
    beside = posixpath.normpath(posixpath.join(posixpath.dirname(path), name))
    reached = beside if quoted and (root / beside).is_file() else posixpath.normpath(name)
    parts = [part for part in reached.split("/") if part != ".."]
    return parts[0] if len(parts) > 1 and parts[0] in CODE_FOLDERS else None


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def breaches_in(root, path):
    text = (root / path).read_text(encoding="utf-8")
    text = COMMENT.sub(blank, text.replace("\\\n", "  "))
    folder = rule_of(path)
    for directive in DIRECTIVE.finditer(text):
        where = f"{path}:{text.count(chr(10), 0, directive.start()) + 1}"
        operand = OPERAND.match(directive.group(1))
        if not operand:
            yield f"{where}: an include must name its file, got {directive.group(1).strip()}"
            continue
        name = operand.group(1) or operand.group(2)
        target = target_of(root, path, name, quoted=operand.group(1) is not None)
        if target in FORBIDDEN[folder]:
            yield f"{where}: {folder} never includes {target}, got {name}"


def sources(root):
    files = sorted(path for folder in {key.split("/")[0] for key in FORBIDDEN}
                   for path in (root / folder).rglob("*") if path.suffix in SUFFIXES)
    return [path.relative_to(root).as_posix() for path in files]


def breaches(root):
    return [breach for path in sources(root) for breach in breaches_in(root, path)]


class ThisTree(unittest.TestCase):
    def test_breaks_no_rule(self):
        self.assertEqual(breaches(ROOT), [])

    def test_was_really_read(self):
        folders = {path.split("/")[0] for path in sources(ROOT)}
        self.assertLessEqual({"terrain", "contact"}, folders)


class ABadTree(unittest.TestCase):
    def check(self, path, line, breach):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("contact/wrench.h", path):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text("\n")
            (root / path).write_text(f"#pragma once\n{line}\n")
            self.assertEqual(breaches(root), [f"{path}:2: {breach}"] if breach else [])

    def test_every_forbidden_pair_is_found(self):
        for folder, targets in FORBIDDEN.items():
            for target in targets:
                with self.subTest(folder=folder, target=target):
                    name = "mujoco/mujoco.h" if target == "mujoco" else f"{target}/wrench.h"
                    self.check(f"{folder}/bad.cc", f'#include "{name}"', f"{folder} never includes {target}, got {name}")

    def test_every_way_to_write_it_is_found(self):
        contact = "terrain never includes contact, got "
        mujoco = "terrain never includes mujoco, got "
        for line, breach in {
            "#include <contact/wrench.h>": contact + "contact/wrench.h",
            '  #  include "contact/wrench.h"': contact + "contact/wrench.h",
            '#include /* why */ "contact/wrench.h"': contact + "contact/wrench.h",
            '#include "../contact/wrench.h"': contact + "../contact/wrench.h",
            '#include "./contact/wrench.h"': contact + "./contact/wrench.h",
            '#include "terrain/../contact/wrench.h"': contact + "terrain/../contact/wrench.h",
            "#include <mujoco.h>": mujoco + "mujoco.h",
            "#include <mujoco/mjdata.h>": mujoco + "mujoco/mjdata.h",
            "#include WRENCH": "an include must name its file, got WRENCH",
        }.items():
            with self.subTest(line=line):
                self.check("terrain/bad.h", line, breach)

    def test_deep_folders_obey_the_same_rule(self):
        self.check("contact/tire/bad.cc", "#include <mujoco/mujoco.h>", "contact never includes mujoco, got mujoco/mujoco.h")

    def test_what_is_allowed_is_not_reported(self):
        for path, line in {
            "contact/good.cc": '#include "terrain/soil.h"',
            "cuda/good.cu": '#include "terrain/soil.h"',
            "terrain/good.cc": '#include "terrain/contact.h"',
            "terrain/fine.cc": '/* #include "contact/wrench.h" */',
            "plugin/cli/good.cc": "#include <mujoco/mujoco.h>",
            "tests/plugin/good.cc": "#include <mujoco/mujoco.h>",
            "tests/benchmark/good.cc": "#include <mujoco/mujoco.h>",
        }.items():
            with self.subTest(path=path):
                self.check(path, line, None)


if __name__ == "__main__":
    unittest.main()
