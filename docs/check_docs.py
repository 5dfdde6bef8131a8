#!/usr/bin/env python3
"""Is the code in the docs the code that is compiled, and is everything there that the docs point to?

A fence of C++ in docs/*.md stands under a comment that names where it comes from,

    <!-- examples/memory/placement_new.cpp [one] -->

that is, the lines between `// [one]` and `// [/one]` of that file, less their common indentation; without a name in
brackets, the whole file after its opening comment. (The README's
programs come from nowhere: they are compiled as they stand there, see tests/checks/readme_code.cmake.)

    docs/check_docs.py           compares, and names each fence that differs, each link that leads nowhere
    docs/check_docs.py --write   copies the code into the fences instead
"""

import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
FENCE = re.compile(r"(?:<!-- (?P<file>[^\s>]+)(?: \[(?P<region>\w+)\])? -->\n)?```cpp\n(?P<code>.*?)```", re.DOTALL)
LINK = re.compile(r"(?:\]\(|src=\")(?!https?:|mailto:|#)([^)#\"\s]+)")


def region_of(text, name):
    """The lines of a region, or None."""
    if name is None:
        return re.sub(r"\A(?://[^\n]*\n)+\n?", "", text)
    match = re.search(rf"^[ \t]*// \[{name}\]\n(.*?)^[ \t]*// \[/{name}\]", text, re.DOTALL | re.MULTILINE)
    return textwrap.dedent(match.group(1)) if match else None


def check_page(page, write):
    complaints = []
    text = page.read_text(encoding="utf-8")
    where = page.relative_to(ROOT)

    def judge(match):
        line = text.count("\n", 0, match.start()) + 1
        name, region = match["file"], match["region"]
        if name is None:
            complaints.append(f"{where}:{line}: this C++ names no file that it comes from")
            return match[0]
        source = ROOT / name
        code = region_of(source.read_text(encoding="utf-8"), region) if source.is_file() else None
        if code is None:
            complaints.append(f"{where}:{line}: there is no {name}" + (f" with a region [{region}]" if region else ""))
            return match[0]
        if code != match["code"] and not write:
            complaints.append(f"{where}:{line}: differs from {name}; docs/check_docs.py --write brings it up to date")
        return match[0][: match.start("code") - match.start()] + code + "```"

    updated = text if page.name == "README.md" else FENCE.sub(judge, text)
    if write and updated != text:
        page.write_text(updated, encoding="utf-8")
    for match in LINK.finditer(re.sub(r"```.*?```|`[^`\n]*`", lambda m: " " * len(m[0]), text, flags=re.DOTALL)):
        if not (page.parent / match[1]).exists():
            complaints.append(f"{where}: there is no {match[1]}")
    return complaints, len(FENCE.findall(text))


def main():
    if sys.argv[1:] not in ([], ["--write"]):
        sys.exit(__doc__)
    pages = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
    results = [check_page(page, write=bool(sys.argv[1:])) for page in pages if page.is_file()]
    complaints = [complaint for found, _ in results for complaint in found]
    print("\n".join(complaints) or f"{len(results)} pages, {sum(count for _, count in results)} pieces of code: all as compiled")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
