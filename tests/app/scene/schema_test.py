"""The JSON Schema of scenes against every scene there is, right and wrong.

schema_test.py PROGRAM: without PyYAML or jsonschema it says so and ends with code 77.
"""

import json
import re
import subprocess
import sys
import unittest
from pathlib import Path

try:
    import jsonschema
    import yaml
except ImportError as error:
    print(f"left out: {error}", file=sys.stderr)
    sys.exit(77)

ROOT = Path(__file__).resolve().parents[3]
BAD_SCENES = ROOT / "tests/data/bad_scenes"

# What a schema cannot see, by the faults that the scenes' heads expect: text that is no YAML or
# has no values of its own, several keys weighed against each other, files, and how a number is
# written.
UNSEEN = [
    r"^(?!\d+:\d+: \w)",  # of the text, not of a key
    r"\d+:\d+: (?![\w.\[\]]+: )",
    r"given twice", r"which is the name of", r"there is no body named", r"found a twice",
    r"which stands for the world", r"without commas, double quotes",
    r"there is none of this name", r"expected the heights of black", r"not used with a .csv",
    r"the lower height first", r"expected more than min", r"from start \(",
    r"looks (from|straight)", r"found a zero", r"found the principal moments",
    r"found the gyradii", r"found the eigenvalue", r"expected a\s+symmetric", r"a perpendicular one",
    r"which is switched off", r"equilibrium needs", r"is only used with viscous_drag",
    r"remove it", r"found \.(inf|nan)", r"too large or too small", r"found 0x", r"found 1/",
    r"in case alone", r"less than the depth", r"waves need gravity",
    r"tma needs water.depth", r"wind is horizontal", r"found a speed of",
    r"found a table", r"of a table is horizontal", r"expected a greater depth",
    r"one for each depth",
    r"at least the lowest frequency", r"which is below the bottom", r"needs water, and the scene",
    r"needs interior: flooding", r"traps no air", r"hollow that holds", r"is below the hollow", r"the far side of",
    r"the same water on both sides", r"which is the pair of", r"friction, restitution or both",
    r"stands for the ground", r"has collision: none", r"pass through each other",
    r"found \w+ twice", r"\.formula: ", r"sets .* already", r"the lower limit first",
    r"there is no quantity", r"has no quantity", r"at least low", r"no set point named",
    r"not used by a (hinge|slider) joint", r"table from 0", r"rising values",
    r"expected wageningen, open_water", r"at most the length", r"there is no propeller",
    r"is a propeller of", r"needs air, and", r"a\.obj\\x00b", r"knows no lines and machines",
    r"more than 64 MiB of text", r"is only used with (model: dynamic|weight)",
]


class CoreLoader(yaml.SafeLoader):
    """YAML 1.2, as editors read it: 1e-3 is a number, yes and no are words."""


CoreLoader.yaml_implicit_resolvers = {}
for tag, pattern, first in [
        ("bool", r"true|false", "tf"),
        ("int", r"[-+]?[0-9]+", "-+0123456789"),
        ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?|[-+]?\.(inf|nan)",
         "-+.0123456789"),
        ("null", r"~|null|", ["~", "n", ""]),
        ("merge", r"<<", "<")]:
    CoreLoader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{pattern})$"),
                                     list(first))
CoreLoader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))


def load(file):
    return yaml.load(file.read_text(encoding="utf-8"), CoreLoader)


def expected_faults(file):
    lines = file.read_bytes().decode("utf-8", "replace").splitlines()
    mark = "# expect: "
    return [line[len(mark):] for line in lines if line.startswith(mark)]


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        printed = subprocess.run([sys.argv[1], "schema"], check=True, capture_output=True)
        cls.schema = json.loads(printed.stdout)
        cls.validator = jsonschema.Draft7Validator(cls.schema)

    def faults(self, file):
        return [f"{list(error.absolute_path)}: {error.message[:200]}"
                for error in self.validator.iter_errors(load(file))]

    def test_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(self.schema)

    def test_takes_every_scene_that_the_program_takes(self):
        files = sorted(ROOT.glob("scenes/**/*.yaml"))
        self.assertGreater(len(files), 40)
        for file in files:
            with self.subTest(scene=file.name):
                self.assertEqual(self.faults(file), [])

    def test_refuses_the_bad_scenes_whose_faults_it_can_see(self):
        refused = 0
        for file in sorted(BAD_SCENES.glob("*.yaml")):
            seen = [fault for fault in expected_faults(file)
                    if not any(re.search(unseen, fault) for unseen in UNSEEN)]
            if not seen:
                continue
            with self.subTest(scene=file.name):
                self.assertNotEqual(self.faults(file), [], seen)
                refused += 1
        self.assertGreater(refused, 120)

    def test_every_key_has_a_description(self):
        def visit(schema):
            for key, below in schema.get("properties", {}).items():
                self.assertIn("\n\nValue: ", below["description"], key)
                visit(below)
            named = [schema[k] for k in ("items", "additionalProperties") if schema.get(k)]
            for below in schema.get("anyOf", []) + named:
                visit(below)

        visit(self.schema)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
