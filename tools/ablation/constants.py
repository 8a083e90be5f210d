"""Makes the header of the ablation build: the engine's constants with values from the environment.

    constants.py --write FOLDER   # for CMake: FOLDER/engine/…/constants.h, if that changes

`inline constexpr double kX = 1;` becomes `inline const double kX = from_environment("kX", 1.0);`.
"""

from __future__ import annotations

import argparse
import re
import sys
from dataclasses import dataclass
from pathlib import Path

kRoot = Path(__file__).resolve().parents[2]

kDefinition = re.compile(r"^inline constexpr (?P<type>double|int|long|std::size_t) "
                         r"(?P<name>k\w+) = (?P<value>[^;]+);", re.MULTILINE)
kPrefix = "PLIMSOLL_"  # Of the variables.

kReader = """
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace engine {

/// The number in an environment variable, or `value` where there is none.
template <class Number>
inline Number from_environment(const char* variable, Number value) {
  const char* text = std::getenv(variable);
  if (text == nullptr) return value;
  char* end = nullptr;
  const double number = std::strtod(text, &end);
  if (end == text || *end != '\\0')
    throw std::invalid_argument(std::string(variable) + " is no number: " + text);
  return static_cast<Number>(number);
}

}  // namespace engine
"""


@dataclass(frozen=True)
class Constant:
    name: str
    type: str
    value: str  # As it is written.


def header() -> Path:
    """The engine's constants.h, wherever in the engine it lies."""
    found = sorted((kRoot / "engine").rglob("constants.h"))
    if len(found) != 1:
        raise SystemExit(f"expected one constants.h below engine/, found {len(found)}")
    return found[0]


def constants_of(text: str) -> dict[str, Constant]:
    return {m["name"]: Constant(m["name"], m["type"], m["value"])
            for m in kDefinition.finditer(text)}


def with_environment(text: str) -> str:
    """The header's text with every constant read from the environment."""
    def read(m: re.Match) -> str:
        return (f'inline const {m["type"]} {m["name"]} = '
                f'from_environment<{m["type"]}>("{kPrefix}{m["name"]}", {m["value"]});')
    made = kDefinition.sub(read, text)
    if "constexpr" in made:
        raise SystemExit("constants.h has a constant of a type that tools/ablation does not know")
    first = made.index("namespace engine")
    return made[:first] + kReader.lstrip() + "\n" + made[first:]


def write(folder: Path) -> None:
    """Leaves a file with the same text alone, since all that includes it would be compiled anew."""
    file = folder / header().relative_to(kRoot)
    text = with_environment(header().read_text())
    if not file.is_file() or file.read_text() != text:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", type=Path, metavar="FOLDER", required=True)
    write(parser.parse_args().write)
    sys.exit(0)
