"""What is computed without a simulation, against closed forms."""

import math

import numpy as np
import pytest

import plimsoll as pl
from conftest import G, ROOT, turned


def test_a_mesh_is_its_vertices_and_faces():
    box = pl.Mesh.box([1, 2, 3])
    again = pl.Mesh(box.vertices, box.faces)
    assert box.vertices.shape == (8, 3) and box.faces.shape == (12, 3)
    assert again.volume == box.volume == pytest.approx(6) and again.area == pytest.approx(22)
    assert box.inertia == pytest.approx(6 / 12 * np.diag([13, 10, 5]), abs=1e-12)
    moved = box.moved([1, 1, 1]).scaled(2)
    assert moved.centroid == pytest.approx([2, 2, 2]) and moved.volume == pytest.approx(48)
    assert box.faults() == []


def test_a_mesh_file_is_read():
    teapot = pl.Mesh.load(ROOT / "scenes/meshes/teapot.obj")
    assert teapot.faults() == [] and teapot.volume > 0
    with pytest.raises(pl.SceneError):
        pl.Mesh.load(ROOT / "README.md")


def test_wrong_meshes_are_refused():
    box = pl.Mesh.box([1, 1, 1])
    with pytest.raises(ValueError, match="faces: an index names no vertex"):
        pl.Mesh(box.vertices, box.faces + 1)
    with pytest.raises(ValueError, match="vertices: expected"):
        pl.Mesh([1, 2, 3], box.faces)
    open_box = pl.Mesh(box.vertices, box.faces[1:])
    assert open_box.faults()
    with pytest.raises(ValueError, match="the mesh is no solid"):
        pl.loads(open_box)
    with pytest.raises(ValueError):
        pl.Mesh.box([1, 1, -1])


@pytest.mark.parametrize("angle", [0, 0.3, 2])
def test_a_submerged_body_is_lifted_by_the_weight_of_its_water(angle):
    mesh = pl.Mesh.ellipsoid([1, 0.6, 0.3])
    found = pl.loads(mesh, position=[1, 2, -9], orientation=turned([1, 2, 3], angle), water={"density": 1025})
    assert found["displaced_volume"] == pytest.approx(mesh.volume, rel=1e-12)
    assert found["buoyancy"] == pytest.approx([0, 0, 1025 * G * mesh.volume, 0, 0, 0], abs=1e-6)
    assert found["wetted_area"] == pytest.approx(mesh.area, rel=1e-12)
    assert found["total"] == pytest.approx(found["buoyancy"], abs=1e-9)


def test_drag_of_a_plate_is_that_of_its_coefficient():
    # A cube broadside: the front has C_p, the back and friction are switched off.
    mesh = pl.Mesh.box([1, 1, 1])
    still = pl.loads(mesh, position=[0, 0, -5])
    moving = pl.loads(
        mesh, position=[0, 0, -5], velocity=[2, 0, 0],
        hydro={"pressure_drag": {"front": 0.8, "back": 0, "blunt": 0}, "viscous_drag": False, "lift": False})
    assert moving["pressure_drag"][0] == pytest.approx(-0.5 * 1000 * 0.8 * 4, rel=1e-12)
    assert moving["buoyancy"] == pytest.approx(still["buoyancy"])


def test_a_wrong_block_of_water_is_a_fault():
    with pytest.raises(pl.SceneError, match="water.density"):
        pl.loads(pl.Mesh.box([1, 1, 1]), water={"density": -1})


def test_added_mass_of_a_sphere_is_half_its_water():
    mesh = pl.Mesh.icosphere(1, 3)
    found = pl.added_mass(mesh, density=1000)
    half = 500 * mesh.volume
    # The faceted sphere is off by as much as its volume is, and by the error estimate.
    assert np.diag(found["matrix"])[:3] == pytest.approx([half] * 3, rel=0.01)
    assert np.array_equal(found["matrix"], found["matrix"].T)
    about = pl.added_mass(mesh, density=1000, center_of_mass=[0, 0, 1])["matrix"]
    # Half its water moves with it: a lever of one metre.
    assert about[3, 3] - found["matrix"][3, 3] == pytest.approx(found["matrix"][0, 0], rel=1e-6)


def test_radiation_obeys_its_symmetries():
    mesh = pl.Mesh.icosphere(1, 3)
    found = pl.radiation(mesh, height=0.0, frequencies=[1.0, 3.0], headings=4)
    assert found["added_mass"].shape == found["damping"].shape == (2, 6, 6)
    assert found["diffraction"].shape == found["froude_krylov"].shape == (2, 4, 6)
    assert (np.diagonal(found["damping"], axis1=1, axis2=2) >= 0).all()
    for f in range(2):
        assert found["added_mass"][f] == pytest.approx(found["added_mass"][f].T)
    exciting = found["froude_krylov"] + found["diffraction"]
    # In long waves the vertical force is the weight of the water between crest and level.
    assert abs(exciting[0, 0, 2]) == pytest.approx(1000 * G * math.pi, rel=0.2)
    with pytest.raises(ValueError, match="ascending"):
        pl.radiation(mesh, height=0.0, frequencies=[3.0, 1.0])
    with pytest.raises(ValueError):
        pl.radiation(mesh, height=5.0)


def test_hydrostatics_of_a_box():
    box = pl.Mesh.box([4, 2, 1])
    found = pl.hydrostatics(box, 4 * 2 * 0.4 * 1000, heels=[0.1])
    assert found["floats"] is True
    draught = found["rest"]["draught"]
    assert draught == pytest.approx(0.4, rel=1e-9)
    # GM = KB + BM − KG
    gm = draught / 2 + 2**2 / 12 / draught - 0.5
    assert found["rest"]["gm_t"] == pytest.approx(gm, rel=1e-9)
    assert len(found["gz"]) == 1
    assert pl.hydrostatics(box, 1e6)["floats"] is not True
    with pytest.raises(ValueError):
        pl.hydrostatics(box, -1)
