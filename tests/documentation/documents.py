"""Checks all documents: that links lead somewhere, that none is too long to be read, and that each
task of scenes/GUIDE.md has its picture.

documents.py [--self-test]
"""

import argparse
import re
import sys
from pathlib import Path
from urllib.parse import unquote

from documented_scenes import GUIDE, titles_of

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("app", "engine", "hydro", "scenes", "shaders", "tests", "tools")
PICTURES = "pictures/guide"  # Folder of the pictures of the tasks, beside the guide.
LONGEST = 300  # Lines. A longer document is two.
# Documents that may be longer, and why.
MAY_BE_LONG = {"scenes/KEYS.md": "is a reference, whose tables are generated",
               "app/COMMANDS.md": "is generated from the program's help"}


def documents():
    """The paths of all documents, relative to the root."""
    found = [ROOT / "README.md"]
    for folder in FOLDERS:
        found += (path for path in (ROOT / folder).rglob("*.md") if "node_modules" not in path.parts)
    return sorted(str(path.relative_to(ROOT)) for path in found)


def prose_of(text):
    """A document without its code: links in it are no links. Line numbers stay."""
    blanked = re.sub(r"^```.*?^```$", lambda m: "\n" * m[0].count("\n"), text,
                     flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"`[^`\n]*`", lambda m: "`" + "x" * (len(m[0]) - 2) + "`", blanked)


def anchors_of(text):
    """The anchors of the headings of a document, as GitHub makes them."""
    found, counts = set(), {}
    blanked = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    for heading in re.findall(r"^#{1,6} +(.+?) *$", blanked, flags=re.MULTILINE):
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        found.add(name if not counts.get(name) else f"{name}-{counts[name]}")
        counts[name] = counts.get(name, 0) + 1
    return found


def links_of(text):
    """The links and pictures of a document, (line, target), without those of other sites."""
    prose = prose_of(text)
    for match in re.finditer(r'\]\(([^()\s]+)\)|<img\b[^>]*\bsrc="([^"]+)"', prose):
        target = match[1] or match[2]
        if not re.match(r"[a-z]+:", target):
            yield prose.count("\n", 0, match.start()) + 1, unquote(target)


def faults_of_links(name, text):
    """Links of a document that lead nowhere."""
    for line, target in links_of(text):
        path, _, anchor = target.partition("#")
        place = (ROOT / name).parent / path if path else ROOT / name
        if not place.exists():
            yield f"{name}:{line}: {target}: there is no such file"
        elif anchor and anchor not in anchors_of(place.read_text(encoding="utf-8")):
            yield f"{name}:{line}: {target}: the document has no such heading"


def faults_of_pictures(text, files):
    """Tasks of the guide that do not have one picture each, and files that are the picture of none."""
    titles = titles_of(text.split("\n"))
    shown = {title: [] for title in titles if title is not None}
    for line, target in links_of(text):
        if target.startswith(f"{PICTURES}/"):
            shown.setdefault(titles[line - 1], []).append(target)
    for title, targets in shown.items():
        if title is None or len(targets) != 1:
            yield f"{GUIDE}: {title}: has {len(targets)} pictures of {PICTURES}, each task has one"
    used = {target for targets in shown.values() for target in targets}
    for name in sorted(files):
        if f"{PICTURES}/{name}" not in used:
            yield f"{PICTURES}/{name}: is the picture of no task of {GUIDE}"


def faults():
    found = []
    for name in documents():
        text = (ROOT / name).read_text(encoding="utf-8")
        found += faults_of_links(name, text)
        lines = text.count("\n")
        if lines > LONGEST and name not in MAY_BE_LONG:
            found.append(f"{name}: has {lines} lines, at most {LONGEST} are allowed")
    guide = ROOT / GUIDE
    found += faults_of_pictures(guide.read_text(encoding="utf-8"),
                                [path.name for path in (guide.parent / PICTURES).glob("*")])
    return found + [f"{name}: the table of long documents names it, but it is none"
                    for name in set(MAY_BE_LONG) - set(documents())]


def self_test():
    """Finds broken links and missing and unused pictures, and passes right ones."""
    text = "\n".join(["# A `b.csv` of Bodies' waves", "## Log", "## Log", "[a](#log) [b](#log-1)",
                      "[c](#a-bcsv-of-bodies-waves) `[d](#none)`", "```", "[e](nowhere.md)", "```",
                      "[f](https://example.org/x) [g", "h](#none) [i](no/such/file.md)"])
    assert anchors_of(text) == {"a-bcsv-of-bodies-waves", "log", "log-1"}, anchors_of(text)
    assert [line for line, _ in links_of(text)] == [4, 4, 5, 10, 10]
    name = "tests/README.md"
    broken = [fault.split(": ")[1] for fault in faults_of_links(name, text)]
    assert broken[-1] == "no/such/file.md", broken
    picture = '<img align="right" src="pictures/guide/{}.png" alt="a">'
    shown = "# a\n" + picture.format("none")
    assert list(links_of(shown)) == [(2, "pictures/guide/none.png")], list(links_of(shown))
    assert "no such file" in next(faults_of_links(GUIDE, shown))
    guide = "\n".join(["### Swim", picture.format("swim") + "Words", "### Dive", "`" + picture.format("dive") + "`",
                       "### Row", picture.format("row") + picture.format("again")])
    wrong = [fault.split(": ")[-2:] for fault in faults_of_pictures(guide, ["swim.png", "row.png", "dive.png"])]
    assert [place for place, _ in wrong] == ["Dive", "Row", "pictures/guide/dive.png"], wrong
    assert not list(faults_of_pictures("\n".join(guide.split("\n")[:2]), ["swim.png"]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--self-test", action="store_true")
    if parser.parse_args().self_test:
        return self_test()
    found = faults()
    print("\n".join(found) or f"{len(documents())} documents have right links")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
