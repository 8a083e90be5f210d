"""What the code blocks of a document hold: commands, their synopses, and snippets of Python."""

import re
from dataclasses import dataclass

from machine import ROOT

# Documents whose blocks are commands, scenes and snippets to try. scenes/GUIDE.md has tasks.
SCENE_DOCUMENTS = ("README.md", "scenes/README.md", "scenes/KEYS.md",
                   *sorted(str(path.relative_to(ROOT)) for path in (ROOT / "app").rglob("README.md")
                           if "node_modules" not in path.parts))
# What begins a line that a reader is to type.
COMMAND = re.compile(r"(?:[A-Z_]+=\S+ )?(?:plimsoll|tools/|build/|cmake|cpack|ctest)\S*(?:\s|$)")
# A word in capitals, which stands for what the reader puts in its place. It tells a synopsis from a
# command, as an option in brackets and a repetition do.
CAPITALS = re.compile(r"\b[A-Z][A-Z0-9]*(?:[-.=_][A-Za-z]+)*\b")


@dataclass(frozen=True)
class Block:
    """A code block. `language` is empty of one that is indented or names none."""
    line: int
    language: str
    lines: tuple


def blocks_of(text):
    """All code blocks of a Markdown document, fenced and indented by four spaces."""
    found, lines, language, start = [], [], None, 0
    for number, line in enumerate(text.split("\n"), 1):
        fence = re.match(r"```(\w*)$", line)
        if fence and language is None:
            if lines:
                found.append(Block(start, "", tuple(lines)))
            language, start, lines = fence[1], number + 1, []
        elif fence:
            found.append(Block(start, language, tuple(lines)))
            language, lines = None, []
        elif language is not None:
            lines.append(line)
        elif line.startswith("    "):
            start = start if lines else number
            lines.append(line[4:])
        elif lines:
            found.append(Block(start, "", tuple(lines)))
            lines = []
    return found


def commands_of(block):
    """The commands of a block, each in one line; none of a block of output, YAML or Python."""
    if block.language not in ("", "bash", "sh"):
        return []
    commands, continued = [], False
    for line in block.lines:
        text = re.sub(r"\s+#\s.*$", "", line).strip()
        if continued or (commands and line.startswith(" ") and text.startswith("[")):
            commands[-1] += " " + text.removesuffix("\\").rstrip()
        elif COMMAND.match(line):
            commands.append(text.removesuffix("\\").rstrip())
        continued = text.endswith("\\") and (continued or bool(COMMAND.match(line)))
    return commands


def is_synopsis(command):
    """True if a command has places to fill in."""
    rest = re.sub(r"'[^']*'", "", command)
    words = rest.split()[1:]
    return "…" in rest or any(word.startswith("[") for word in words) or any(
        CAPITALS.fullmatch(word) for word in words)


def options_of(text):
    """The long options that a text names."""
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))
