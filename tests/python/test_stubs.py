"""The type stubs say what the module is, and the package passes a strict check of types."""

import os
import subprocess
import sys

import pytest

from conftest import ROOT

pytest.importorskip("mypy")


CLASSES = ("Batch", "Control", "Fault", "Mesh", "Scene", "Simulation")


def check(arguments, tmp_path):
    environment = {**os.environ, "MYPYPATH": str(ROOT / "app/python")}
    return subprocess.run([sys.executable, "-B", "-m", *arguments], capture_output=True, text=True, cwd=tmp_path,
                          env=environment)


def test_stubs_are_those_of_the_module(tmp_path):
    allowed = tmp_path / "allowed"
    # What pybind11 gives every class, its metaclass among them, and stubs do not name.
    allowed.write_text("\n".join(f"plimsoll._core.{name}" for name in CLASSES) + "\n"
                       r"plimsoll\._core\.\w+\.(__(init|repr|str|getstate|setstate)__|_pybind11_conduit_v1_)")
    config = tmp_path / "mypy.ini"
    config.write_text("[mypy]\nignore_missing_imports = True\n")
    done = check(["mypy.stubtest", "plimsoll._core", "--allowlist", str(allowed), "--ignore-unused-allowlist",
                  "--mypy-config-file", str(config)], tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_package_is_typed(tmp_path):
    done = check(["mypy", "--strict", "--ignore-missing-imports", "--cache-dir", str(tmp_path), "-p", "plimsoll"], tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_wrong_call_is_found(tmp_path):
    (tmp_path / "wrong.py").write_text(
        "import plimsoll as pl\nsim = pl.Simulation('a.yaml')\nsim.step('many')\nsim.positon\n")
    done = check(["mypy", "--ignore-missing-imports", "--cache-dir", str(tmp_path / "cache"), "wrong.py"], tmp_path)
    assert done.returncode == 1
    assert 'Argument 1 to "step" of "Simulation" has incompatible type' in done.stdout
    assert 'has no attribute "positon"' in done.stdout


def test_everything_public_has_a_docstring():
    import inspect

    import plimsoll as pl

    def described(member):
        # pybind11 begins the text of a function with its signature.
        text = inspect.getdoc(getattr(member, "__func__", member)) or ""
        return bool(text) and not (text.count("\n") == 0 and "->" in text)

    missing = []
    for name in pl.__all__:
        thing = getattr(pl, name)
        if name == "__version__":
            continue
        if not inspect.getdoc(thing):
            missing.append(name)
        if inspect.isclass(thing) and thing.__module__ == "plimsoll._core":
            missing += [f"{name}.{member}" for member, value in vars(thing).items()
                        if not member.startswith("_") and not described(value)]
    assert missing == []
