"""Runs every command and every snippet of Python in the code blocks of the documents.

documented_commands.py PROGRAM [--module FOLDER] [--pages FOLDER] [--self-test]

A command stands as a reader would type it, in a folder that has what the documents speak of:
buoy.yaml of README.md and barge.yaml of scenes/README.md. Runs are short and their pictures small
(SHORT). A synopsis, which has places to fill in, is run as each of its examples below; together they
have every option that it names. A command that is neither run nor named in NOT_RUN is a fault, and
so is an entry of the tables that no document has.
"""

import itertools
import shlex
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from commands import SCENE_DOCUMENTS, blocks_of, commands_of, is_synopsis, options_of
from machine import ROOT, Machine, end_with, options_of_test

DOCUMENTS = (*SCENE_DOCUMENTS, "tests/README.md")

# What is appended to `plimsoll run` and `sweep`, so that they take no longer than they must.
SHORT = ["--set", "duration=0.2", "--set", "render.size=[64, 48]"]

# Commands that are not run, and why.
INSTALLS = "installs packages and builds; the program that it starts is run as `plimsoll`"
NOT_RUN = {
    "tools/run scenes/teapot_drop.yaml": INSTALLS,
    "tools/report out/teapot_drop": INSTALLS,
    "tools/python": INSTALLS + ", and its snippets with the module",
    "tools/python app/python/examples/drop_teapot.py": INSTALLS + "; python.examples runs the script",
    "tools/test": "is what runs this test",
    "tools/test -L unit": "is what runs this test",
    "tools/test -R Loads": "is what runs this test",
    "tools/test --all": "is what runs this test",
    "build/checked/hydro_tests --gtest_filter='PositivePart.*'": "ctest runs the same program",
    "PLIMSOLL_TOL_SCALE=0 build/checked/hydro_tests": "fails by intent, to show the errors",
    "cmake --install build --prefix /usr/local": "writes to the system; the label install has it",
    "cpack --config build/CPackConfig.cmake": "takes minutes; the label install has the same files",
    "plimsoll view SCENE [--set KEY.PATH=VALUE]… [--any-format] [--threads N]"
    " [--snapshot FILE.png [--after SECONDS]]": "needs a screen; tests/view has one",
}

# Of each synopsis, from its first two words on, the commands that are run. box.yaml is a small scene
# with waves, forces and a probe; runs/a and runs/b are its runs, and runs/c has a checkpoint.
EXAMPLES = {
    "plimsoll run SCENE": [
        "plimsoll run box.yaml --out o/run --set bodies[box].density=700 --threads 1 --format csv"
        " --checkpoint 0.1 --any-format --quiet",
        "plimsoll run box.yaml --out o/video --video o/video.mp4 --fps 10",
        "plimsoll run box.yaml buoy.yaml --out o/dry --no-render"],
    "plimsoll run --resume DIR": ["plimsoll run --resume runs/c"],
    "plimsoll report DIR": [
        "plimsoll report runs/a --out o/report.html --scene box.yaml --any-format"],
    "plimsoll report A B": ["plimsoll report runs/a runs/b runs/c --out o/runs.html"],
    "plimsoll render RUN": [
        "plimsoll render runs/a --scene box.yaml --out o/render --video o/render.mp4 --fps 5"
        " --set render.every=0.1 --any-format --quiet"],
    "plimsoll export RUN": [
        "plimsoll export runs/a o/box.glb --fps 10 --water 8 --scene box.yaml"
        " --set render.size=[32,24] --any-format --quiet"],
    "plimsoll export SCENE": [
        "plimsoll export box.yaml o/box.fmu --set bodies[box].density=600 --any-format --quiet"],
    "plimsoll compare A B [--tol": [
        "plimsoll compare runs/a runs/b --tol position=1 --json --junit o/junit.xml"
        " --html o/comparison.html",
        "plimsoll compare runs/a runs/b --tolerances tolerances.yaml"],
    "plimsoll compare A B [RUN…]": [
        "plimsoll compare runs/a runs/b runs/b --learn o/learned.yaml --margin 2"],
    "plimsoll analyse RUN": [
        "plimsoll analyse runs/a --from 0.2 --to 2 --segment 1 --wave gauge --json"],
    "tools/rao SCENE": [
        "tools/rao box.yaml --periods 2:2:1 --amplitude 0.01 --heading 180 --motions heave"
        " --reference rao.csv --set bodies[box].density=500 --out o/rao",
        "tools/rao box.yaml --periods 2 --slope 0.01 --motions heave --out o/rao_slope"],
    "plimsoll mesh FILE": [
        "plimsoll mesh box.obj --up z --unit m --scale 1 --any-format",
        "plimsoll mesh half.obj --repair --weld 1e-5 --cap --mirror y -o o/whole.obj",
        "plimsoll mesh crossing.obj --repair --unite -o o/united.stl",
        "plimsoll mesh half.obj --repair --thickness 0.01 -o o/plates.obj"],
    "plimsoll hydrostatics MESH": [
        "plimsoll hydrostatics scenes/meshes/bucket.obj --mass 12 --density 1025 --com 0,0,0.08"
        " --water 0.002 --heel 0:10:10 --up z --unit m --scale 1 --any-format --json",
        "plimsoll hydrostatics box.obj --draught 0.5 --keel -0.5 --csv --plot o/gz.svg",
        "plimsoll hydrostatics box.obj --draught 0.2:0.8:0.2 --trim 2 --plot o/form.svg"],
    "plimsoll hydrostatics SCENE": [
        "plimsoll hydrostatics box.yaml --set bodies[box].density=600 --heel 0:10:10 --any-format"
        " --json",
        "plimsoll hydrostatics box.yaml --csv --plot o/gz_box.svg",
        "plimsoll hydrostatics box.yaml --draught 0.2,0.5 --trim 2"],
    "plimsoll addedmass MESH-or-SCENE": [
        "plimsoll addedmass box.obj --density 1025 --tolerance 0.05 --method constant --up z --unit m"
        " --scale 1 --any-format --no-store --json"],
    "plimsoll radiation MESH-or-SCENE": [
        "plimsoll radiation box.obj --density 1025 --depth 20 --relative-density 0.5"
        " --frequencies 1 --up z --unit m --scale 1 --any-format --no-store --json"
        " --wamit o/box --capytaine o/box.nc --plot o/box.svg",
        "plimsoll radiation box.obj --frequencies 1 --csv"],
    "plimsoll rao SCENE": [
        "plimsoll rao scenes/basin_model.yaml --headings 0:180:90 --periods 2,3 --body model"
        " --set duration=1 --any-format --no-store --json --out o/rao.csv",
        "plimsoll rao box.yaml --periods 2:3:0.5 --set bodies[box].hydro.radiation=auto --csv",
        "plimsoll rao box.yaml --headings 0 --periods 2 --runs --slope 0.01"
        " --set bodies[box].hydro.radiation=auto"],
    "plimsoll probe SCENE": ["plimsoll probe box.yaml --set bodies[box].density=700 --any-format"],
}

# Exit codes that are no faults beside 0: runs that differ, responses that are not yet steady.
OTHER_CODES = {"plimsoll compare": {1}, "tools/rao": {1}}

BOX = """\
plimsoll: 1
duration: 2
water: {surface: {waves: [{amplitude: 0.05, period: 2}]}}
bodies:
  - {name: box, box: {size: [1, 1, 1]}, density: 500}
log: {every: 0.02, forces: true, probes: [{name: gauge, wave: [3, 0]}]}
render: {every: 1, size: [64, 48], camera: {from: [3, -4, 2], to: [0, 0, 0]}}
"""
BOX_MESH = """\
v -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\nv 0.5 0.5 -0.5\nv -0.5 0.5 -0.5
v -0.5 -0.5 0.5\nv 0.5 -0.5 0.5\nv 0.5 0.5 0.5\nv -0.5 0.5 0.5
f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5
f 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8
"""
# The box on one side of y = 0, without its top and open at the plane, and two boxes that overlap.
HALF_MESH = """\
v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0.5 -0.5\nv -0.5 0.5 -0.5
v -0.5 0 0.5\nv 0.5 0 0.5\nv 0.5 0.5 0.5\nv -0.5 0.5 0.5
f 1 4 3 2\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8
"""
CROSSING_MESH = BOX_MESH + "".join(
    "v " + " ".join(str(float(x) + 0.3) for x in line.split()[1:]) + "\n"
    for line in BOX_MESH.splitlines() if line.startswith("v")) + "".join(
    "f " + " ".join(str(int(v) + 8) for v in line.split()[1:]) + "\n"
    for line in BOX_MESH.splitlines() if line.startswith("f"))
# For the snippets of app/python/README.md: a buoy, and a tug that tows it.
TUG = """\
plimsoll: 1
duration: 1
water: {}
hydro: {added_mass: none, radiation: none}
bodies:
  - {name: buoy, sphere: {radius: 0.5}, density: 400}
  - {name: tug, box: {size: [6, 2, 1.5]}, density: 400, position: [8, 0, 0]}
ropes:
  - {name: tow, bodies: [buoy, tug], points: [[0.5, 0, 0], [-3, 0, 0]], length: 5, stiffness: 1e4, damping: 1e3}
propellers:
  - {name: main, body: tug, at: [-3, 0, -0.6], axis: [1, 0, 0], diameter: 0.6,
     model: {wageningen: {blades: 4, area_ratio: 0.7, pitch_ratio: 1}}, speed_rps: 2}
log: {forces: true, probes: [{name: imu, body: tug, at: [2, 0, 1]}]}
"""

# A float that works against a damper.
CONVERTER = """\
plimsoll: 1
duration: 1
water: {surface: {spectrum: {type: jonswap, significant_height: 1, peak_period: 6, components: 10}}}
hydro: {added_mass: none, radiation: none}
bodies: [{name: float, box: {size: [4, 4, 2]}, density: 500}]
joints: [{name: pto, type: slider, bodies: [world, float], axis: [0, 0, 1], damping: 1e4}]
"""

# Of each snippet of Python, by a line of it: what comes before it, and the modules that it needs.
SIMULATION = 'import plimsoll as pl\nsim = pl.Simulation("tug.yaml")\nsim.step(3)\n'
BATCH = 'import os, numpy as np, plimsoll as pl\nos.chdir("tow")\n'  # whose buoy.yaml has a screw
SNIPPETS = {
    'sim = pl.Simulation("scenes/teapot_drop.yaml")': ("", {"plimsoll"}),
    "import h5py, pandas": ("", {"h5py", "pandas"}),
    'plot.savefig("sweep.png")': ("import matplotlib\nmatplotlib.use('Agg')\n", {"matplotlib"}),
    "sim = pl.Simulation(scene)": ("", {"plimsoll"}),
    "state = sim.save(); sim.load(state)": (SIMULATION, {"plimsoll"}),
    "batch.reset([3, 7])": (BATCH, {"plimsoll"}),
    'sim.readings()["probes"]': (SIMULATION, {"plimsoll"}),
    "import fmpy": ("", {"fmpy"}),
    "env = pl.Env(": ("import plimsoll as pl\n", {"plimsoll"}),
}


class Place:
    """A folder with what the documents speak of, in which commands are run."""

    def __init__(self, folder, arguments):
        self.folder = folder
        self.machine = Machine(folder, arguments.program, arguments.module, arguments.pages)
        (folder / "o").mkdir()
        for name in ("scenes", "app", "tools"):
            (folder / name).symlink_to(ROOT / name)
        self.write_scenes()

    def write_scenes(self):
        def block(document, language, holding):
            text = (ROOT / document).read_text()
            return next("\n".join(b.lines) for b in blocks_of(text)
                        if b.language == language and any(holding in line for line in b.lines))
        files = {"box.yaml": BOX, "box.obj": BOX_MESH, "tug.yaml": TUG,
                 "half.obj": HALF_MESH, "crossing.obj": CROSSING_MESH,
                 "wec.yaml": CONVERTER,
                 "buoy.yaml": block("README.md", "yaml", "name: buoy"),
                 "barge.yaml": block("scenes/README.md", "yaml", "A box in a swell"),
                 "tolerances.yaml": block("app/compare/README.md", "", "orientation_deg: {peak"),
                 "rao.csv": "period,heave\n1.9,1\n2.1,1\n"}
        files["tow/buoy.yaml"] = TUG
        (self.folder / "tow").mkdir()
        for name, text in files.items():
            (self.folder / name).write_text(text + "\n")

    def prepare(self):
        """Makes the runs that commands and snippets read."""
        runs = [["box.yaml", "--out", "runs/a"],
                ["box.yaml", "--out", "runs/b", "--set", "bodies[box].density=510"],
                ["buoy.yaml", "--out", "out/buoy", "--format", "hdf5", *SHORT]]
        faults = [fault for run in runs
                  for fault in self.faults_of(["plimsoll", "run", *run, "--quiet"])]
        return faults + self.break_off("runs/c")

    def break_off(self, out):
        """Leaves a run that was killed after a checkpoint."""
        words = ["plimsoll", "run", "box.yaml", "--out", out, "--checkpoint", "0.1", "--no-render",
                 "--quiet", "--set", "duration=60", "--set", "log.every=1"]
        killed = subprocess.Popen(words, cwd=self.folder, env=self.machine.environment,
                                  stderr=subprocess.DEVNULL)
        while killed.poll() is None and not (self.folder / out / "checkpoint.bin").exists():
            time.sleep(0.005)
        killed.kill()
        killed.wait()
        kept = (self.folder / out / "checkpoint.bin").exists()
        return [] if kept else [f"{shlex.join(words)}: left no checkpoint"]

    def faults_of(self, words, codes=frozenset({0}), text=None):
        """Runs a command in the folder and says what is wrong with how it ended."""
        return self.machine.faults_of(words, self.folder, codes, text)


def run(command, place):
    words = shlex.split(command)
    if words[0] == "tools/rao":  # The script only installs packages before it starts this.
        words = [sys.executable, "-B", "tools/seakeeping/rao.py", *words[1:]]
    if words[:2] in (["plimsoll", "run"], ["plimsoll", "sweep"]) and "--resume" not in words:
        words += SHORT
    codes = {0}.union(*(more for start, more in OTHER_CODES.items() if command.startswith(start)))
    return place.faults_of(words, codes)


def faults_of_block(jobs, place):
    """Runs the commands of a code block one after the other: they may write to one folder."""
    return [f"{where}: {fault}" for command, where in jobs for fault in run(command, place)]


def examples_of(synopsis):
    """The examples of a synopsis, and the key of the table that has them."""
    key = next((key for key in EXAMPLES if synopsis.startswith(key)), None)
    return EXAMPLES.get(key, []), key


def faults_of_tables(commands):
    """Checks that each command is run or excused, and each entry of the tables is of use."""
    used = set()
    for where, command in commands:
        if command in NOT_RUN:
            used.add(command)
        elif is_synopsis(command):
            examples, key = examples_of(command)
            used.add(key)
            if not examples:
                yield f"{where}: {command}: is neither run nor in the list of those that are not"
            lacking = options_of(command) - options_of(" ".join(examples))
            if examples and lacking:
                yield f"{where}: {command}: no example has {', '.join(sorted(lacking))}"
    for entry in (set(NOT_RUN) | set(EXAMPLES)) - used:
        yield f"the tables have {entry}, which no document has"


def snippets_of(documents):
    """The snippets of Python, with what comes before them: (where, text, modules); a fault if unknown."""
    for document, block in documents:
        if block.language != "python":
            continue
        where = f"{document}:{block.line}"
        key = next((key for key in SNIPPETS if any(line.startswith(key) for line in block.lines)), None)
        if key is None:
            yield where, None, set()
            continue
        before, modules = SNIPPETS[key]
        # Runs of a thousand steps show no more than short ones.
        text = "\n".join(block.lines).replace("step(1000)", "step(10)").replace(", 256", ", 8")
        yield where, before + text, modules


def check(place):
    documents = [(name, block) for name in DOCUMENTS
                 for block in blocks_of((ROOT / name).read_text())]
    commands = [(f"{name}:{block.line}", command) for name, block in documents
                for command in commands_of(block)]
    faults = [*faults_of_tables(commands), *place.prepare()]
    jobs, left_out = [], []
    for where, command in commands:
        if command in NOT_RUN:
            continue
        for one in examples_of(command)[0] if is_synopsis(command) else [command]:
            if place.machine.missing_of(one):
                left_out.append(f"{one}: no {', '.join(place.machine.missing_of(one))}")
            else:
                jobs.append((one, where))
    blocks = [list(block) for _, block in itertools.groupby(jobs, key=lambda job: job[1])]
    with ThreadPoolExecutor(2) as pool:
        for found in pool.map(lambda block: faults_of_block(block, place), blocks):
            faults += found
    count = len(jobs)
    for where, text, modules in snippets_of(documents):
        lacking = {module for module in modules if place.machine.lacks(module)}
        if text is None:
            faults.append(f"{where}: the table of snippets does not have it")
        elif lacking:
            left_out.append(f"{where}: no {', '.join(sorted(lacking))}")
        else:
            count += 1
            faults += [f"{where}: {fault}"
                       for fault in place.faults_of([sys.executable, "-B", "-"], text=text)]
    print(f"{count} commands and snippets were run, {len(NOT_RUN)} are not by intent")
    for line in left_out:
        print(f"left out: {line}")
    return faults


def self_test():
    """Finds commands in a document that has each kind of block."""
    text = "\n".join([
        "Text", "", "    plimsoll run SCENE [--out DIR]", "                       [--quiet]", "",
        "    out: 3 bodies", "", "```", "plimsoll check a.yaml   # a remark",
        "plimsoll run a.yaml \\", "  --set x=1", "```", "```yaml", "plimsoll: 1", "```"])
    commands = [command for block in blocks_of(text) for command in commands_of(block)]
    assert commands == ["plimsoll run SCENE [--out DIR] [--quiet]", "plimsoll check a.yaml",
                        "plimsoll run a.yaml --set x=1"], commands
    assert is_synopsis(commands[0]) and not is_synopsis(commands[2])
    assert options_of(commands[0]) == {"--out", "--quiet"}
    unknown = list(faults_of_tables([("x:1", "plimsoll dance SCENE")]))
    assert unknown[0].startswith("x:1: plimsoll dance SCENE: is neither run"), unknown[0]
    assert len(unknown) == 1 + len(NOT_RUN) + len(EXAMPLES), unknown
    short = list(faults_of_tables([("x:1", "plimsoll probe SCENE [--fast]")]))
    assert short[0] == "x:1: plimsoll probe SCENE [--fast]: no example has --fast", short[0]


def main():
    arguments = options_of_test().parse_args()
    if arguments.self_test:
        return self_test()
    with tempfile.TemporaryDirectory() as folder:
        faults = check(Place(Path(folder), arguments))
    end_with(faults)


if __name__ == "__main__":
    main()
