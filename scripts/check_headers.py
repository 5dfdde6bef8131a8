#!/usr/bin/env python3
"""Is every public header fit to be included by a stranger?

Each one compiles alone with all warnings as errors, and all of them without exceptions and RTTI; none defines a macro or brings
in a heavy header; and all of them together cost little compile time over the GLM headers that they need.

    scripts/check_headers.py alone --compiler g++         every header by itself
    scripts/check_headers.py clean --compiler g++         no macros, no heavy headers
    scripts/check_headers.py cost --compiler g++          what <surefoot/surefoot.hpp> costs
"""

import argparse
import re
import resource
import statistics
import subprocess
import sys
import tempfile

from sources import ROOT, project_files

INCLUDE_FOLDERS = ("include", "import/include", "navigation/include")
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Wold-style-cast", "-Wnon-virtual-dtor",
            "-Werror"]
HEAVY = {"iostream", "filesystem", "functional", "windows.h", "regex", "thread", "sstream", "fstream"}
ROUNDS = 7


def public_headers(folders=INCLUDE_FOLDERS):
    return [path for path in project_files((".hpp",)) if any(str(path).startswith(f + "/") for f in folders)]


def name_in_include(path):
    return str(path)[str(path).index("surefoot/"):]


def compiler(arguments, *options):
    folders = [f"-I{ROOT / folder}" for folder in INCLUDE_FOLDERS if (ROOT / folder).is_dir()]
    return [arguments.compiler, "-std=c++20", *folders, *options]


def run(command, text):
    return subprocess.run([*command, "-x", "c++", "-"], input=text, capture_output=True, text=True)


def alone(arguments):
    good = True
    headers = public_headers()
    # Twice: it must stand on its own feet, and stand a second inclusion.
    texts = {str(path): f"#include <{name_in_include(path)}>\n" * 2 for path in headers}
    checks = [(name, text, []) for name, text in texts.items()]
    # Exceptions and RTTI are not a matter of what comes first: one look at all of them will do.
    checks.append(("all public headers", "".join(texts.values()), ["-fno-exceptions", "-fno-rtti"]))
    # Whether a header stands on its own feet is no matter of the compiler: for a second one all of them together will do.
    for name, text, options in checks[-1:] if arguments.together else checks:
        done = run(compiler(arguments, *WARNINGS, *options, "-fsyntax-only"), text)
        if done.returncode != 0:
            print(f"{name} does not compile {' '.join(options) or 'alone'}:\n{done.stderr}")
            good = False
    print(f"{len(headers)} public headers, {'' if arguments.together else 'each alone, and '}all without exceptions and RTTI")
    return good


def system_includes(headers):
    """What the public headers include that is not Surefoot's, as text."""
    found = set()
    for path in headers:
        found |= set(re.findall(r"^\s*#\s*include\s*(<[^>]+>)", (ROOT / path).read_text(), re.MULTILINE))
    return "".join(f"#include {name}\n" for name in sorted(found) if not name.startswith("<surefoot/"))


def macros(arguments, text):
    done = run(compiler(arguments, "-dM", "-E"), text)
    if done.returncode != 0:
        sys.exit(done.stderr)
    return {line.split()[1].split("(")[0] for line in done.stdout.splitlines() if line.startswith("#define")}


def clean(arguments):
    good = True
    headers = public_headers()
    all_headers = "".join(f"#include <{name_in_include(path)}>\n" for path in headers)
    ours = macros(arguments, all_headers) - macros(arguments, system_includes(headers))
    if ours:
        print(f"the public headers define macros: {', '.join(sorted(ours))}")
        good = False
    for path in headers:
        for name in re.findall(r"#\s*include\s*[<\"]([^>\"]+)[>\"]", (ROOT / path).read_text()):
            if name in HEAVY:
                print(f"{path} includes <{name}>")
                good = False
    abi = re.compile(r"^inline namespace v0 \{", re.MULTILINE)
    for path in headers:
        text = (ROOT / path).read_text()
        if "namespace" in text and not abi.search(text):
            print(f"{path} does not put its names into the inline namespace of the ABI")
            good = False
    print(f"{len(headers)} public headers: no macros, nothing heavy, all names in surefoot::v0")
    return good


def seconds(command, text):
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as source:
        source.write(text)
        source.flush()
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([*command, "-c", "-o", "/dev/null", source.name], check=True)
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def cost(arguments):
    glm_only = "".join(line + "\n" for line in system_includes(public_headers(("include",))).splitlines() if "glm" in line)
    face = glm_only + "#include <string>\n#include <tl/expected.hpp>\n"
    texts = {"the GLM headers it uses": glm_only, "they, <string> and expected": face,
             "<surefoot/surefoot.hpp>": "#include <surefoot/surefoot.hpp>\n"}
    lines, times = {}, {title: [] for title in texts}
    for title, text in texts.items():
        preprocessed = run(compiler(arguments, "-E", "-P"), text).stdout
        lines[title] = sum(1 for line in preprocessed.splitlines() if line.strip())
    for _ in range(ROUNDS):  # taking turns, so that a busy machine slows both
        for title, text in texts.items():
            times[title].append(seconds(compiler(arguments), text))
    for title in texts:
        print(f"{title:28}{lines[title]:8} lines  {min(times[title]):.3f} s  "
              f"(best of {ROUNDS}, user CPU; median {statistics.median(times[title]):.3f} s)")
    base, floor, whole = texts
    added_seconds = min(times[whole]) - min(times[base])  # noise only ever adds
    added_lines = lines[whole] - lines[base]
    print(f"{'added by what errors need':28}{lines[floor] - lines[base]:8} lines  "
          f"{min(times[floor]) - min(times[base]):.3f} s")
    print(f"{'added':28}{added_lines:8} lines  {added_seconds:.3f} s (aim: at most {arguments.seconds} s)")
    # The aim is for a quiet machine; a shared one takes up to a few times as long, and a test must not fail for that.
    # What does not depend on the machine is how much there is to read, so that is bounded tightly.
    return added_lines <= arguments.lines and added_seconds <= 4 * arguments.seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("alone", "clean", "cost"))
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--together", action="store_true", help="with `alone`: all of them in one file and no more")
    parser.add_argument("--seconds", type=float, default=0.3, help="aim for the added compile time")
    parser.add_argument("--lines", type=int, default=32500, help="bound on the added preprocessed lines")
    arguments = parser.parse_args()
    sys.exit(0 if {"alone": alone, "clean": clean, "cost": cost}[arguments.what](arguments) else 1)


if __name__ == "__main__":
    main()
