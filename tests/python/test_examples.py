"""The examples of the documentation, each run as its reader would, with what it claims."""

import re
import subprocess
import sys

import pytest

from conftest import ROOT

pytest.importorskip("matplotlib")


def run(name, folder, *arguments):
    """Run an example; return its output after checking its picture."""
    done = subprocess.run([sys.executable, "-B", ROOT / f"app/python/examples/{name}.py", folder, *arguments],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    picture = (folder / f"{name}.png").read_bytes()
    assert picture.startswith(b"\x89PNG") and len(picture) > 10000
    return done.stdout


def numbers(text, pattern):
    return [float(number) for number in re.findall(pattern, text)]


def test_the_teapot_sinks_and_comes_up_again(tmp_path):
    (lowest,) = numbers(run("drop_teapot", tmp_path), r"lowest (\S+) m")
    assert -2 < lowest < -0.3


def test_heave_in_waves_is_that_of_linear_theory(tmp_path):
    (error,) = numbers(run("waves", tmp_path), r"theory: (\S+) %")
    assert error < 4


def test_a_heavier_ball_from_higher_dives_deeper(tmp_path):
    depth, density, height = numbers(run("study", tmp_path), r"(-?[\d.]+)(?= m at| kg| m$)")
    assert (density, height) == (900, 4) and 1 < depth < 4


def test_the_autopilot_reaches_its_course(tmp_path):
    text = run("autopilot", tmp_path)
    end, target = map(float, re.search(r"end (\S+) deg, target (\S+) deg", text).groups())
    assert abs(end - target) < 5


def test_the_decay_is_that_of_the_experiments(tmp_path):
    errors = numbers(run("decay", tmp_path), r"\(([-+][\d.]+) %\)")
    assert len(errors) == 6
    assert max(map(abs, errors[0::2])) < 1  # periods
    assert max(map(abs, errors[1::2])) < 7  # troughs


def test_a_controller_that_keeps_station_is_learned(tmp_path):
    text = run("keep_station", tmp_path, "--generations", "8")
    idle, learned = map(float, re.search(r"cost (\S+) idle, (\S+) learned", text).groups())
    assert learned < idle / 5
