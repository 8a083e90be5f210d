"""Scenes from Python: files, dicts, changes and their faults."""

import json
import os
import pickle

import numpy as np
import pytest

import plimsoll as pl
from conftest import BUOY, ROOT


def test_a_file_is_read(tmp_path):
    file = tmp_path / "buoy.yaml"
    file.write_text(json.dumps(BUOY))
    for name in (file, str(file)):
        scene = pl.Scene.load(name)
        assert scene.bodies == ["buoy"]
        assert (scene.step, scene.duration) == (0.01, 5)
        assert scene.text == json.dumps(BUOY)
        assert scene.file == str(file)


def test_every_shipped_scene_is_read():
    for file in sorted((ROOT / "scenes").glob("*.yaml")):
        assert pl.Scene.load(file).bodies


def test_set_replaces_and_adds_keys():
    changed = {
        "bodies[buoy].density": np.float64(250),
        "bodies[0].position": np.array([1.0, 2.0, 3.0]),
        "bodies[0].hydro.added_mass": "none",
        "title": "changed",
        "step": 1 / 3,
    }
    scene = pl.Scene.load(BUOY, set=changed)
    assert scene.title == "changed" and scene.step == 1 / 3
    sim = pl.Simulation(scene)
    np.testing.assert_allclose(sim.position, [[1, 2, 3]], rtol=0, atol=1e-15)
    assert sim.mass[0] == pytest.approx(250 * pl.Mesh.sphere(0.5, 16, 8).volume, rel=1e-12)


def test_faults_name_file_line_column_key_and_what_was_expected(tmp_path):
    file = tmp_path / "wrong.yaml"
    file.write_text("plimsoll: 1\nduration: 5\nwater: {density: -3}\nbodies:\n  - {name: a, boks: {size: [1, 1, 1]}, mass: 1}\n")
    with pytest.raises(pl.SceneError) as caught:
        pl.Scene.load(file)
    faults = caught.value.faults
    assert [(f.path, f.line) for f in faults] == [("water.density", 3), ("bodies[0]", 5), ("bodies[0].boks", 5)]
    assert faults[0].file == str(file) and faults[0].column == 18
    assert "found -3, expected a positive number" in faults[0].text
    assert str(faults[0]) in str(caught.value)
    assert isinstance(caught.value, ValueError)


def test_a_fault_of_a_dict_names_its_key():
    with pytest.raises(pl.SceneError) as caught:
        pl.Scene.load({**BUOY, "gravty": 3})
    assert [f.path for f in caught.value.faults] == ["gravty"]
    assert "did you mean gravity?" in caught.value.faults[0].text
    assert "<dict>" in caught.value.faults[0].file


def test_a_fault_of_set_says_so():
    with pytest.raises(pl.SceneError, match="--set step: found -1"):
        pl.Scene.load(BUOY, set={"step": -1})


def test_a_mesh_that_is_not_there_is_a_fault_of_the_scene():
    body = {"name": "a", "mesh": {"file": "nowhere.obj"}, "mass": 1}
    with pytest.raises(pl.SceneError, match="a file; there is none"):
        pl.Scene.load({**BUOY, "bodies": [body]})


def test_meshes_of_other_formats_are_read_on_request(tmp_path):
    mesh = tmp_path / "a.raw"
    mesh.write_text("0 0 0 0 1 0 1 0 0\n0 0 0 1 0 0 0 0 1\n0 0 0 0 0 1 0 1 0\n1 0 0 0 1 0 0 0 1\n")
    scene = {**BUOY, "bodies": [{"name": "a", "mesh": {"file": str(mesh)}, "density": 500}]}
    with pytest.raises(pl.SceneError, match="any_format=True"):
        pl.Simulation(pl.Scene.load(scene))
    with pytest.raises(pl.SceneError, match="any_format=True"):
        pl.Mesh.load(mesh)
    volume = pl.Mesh.load(mesh, any_format=True).volume
    read = pl.Scene.load(scene, any_format=True)
    assert pl.Simulation(read).mass[0] == pytest.approx(500 * volume)
    changed = pl.Scene.load(read, set={"bodies[a].density": 600})
    assert pl.Simulation(changed).mass[0] == pytest.approx(600 * volume)


def test_a_mesh_has_the_axis_and_unit_that_are_asked_for():
    mesh = ROOT / "tests/data/meshes/hull_mm.obj"
    hull = pl.Mesh.load(mesh, up="y", unit="mm")
    assert hull.volume == pytest.approx(3.2 * 1.2 * 0.8)
    assert hull.vertices[:, 2].max() == pytest.approx(0.8)
    assert pl.Mesh.load(mesh, unit="m", scale=1e-3).volume == pytest.approx(hull.volume)
    with pytest.raises(ValueError, match="unit: found yd, expected one of mm, cm, m, in, ft"):
        pl.Mesh.load(mesh, unit="yd")


def test_a_mesh_is_read_while_other_threads_work(tmp_path):
    simulation = pl.Simulation(BUOY, threads=2)
    simulation.step(10)
    read = [pl.Mesh.load(ROOT / "scenes/meshes/barge.obj").volume for _ in range(20)]
    assert len(set(read)) == 1
    simulation.step(10)


def test_paths_of_a_dict_are_relative_to_the_working_directory():
    before = os.getcwd()
    os.chdir(ROOT / "scenes")
    try:
        body = {"name": "pot", "mesh": {"file": "meshes/teapot.obj"}, "density": 900, "hydro": {"added_mass": "none"}}
        scene = pl.Scene.load({**BUOY, "bodies": [body]})
    finally:
        os.chdir(before)
    assert pl.Simulation(scene).mass[0] > 0


@pytest.mark.parametrize("value", [object(), {1, 2}, 1j])
def test_what_no_scene_can_hold_is_refused(value):
    with pytest.raises(TypeError):
        pl.Scene.load(BUOY, set={"title": value})


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_numbers_that_are_not_finite_are_faults(value):
    with pytest.raises(pl.SceneError):
        pl.Scene.load(BUOY, set={"step": value})


def test_a_file_that_is_missing_is_a_fault(tmp_path):
    with pytest.raises(pl.SceneError) as caught:
        pl.Scene.load(tmp_path / "none.yaml")
    assert caught.value.faults[0].file.endswith("none.yaml")


def test_set_points_have_the_names_of_the_scene(tug):
    assert "propellers[main].speed_rps" in tug.set_points
    assert "rudders[rudder].angle_deg" in tug.set_points


@pytest.mark.parametrize("key", ["", ".", "[", "bodies[", "bodies[7].mass"])
def test_a_key_that_cannot_be_set_is_a_fault(key):
    with pytest.raises(pl.SceneError):
        pl.Scene.load(BUOY, set={key: 1})


def test_an_error_survives_pickling_with_its_faults():
    with pytest.raises(pl.SceneError) as caught:
        pl.Scene.load({"plimsoll": 1, "duration": -1, "stepp": 2, "bodies": []})
    error = caught.value
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        back = pickle.loads(pickle.dumps(error, protocol))
        assert type(back) is pl.SceneError
        assert str(back) == str(error)
        assert [str(fault) for fault in back.faults] == [str(fault) for fault in error.faults]
        assert [(f.file, f.line, f.column, f.path, f.text) for f in back.faults] == [
            (f.file, f.line, f.column, f.path, f.text) for f in error.faults]
    assert [fault.path for fault in back.faults] == ["duration", "stepp"]
