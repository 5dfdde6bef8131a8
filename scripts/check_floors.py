#!/usr/bin/env python3
"""Does every #include go downwards? Reads scripts/floors.txt, scans all C++ files, names each include that does not.

    scripts/check_floors.py              checks this project
    scripts/check_floors.py --self-test  builds small broken houses and sees that each fault is found
    scripts/check_floors.py --root DIR   checks another tree, which has its own scripts/floors.txt
"""

import argparse
import pathlib
import re
import sys
import tempfile

from sources import ROOT, project_files

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


class Plan:
    """floors.txt, read."""

    def __init__(self, path):
        self.floor, self.may, self.folders = {}, {}, {}
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            words = line.split("#")[0].split()
            if not words:
                continue
            kind, name, rest = words[0], words[1], words[2:]
            if kind == "floor":
                self.floor.update({concept: int(name) for concept in rest})
            elif kind == "may":
                self.may[name] = set(rest)
            elif kind == "folder":
                self.folders[name] = set(rest)
            else:
                sys.exit(f"{path}:{number}: '{kind}' is not floor, may or folder")

    def concept_of(self, path):
        """The concept that owns a file of include/surefoot/ or src/, or None."""
        inside = path.parts[2:] if path.parts[0] == "include" else path.parts[1:]
        name = inside[0] if len(inside) > 1 else pathlib.PurePosixPath(inside[0]).stem
        while name:
            if name in self.floor:
                return name
            name = name.rpartition("_")[0]
        return None


def resolve(files, source, mark, target):
    """The project's file that an include means; None for a system header; False for one of ours that is nowhere."""
    nearby = [source.parent / target] if mark == '"' else []
    for candidate in [*nearby, *(pathlib.PurePosixPath(base) / target for base in ("include", "src", "."))]:
        if normal(candidate) in files:
            return normal(candidate)
    if mark == "<" and not target.startswith("surefoot/"):
        return None
    # The wings have include folders of their own: anything whose path ends so, of the same wing if there is a choice.
    ends = [path for path in sorted(files) if str(path).endswith("/" + target)]
    return next((path for path in ends if path.parts[0] == source.parts[0]), ends[0] if ends else False)


def normal(path):
    """Without `..`, which PurePosixPath leaves in."""
    parts = []
    for part in path.parts:
        if part == ".." and parts:
            parts.pop()
        else:
            parts.append(part)
    return pathlib.PurePosixPath(*parts)


def is_core(path):
    return path.parts[0] in ("include", "src")


def judge_include(plan, source, target):
    """Why this include breaks the plan, or None."""
    if is_core(source):
        if not is_core(target):
            return f"the core includes {target.parts[0]}/"
        if target.parts[0] == "src" and source.parts[0] == "include":
            return "a public header includes a private one"
        upper, lower = plan.concept_of(source), plan.concept_of(target)
        for path, concept in ((source, upper), (target, lower)):
            if concept is None:
                return f"{path} belongs to no concept in scripts/floors.txt; give it a floor"
        if upper == lower or plan.floor[lower] < plan.floor[upper]:
            return None
        if plan.floor[lower] > plan.floor[upper]:
            return f"'{upper}' on floor {plan.floor[upper]} includes '{lower}' on floor {plan.floor[lower]}"
        if lower not in plan.may.get(upper, ()):
            return f"siblings: nothing in scripts/floors.txt says that '{upper}' may include '{lower}'"
        return None
    folder = source.parts[0]
    kind = {"include": "core", "src": "private"}.get(target.parts[0], target.parts[0])
    if folder not in plan.folders:
        return f"the folder {folder}/ is not in scripts/floors.txt"
    if kind not in plan.folders[folder]:
        return f"{folder}/ may not include {'the core' if kind == 'core' else str(target.parent) + '/'}"
    return None


def find_circle(edges):
    """A list of names that lead back to the first, or None."""
    done, trail = set(), []

    def visit(node):
        if node in trail:
            return trail[trail.index(node):] + [node]
        if node in done:
            return None
        trail.append(node)
        for following in sorted(edges.get(node, ())):
            circle = visit(following)
            if circle:
                return circle
        trail.pop()
        done.add(node)
        return None

    for node in sorted(edges):
        circle = visit(node)
        if circle:
            return circle
    return None


def check(root):
    """All complaints about the tree at `root`, and how many includes were looked at."""
    plan = Plan(root / "scripts" / "floors.txt")
    complaints, files, concepts, count = [], {}, {}, 0
    known = project_files((".hpp", ".cpp"), root)
    existing = set(known)
    for source in known:
        for number, line in enumerate((root / source).read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            where, target = f"{source}:{number}", resolve(existing, source, *match.groups())
            if target is False:
                complaints.append(f"{where}: there is no file {match.group(2)}")
                continue
            if target is None:
                continue
            count += 1
            files.setdefault(str(source), set()).add(str(target))
            why = judge_include(plan, source, target)
            if why:
                complaints.append(f"{where}: {match.group(2)}: {why}")
            elif is_core(source) and plan.concept_of(source) != plan.concept_of(target):
                concepts.setdefault(plan.concept_of(source), set()).add(plan.concept_of(target))
    for edges in (files, concepts):
        circle = find_circle(edges)
        if circle:
            complaints.append("a circle: " + " -> ".join(circle))
    return complaints, count


BROKEN_HOUSES = {  # what is wrong: {file: text}, and a word that the complaint must hold
    "a floor above": ({"include/surefoot/math.hpp": "#include <surefoot/sweep.hpp>"}, "floor 0 includes 'sweep'"),
    "a sibling": ({"src/overlap.cpp": "#include <surefoot/ray.hpp>"}, "siblings"),
    "a private header made public": ({"include/surefoot/ray.hpp": '#include "vec.hpp"'}, "private"),
    "a circle of files": ({"src/sweep/a.hpp": '#include "b.hpp"', "src/sweep/b.hpp": '#include "a.hpp"'}, "circle"),
    "a judge that knows the accused": ({"judge/judge.cpp": "#include <surefoot/math.hpp>"}, "may not include the core"),
    "a core that knows a wing": ({"src/mesh.cpp": '#include "import/obj.hpp"', "import/obj.hpp": ""}, "import/"),
    "a file without a floor": ({"src/vec.hpp": '#include "loft.hpp"', "src/loft.hpp": ""}, "give it a floor"),
    "a missing file": ({"src/vec.hpp": '#include "nowhere.hpp"'}, "no file nowhere.hpp"),
}
SOUND_HOUSE = {
    "include/surefoot/math.hpp": "#include <glm/vec3.hpp>", "src/vec.hpp": "#include <surefoot/math.hpp>",
    "include/surefoot/sweep.hpp": "#include <surefoot/math.hpp>",
    "include/surefoot/ray.hpp": "#include <surefoot/sweep.hpp>",
    "src/sweep/face.cpp": '#include "vec.hpp"\n#include <surefoot/sweep.hpp>',
    "judge/judge.hpp": "", "judge/judge.cpp": '#include "judge.hpp"',
}


def self_test():
    good = True
    for title, (change, word) in {"a sound house": ({}, None), **BROKEN_HOUSES}.items():
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            plan = {"scripts/floors.txt": (ROOT / "scripts" / "floors.txt").read_text(encoding="utf-8")}
            for name, text in {**plan, **SOUND_HOUSE, **change}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            complaints, _ = check(root)
            found = any(word in complaint for complaint in complaints) if word else not complaints
            print(f"{'ok' if found else 'NOT AS IT SHOULD BE':20}{title}: {complaints[:1] or 'no complaint'}")
            good = good and found
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--self-test", action="store_true", help="see that broken houses are found")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="check another tree")
    arguments = parser.parse_args()
    if arguments.self_test:
        sys.exit(0 if self_test() else 1)
    complaints, count = check(arguments.root)
    print("\n".join(complaints) or f"{count} includes, every one of them downwards")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
