"""Runs every scene and every task of the documents.

documented_scenes.py PROGRAM [--module FOLDER] [--pages FOLDER] [--only TASK] [--self-test]

A YAML block of a document is a scene, or a part of one that a head completes; it is run briefly.
Each task of scenes/GUIDE.md, a heading of the third level, is worked through in a folder of its own,
as a reader would: a block that follows a line that ends with a file's name and a colon becomes that
file, and commands and Python are run in their order, whole. A remark `exit code N` beside a command
is what it ends with. Blocks of C++ are compared with the program that tests/install compiles.
"""

import re
import shlex
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from commands import SCENE_DOCUMENTS, blocks_of, commands_of
from machine import ROOT, Machine, end_with, options_of_test

GUIDE = "scenes/GUIDE.md"
LEAST_TASKS = 30
HEAD = "plimsoll: 1\nduration: 0.1\n"
# What makes scenes quick that only show how keys are written: without pictures, and without added
# mass and radiation, which take seconds to solve, where the scene is not about them.
BRIEF = ["--no-render", "--quiet", "--set", "duration=0.1"]
LIGHT = ["--set", "hydro.added_mass=none"]
SMALL = ["--set", "render.size=[64, 48]"]
# What is appended to commands of tasks on the scenes of scenes/, which tests/golden runs whole.
SHORT = ["--set", "duration=1", *LIGHT]
CLIENT = "tests/install/crate/main.cpp"


@dataclass(frozen=True)
class Step:
    """A step of a task. `kind` is run, python or cpp, or the name of the file that `text` becomes."""
    kind: str
    text: str
    line: int
    code: int = 0  # With which a command ends.


def scenes_of(documents):
    """The YAML blocks of documents: (where, scene)."""
    for name in documents:
        for block in blocks_of((ROOT / name).read_text(encoding="utf-8")):
            if block.language == "yaml":
                text = "\n".join(block.lines) + "\n"
                yield f"{name}:{block.line}", text if "plimsoll: " in text else HEAD + text


def titles_of(lines):
    """The task to which each line of the guide belongs, None where it belongs to none."""
    titles, title, fenced = [], None, False
    for line in lines:
        fenced ^= line.startswith("```")
        if not fenced and re.match(r"#{1,3} ", line):
            title = line.lstrip("# ") if line.startswith("### ") else None
        titles.append(title)
    return titles


def steps_of(block, before):
    """The steps of a block that follows the line `before`."""
    named = re.search(r"`([\w.-]+\.\w+)`:$", before)
    if named or block.language in ("python", "cpp"):
        return [Step(named[1] if named else block.language, "\n".join(block.lines) + "\n", block.line)]
    codes = {}
    for line in block.lines:
        remark = re.search(r"^(.*?)\s+#\s.*exit code (\d+)", line)
        if remark:
            codes[remark[1]] = int(remark[2])
    return [Step("run", command, block.line, codes.get(command, 0)) for command in commands_of(block)]


def tasks_of(text):
    """The tasks of the guide: of each title its steps."""
    lines = text.split("\n")
    titles = titles_of(lines)
    tasks = {title: [] for title in titles if title is not None}
    for block in blocks_of(text):
        title = titles[block.line - 1]
        if title is not None:
            before = next((line for line in reversed(lines[:block.line - 1])
                           if line and not line.startswith("```")), "")
            tasks[title] += steps_of(block, before)
    return tasks


def words_of(command, folder):
    """A command of a task as it is run in a folder: pictures are small and drawn where the task is
    about them, and the scenes of scenes/ are run for a second."""
    words = shlex.split(command)
    if words[:2] == ["plimsoll", "sweep"]:
        return words + SHORT
    if words[:2] not in (["plimsoll", "run"], ["plimsoll", "render"]) or "--resume" in words:
        return words
    if words[2].startswith("scenes/"):
        words += SHORT if re.search("video|picture|render|log.forces", command) else [*SHORT, "--no-render"]
    drawn = "--no-render" not in words and "\nrender:" in (folder / words[2]).read_text(encoding="utf-8")
    return words + SMALL if drawn else words


def missing_of(step, machine):
    """What the machine lacks for a step; empty if nothing."""
    if step.kind == "python":
        return {module for module in re.findall(r"^(?:import|from) (\w+)", step.text, flags=re.MULTILINE)
                if machine.lacks(module)}
    return machine.missing_of(step.text) if step.kind == "run" else set()


def take(step, machine, folder):
    """Takes a step; returns what is wrong with it."""
    if step.kind == "run":
        return machine.faults_of(words_of(step.text, folder), folder, {step.code})
    if step.kind == "python":
        return machine.faults_of([sys.executable, "-B", "-"], folder, text=step.text)
    if step.kind == "cpp":
        program = (ROOT / CLIENT).read_text(encoding="utf-8")
        return [f"{CLIENT} has no line {line}" for line in step.text.splitlines()
                if line.strip() not in program]
    (folder / step.kind).write_text(step.text, encoding="utf-8")
    return []


def lay_out(folder):
    """Makes a folder in which the paths of the guide lead somewhere."""
    folder.mkdir(parents=True)
    for place in ("scenes", "scenes/meshes", "app"):
        (folder / Path(place).name).symlink_to(ROOT / place)


def work_through(title, steps, machine, folder):
    """Works through a task; returns its faults, and what was left out and why."""
    lay_out(folder)
    for step in steps:
        where = f"{GUIDE}:{step.line}: {title}"
        lacking = missing_of(step, machine)
        if lacking:
            return [], [f"{where}: no {', '.join(sorted(lacking))}"]
        faults = take(step, machine, folder)
        if faults:
            return [f"{where}: {fault}" for fault in faults], []
    return [], []


def run_scenes(machine, folder, pool):
    """Runs the scenes of all documents but the guide's; returns their faults."""
    folder.mkdir()
    for name in ("meshes", "files"):
        (folder / name).symlink_to(ROOT / "scenes" / name)
    jobs = []
    for number, (where, text) in enumerate(scenes_of(SCENE_DOCUMENTS)):
        (folder / f"{number}.yaml").write_text(text, encoding="utf-8")
        light = [] if re.search("radiation|added_mass|simulated", text) else LIGHT
        jobs.append((where, ["plimsoll", "run", f"{number}.yaml", *BRIEF, *light]))
    ran = pool.map(lambda job: machine.faults_of(job[1], folder), jobs)
    print(f"{len(jobs)} scenes are run")
    return [f"{where}: {fault}" for (where, _), found in zip(jobs, ran) for fault in found]


def work_through_guide(machine, folder, pool, only):
    """Works through the tasks of the guide, or one of them; returns their faults."""
    tasks = tasks_of((ROOT / GUIDE).read_text(encoding="utf-8"))
    faults = [f"{GUIDE}: {title}: has nothing to type" for title, steps in tasks.items() if not steps]
    if len(tasks) < LEAST_TASKS:
        faults.append(f"{GUIDE}: has {len(tasks)} tasks, at least {LEAST_TASKS} are expected")
    jobs = [job for job in enumerate(tasks.items()) if only is None or only in job[1][0]]
    for found, left_out in pool.map(
            lambda job: work_through(*job[1], machine, folder / f"task{job[0]}"), jobs):
        faults += found
        for line in left_out:
            print(f"left out: {line}")
    print(f"{len(jobs)} tasks were worked through")
    return faults


def self_test():
    """Finds the files, commands and snippets of a guide."""
    text = "\n".join(["# Guide", "", "## Bodies", "", "### Drop a ball", "Write `ball.yaml`:", "",
                      "```yaml", "plimsoll: 1", "```", "", "    plimsoll run ball.yaml   # a remark",
                      "    plimsoll compare a b   # they differ: exit code 1", "",
                      "```python", "import math", "```", "", "## End", "", "    plimsoll check x"])
    assert tasks_of(text) == {"Drop a ball": [
        Step("ball.yaml", "plimsoll: 1\n", 9), Step("run", "plimsoll run ball.yaml", 12),
        Step("run", "plimsoll compare a b", 12, 1), Step("python", "import math\n", 16)]}, tasks_of(text)
    assert words_of("plimsoll run scenes/bucket.yaml", ROOT)[-1] == "--no-render"
    assert words_of("plimsoll run scenes/bucket.yaml --video a.mp4", ROOT)[-1] == SMALL[-1]
    assert words_of("plimsoll check scenes/bucket.yaml", ROOT)[-1] == "scenes/bucket.yaml"


def main():
    parser = options_of_test()
    parser.add_argument("--only", help="works through the tasks alone whose title has this text")
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(2) as pool:
        folder = Path(name)
        machine = Machine(folder, arguments.program, arguments.module, arguments.pages)
        faults = [] if arguments.only else run_scenes(machine, folder / "scenes", pool)
        faults += work_through_guide(machine, folder, pool, arguments.only)
    end_with(faults)


if __name__ == "__main__":
    main()
