"""Checks that every key of a scene occurs in a scene under scenes/.

shown_keys.py PROGRAM [--self-test]

A key is a path as `plimsoll schema --markdown` prints it, `bodies[].mesh.cap` for example. It counts
where a scene, or a file that a scene includes, has a value at this path.
"""

import re
import subprocess
import sys
from pathlib import Path

from machine import ROOT, end_with, options_of_test

try:
    import yaml
except ImportError:
    sys.exit(77)  # The test is skipped.


class Loader(yaml.SafeLoader):
    """YAML 1.2 as far as keys go: `on`, that of a camera, is a word."""
    yaml_implicit_resolvers = {first: [pair for pair in pairs if not pair[0].endswith(":bool")]
                               for first, pairs in yaml.SafeLoader.yaml_implicit_resolvers.items()}


# Keys that no scene has, and why.
NOT_SHOWN = {
    "moorings.moordyn": "stands in place of the list of moorings",
    "moorings.bodies": "stands beside `moorings.moordyn`",
}
# Blocks whose keys are those of another block, and the one under which the schema lists them.
SAME_KEYS = (
    (r"\w+\[\]\.repeat\b", "bodies[].repeat"),
    (r"sails\[\]", "rudders[]"),
    (r"bodies\[\]\.hydro\b", "hydro"),
    (r"bodies\[\]\.shapes\[\]\.orientation\b", "bodies[].orientation"),
    (r"bodies\[\]\.shapes\[\]", "bodies[]"),
    (r"ground\.mesh\b", "bodies[].mesh"),
    (r"ground\.heightfield\b", "water.surface.heightfield"),
    (r"render\.cameras(\[\]|\.NAME)", "render.camera"),
)


def keys_of_schema(markdown):
    return re.findall(r"^\| `([^`]+)` \|", markdown, flags=re.MULTILINE)


def paths_of(value, path=""):
    """The paths of a scene that have values. A camera of a map is called NAME."""
    if path and value is not None:
        yield path
    if isinstance(value, dict):
        for key, below in value.items():
            yield from paths_of(below, f"{path}.{'NAME' if path == 'render.cameras' else key}".lstrip("."))
    elif isinstance(value, list):
        for item in filter(lambda item: isinstance(item, dict), value):
            yield from paths_of(item, path + "[]")


def shown_by(scene):
    """The keys that a scene shows, also under the names by which the schema lists them."""
    shown = set(paths_of(scene))
    for pattern, name in SAME_KEYS:
        shown |= {name + path[match.end():] for path in shown if (match := re.match(pattern, path))}
    return shown


def with_included(files):
    """The scenes in files and in those that they include."""
    waiting, read = list(files), {}
    while waiting:
        file = waiting.pop().resolve()
        if file in read:
            continue
        read[file] = yaml.load(file.read_text(encoding="utf-8"), Loader)
        names = read[file].get("include", [])
        waiting += [file.parent / name for name in ([names] if isinstance(names, str) else names)]
    return list(read.values())


def faults_of(keys, scenes, not_shown):
    shown = set().union(*map(shown_by, scenes))
    yield from (f"{key}: occurs in no scene under scenes/"
                for key in keys if key not in shown and key not in not_shown)
    yield from (f"{key}: is in the table of keys that no scene has, but it is none, or a scene has it"
                for key in not_shown if key not in keys or key in shown)


def self_test():
    """Finds keys that no scene has, in each form in which a scene is written."""
    scene = yaml.load("\n".join([
        "x-body: &body {mesh: {cap: true}}", "water: {depth: null}", "sails: [{law: fujii}]",
        "bodies: [{<<: *body, name: a}, {shapes: [{box: {size: [1, 1, 1]}}]}]",
        "joints: [{repeat: {count: 2}}]", "render: {cameras: {top: {on: a}}}"]), Loader)
    keys = keys_of_schema("\n".join(f"| `{key}` | a number | – | Text. |" for key in (
        "bodies[].mesh.cap", "bodies[].mesh.unite", "bodies[].box.size", "bodies[].repeat.count",
        "water.depth", "rudders[].law", "rudders[].drag", "render.cameras.NAME", "render.camera.on")))
    assert len(keys) == 9, keys
    found = [fault.split(":")[0] for fault in faults_of(keys, [scene], {})]
    assert found == ["bodies[].mesh.unite", "water.depth", "rudders[].drag"], found
    wrong = list(faults_of(keys[:1], [scene], dict.fromkeys(["bodies[].mesh.cap", "bodies[].nose"], "")))
    assert [fault.split(": ")[0] for fault in wrong] == ["bodies[].mesh.cap", "bodies[].nose"], wrong


def main():
    arguments = options_of_test().parse_args()
    if arguments.self_test:
        return self_test()
    printed = subprocess.run([arguments.program, "schema", "--markdown"], check=True, capture_output=True,
                             encoding="utf-8").stdout
    keys, scenes = keys_of_schema(printed), with_included((ROOT / "scenes").rglob("*.yaml"))
    print(f"{len(keys)} keys in {len(scenes)} scenes")
    end_with(list(faults_of(keys, scenes, NOT_SHOWN)))


if __name__ == "__main__":
    main()
