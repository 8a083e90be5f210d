"""Finds constants of a source file's own that hide one of a header where files are compiled as one.

The source files of a library share one unnamed namespace in a unity build. A constant that one of
them has there is found before a header's of the same name in the enclosing namespace: another file
would silently compute with the wrong one.
"""

import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIBRARIES = ("hydro", "engine", "app", "tests")
CONSTANT = re.compile(r"^(?:inline )?constexpr [^=({]*?\b(k[A-Z]\w*)", re.M)
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{$", re.M)
UNNAMED = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.S | re.M)


def main():
    shared = collections.defaultdict(set)
    own = []
    for library in LIBRARIES:
        for path in sorted((ROOT / library).rglob("*.h")) + sorted((ROOT / library).rglob("*.cpp")):
            text = path.read_text()
            space = NAMESPACE.search(text)
            space = space.group(1) if space else ""
            if path.suffix == ".h":
                for name in CONSTANT.findall(text):
                    shared[space, name].add(str(path.relative_to(ROOT)))
            else:
                own += [(path, space, name) for block in UNNAMED.findall(text)
                        for name in CONSTANT.findall(block)]
    faults = [f"{path.relative_to(ROOT)}: {name} hides that of {', '.join(sorted(headers))}"
              for path, space, name in own if (headers := shared.get((space, name)))]
    print("\n".join(faults) or f"{len(own)} constants of source files hide none of a header")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
