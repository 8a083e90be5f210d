"""Checks all documents: that links lead somewhere, and that none is too long to be read.

documents.py [--self-test]
"""

import argparse
import re
import sys
from pathlib import Path
from urllib.parse import unquote

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("app", "engine", "hydro", "scenes", "shaders", "tests", "tools")
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
    """The links of a document, (line, target), without those to other sites."""
    prose = prose_of(text)
    for match in re.finditer(r"\]\(([^()\s]+)\)", prose):
        if not re.match(r"[a-z]+:", match[1]):
            yield prose.count("\n", 0, match.start()) + 1, unquote(match[1])


def faults_of_links(name, text):
    """Links of a document that lead nowhere."""
    for line, target in links_of(text):
        path, _, anchor = target.partition("#")
        place = (ROOT / name).parent / path if path else ROOT / name
        if not place.exists():
            yield f"{name}:{line}: {target}: there is no such file"
        elif anchor and anchor not in anchors_of(place.read_text(encoding="utf-8")):
            yield f"{name}:{line}: {target}: the document has no such heading"


def faults():
    found = []
    for name in documents():
        text = (ROOT / name).read_text(encoding="utf-8")
        found += faults_of_links(name, text)
        lines = text.count("\n")
        if lines > LONGEST and name not in MAY_BE_LONG:
            found.append(f"{name}: has {lines} lines, at most {LONGEST} are allowed")
    return found + [f"{name}: the table of long documents names it, but it is none"
                    for name in set(MAY_BE_LONG) - set(documents())]


def self_test():
    """Finds broken links and passes right ones."""
    text = "\n".join(["# A `b.csv` of Bodies' waves", "## Log", "## Log", "[a](#log) [b](#log-1)",
                      "[c](#a-bcsv-of-bodies-waves) `[d](#none)`", "```", "[e](nowhere.md)", "```",
                      "[f](https://example.org/x) [g", "h](#none) [i](no/such/file.md)"])
    assert anchors_of(text) == {"a-bcsv-of-bodies-waves", "log", "log-1"}, anchors_of(text)
    assert [line for line, _ in links_of(text)] == [4, 4, 5, 10, 10]
    name = "tests/README.md"
    broken = [fault.split(": ")[1] for fault in faults_of_links(name, text)]
    assert broken[-1] == "no/such/file.md", broken


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
