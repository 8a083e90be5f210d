"""What this machine has to run what the documents tell a reader to type."""

import argparse
import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

MOST_TIME = 240  # That a command may take [s].

# What a command needs that a machine may lack: a program, the pages that npm bundles, or modules.
NEEDS = {"--video": "ffmpeg", "plimsoll report": "pages", "--html": "pages",
         "tools/rao": "NumPy, matplotlib and yaml"}


class Machine:
    """The program under test, by its name `plimsoll`, and what may be missing beside it."""

    def __init__(self, folder, program, module, pages):
        self.module = module
        self.has = {"ffmpeg": shutil.which("ffmpeg") is not None,
                    "pages": pages is not None and (Path(pages) / "page.html").exists(),
                    "NumPy, matplotlib and yaml": all(
                        importlib.util.find_spec(name) for name in ("numpy", "matplotlib", "yaml"))}
        program = Path(program).resolve()
        (folder / "bin").mkdir()
        (folder / "bin/plimsoll").symlink_to(program)
        self.environment = {**os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}",
                            "PLIMSOLL": str(program), "MPLCONFIGDIR": str(folder),
                            "PYTHONPATH": module or "", "LIBGL_ALWAYS_SOFTWARE": "1"}

    def missing_of(self, command):
        """What the machine lacks for a command; empty if nothing."""
        return {need for part, need in NEEDS.items() if part in command and not self.has[need]}

    def lacks(self, module):
        """True if Python has no such module."""
        if module == "plimsoll":
            return self.module is None or not list(Path(self.module).glob("plimsoll/_core*"))
        return importlib.util.find_spec(module) is None

    def run(self, words, folder, text=None):
        """Runs a command in a folder; returns how it ended and what it printed."""
        return subprocess.run(words, cwd=folder, env=self.environment, text=True, timeout=MOST_TIME,
                              input=text, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def faults_of(self, words, folder, codes=frozenset({0}), text=None):
        """Runs a command in a folder and says what is wrong with how it ended."""
        try:
            ended = self.run(words, folder, text)
        except subprocess.TimeoutExpired:
            return [f"{shlex.join(words)}: did not end within {MOST_TIME} s"]
        if ended.returncode in codes and "Traceback (most recent" not in ended.stdout:
            return []
        return [f"{shlex.join(words)}: ended with {ended.returncode}\n{ended.stdout[-2000:]}"]


def options_of_test():
    """The options that tests of documents have in common."""
    parser = argparse.ArgumentParser()
    parser.add_argument("program", nargs="?")
    parser.add_argument("--module", help="folder of the module plimsoll")
    parser.add_argument("--pages", help="folder of the pages that npm bundles")
    parser.add_argument("--self-test", action="store_true")
    return parser


def end_with(faults):
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)
