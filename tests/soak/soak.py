"""Kills runs of the program at random moments, looks at what they leave, and resumes them.

soak.py PROGRAM [--kills N] [--seed S] [--keep DIR]; the module `plimsoll` must be importable, and
h5py. A run is killed, by one of four signals, and resumed until it ends. After each kill

- every CSV file is the start of that of a run that nobody stopped, byte for byte,
- run.h5 is read by h5py and has the first rows of that run, number for number,
- every picture that has its name is that of the whole run, and summary.json is read,
- no other file has a final name, and the next run goes on, or begins where there is no checkpoint.

Some runs speak to a closed pipe, and some meet a second run that wants their folder.
"""

import argparse
import fcntl
import filecmp
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

try:
    import h5py  # noqa: F401, which plimsoll.read_log needs for run.h5
except ImportError:
    sys.exit(77)

import plimsoll

INTERRUPTED = 130
HERE = Path(__file__).resolve().parent

# How often each signal is sent, of 10 times.
SIGNALS = [signal.SIGKILL] * 7 + [signal.SIGTERM, signal.SIGHUP, signal.SIGINT]

# Options of each kind of run.
KINDS = {
    "rigged.yaml": ["--format", "csv"],
    "rigged.yaml ": ["--format", "hdf5"],
    "leaking.yaml": ["--format", "csv", "--threads", "1"],
    "drawn.yaml": ["--format", "hdf5"],
}

# What a folder may hold under a final name; a temporary file has a name of its own.
RESULTS = {
    "trajectory.csv", "forces.csv", "interior.csv", "probes.csv", "lines.csv", "machines.csv",
    "controls.csv", "joints.csv", "run.h5", "summary.json", "frames", "sheet.png",
    "checkpoint.bin", "checkpoint_shots.bin"}


class Wrong(Exception):
    """What a run has left is not what it should leave."""


def require(holds, text):
    if not holds:
        raise Wrong(text)


class Kind:
    """A scene and its options, with the run that nobody stops."""

    def __init__(self, program, name, folder):
        self.name = name.strip()
        self.arguments = [program, "run", str(HERE / self.name), *KINDS[name]]
        self.whole = folder / f"whole_{len(os.listdir(folder))}"
        started = time.monotonic()
        subprocess.run([*self.arguments, "--out", str(self.whole), "--quiet"], check=True)
        self.duration = time.monotonic() - started
        self.rows = plimsoll.read_log(self.whole)


def prefix_of(cut, whole):
    with open(cut, "rb") as a, open(whole, "rb") as b:
        return b.read().startswith(a.read())


def check_log(folder, kind, done):
    """Compares what a run has logged with the first rows of the whole run."""
    for file in sorted(kind.whole.glob("*.csv")):
        cut = folder / file.name
        if done or cut.exists():
            same = filecmp.cmp(cut, file, shallow=False) if done else prefix_of(cut, file)
            require(same, f"{file.name} differs from that of the whole run")
    if not (folder / "run.h5").exists():
        require(not done or not (kind.whole / "run.h5").exists(), "there is no run.h5")
        return
    try:
        log = plimsoll.read_log(folder / "run.h5")
    except ValueError as fault:
        # Before its first row the file has no series yet.
        require(not done and "has no" in str(fault), f"run.h5 is not read: {fault}")
        return
    count = len(log.time)
    require(not done or count == len(kind.rows.time), "rows are missing")
    for part in ("time", "position", "orientation", "velocity", "angular_velocity"):
        require(np.array_equal(getattr(log, part), getattr(kind.rows, part)[:count]),
                f"run.h5: {part} differs from that of the whole run")
    for table, names in log.tables.items():
        for name, columns in names.items():
            for column, numbers in columns.items():
                whole = kind.rows.tables[table][name][column][:len(numbers)]
                require(np.array_equal(numbers, whole, equal_nan=True),
                        f"run.h5: {column} of {name} differs from that of the whole run")


def check_pictures(folder, kind, done):
    """Each picture that has its name is whole."""
    pictures = sorted(kind.whole.rglob("*.png"))
    for picture in pictures if done else []:
        require((folder / picture.relative_to(kind.whole)).exists(), f"{picture.name} is missing")
    for picture in sorted(folder.rglob("*.png")):
        whole = kind.whole / picture.relative_to(folder)
        if whole.exists() and (done or picture.name != "sheet.png"):
            require(filecmp.cmp(picture, whole, shallow=False), f"{picture.name} differs")


def wait_for_copies(folder):
    """Waits until nobody writes any more: a copy of a killed program ends what it has begun."""
    descriptor = os.open(folder, os.O_RDONLY)
    fcntl.flock(descriptor, fcntl.LOCK_SH)
    os.close(descriptor)


def check_folder(folder, kind, done):
    if not done and not folder.exists():
        return
    wait_for_copies(folder)
    for file in folder.iterdir():
        require(file.name in RESULTS or ".part" in file.name, f"{file.name} is not a result")
    summary = folder / "summary.json"
    if summary.exists():
        try:
            json.loads(summary.read_text())
        except ValueError as fault:
            raise Wrong(f"summary.json is not whole: {fault}") from fault
    check_log(folder, kind, done)
    check_pictures(folder, kind, done)
    require(not done or not (folder / "checkpoint.bin").exists(), "a checkpoint is left")


def start(kind, folder, random_):
    """Starts a run, or resumes it. Now and then nobody reads what it says."""
    resumes = (folder / "checkpoint.bin").exists()
    arguments = (
        [kind.arguments[0], "run", "--resume", str(folder)] if resumes
        else [*kind.arguments, "--out", str(folder), "--checkpoint", "0.02"])
    if random_.random() < 0.3:
        reader, writer = os.pipe()
        os.close(reader)
        process = subprocess.Popen(arguments, stdout=writer, stderr=subprocess.DEVNULL)
        os.close(writer)
    else:
        process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return process, resumes


def intrude(kind, folder, process):
    """A second run into the same folder is refused and changes nothing.

    @return True if it came first and is whole: the run that was started before it is refused.
    """
    second = subprocess.run([*kind.arguments, "--out", str(folder)], capture_output=True, text=True,
                            check=False)
    if second.returncode == 0 and process.poll() == 2:
        return True
    if process.poll() is None:
        require(second.returncode == 2 and "another run is writing" in second.stderr,
                f"a second run was not refused: {second.returncode} {second.stderr}")
    return False


def soak_one(kind, folder, random_, left):
    """Kills and resumes one run until it ends or `left` kills are spent. Returns their number."""
    kills = 0
    while True:
        process, resumes = start(kind, folder, random_)
        if kills < left:
            time.sleep(random_.uniform(0, 0.9 * kind.duration))
            if resumes and random_.random() < 0.2 and intrude(kind, folder, process):
                check_folder(folder, kind, done=True)
                return kills
            sent = random_.choice(SIGNALS)
            process.send_signal(sent)
        code = process.wait()
        if code == 0:
            check_folder(folder, kind, done=True)
            return kills
        kills += 1
        require(code in (-sent, INTERRUPTED), f"it ended with {code} after the signal {sent}")
        check_folder(folder, kind, done=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=500, help="kills in all [500]")
    parser.add_argument("--seed", type=int, default=1, help="of the moments [1]")
    parser.add_argument("--keep", type=Path, help="folder for the runs, which are kept there")
    options = parser.parse_args()
    place = options.keep or Path(tempfile.mkdtemp(prefix="plimsoll_soak_"))
    place.mkdir(parents=True, exist_ok=True)
    random_ = random.Random(options.seed)
    kinds = [Kind(options.program, name, place) for name in KINDS]
    kills = runs = 0
    while kills < options.kills:
        kind = kinds[runs % len(kinds)]
        folder = place / f"cut_{runs}"
        try:
            kills += soak_one(kind, folder, random_, options.kills - kills)
        except Wrong as wrong:
            print(f"{folder} of {kind.name}, after {kills} kills: {wrong}")
            return 1
        runs += 1
        shutil.rmtree(folder)
        if sys.stdout.isatty() or runs % 10 == 0:
            print(f"{kills} kills, {runs} runs", end="\r" if sys.stdout.isatty() else "\n", flush=True)
    print(f"{kills} kills of {runs} runs: each left what it had logged, and ended as if not stopped")
    if not options.keep:
        shutil.rmtree(place)
    return 0


if __name__ == "__main__":
    sys.exit(main())
