"""Logs and sweeps as arrays."""

import numpy as np
import pytest

import plimsoll as pl
from conftest import BUOY, TUG


@pytest.fixture(scope="module")
def run(tmp_path_factory, program):
    folder = tmp_path_factory.mktemp("run")
    for format in ("csv", "hdf5"):
        program("run", "scene.yaml", "--out", format, "--no-render", "--quiet", "--format", format,
                "--set", "duration=3", scene=TUG, cwd=folder, allowed=(0, 2))
    return folder


def test_a_log_has_the_shapes_of_its_run(run):
    log = pl.read_log(run / "csv")
    assert log.bodies == ["tug", "barge"] and log.time.shape == (31,)
    assert log.position.shape == (31, 2, 3) and log.orientation.shape == (31, 2, 4)
    assert log.forces["buoyancy"].shape == (31, 2, 6) and log.forces["displaced_volume"].shape == (31, 2)
    assert log.tables["lines"]["ropes[tow]"]["tension"].shape == (31,)
    tug = log.body("tug")
    assert np.shares_memory(tug.position, log.position) and tug.forces["weight"].shape == (31, 6)
    with pytest.raises(KeyError, match="has no body 'ship'; it has tug, barge"):
        log.body("ship")


def test_both_formats_have_the_same_numbers(run):
    if not (run / "hdf5/run.h5").exists():
        pytest.skip("the program writes no HDF5")
    pytest.importorskip("h5py")
    a, b = pl.read_log(run / "csv"), pl.read_log(run / "hdf5")
    for name in ("time", "position", "orientation", "velocity", "angular_velocity"):
        assert np.array_equal(getattr(a, name), getattr(b, name)), name
    assert set(a.forces) == set(b.forces)
    for load in a.forces:
        assert np.array_equal(a.forces[load], b.forces[load]), load
    assert set(a.tables) == set(b.tables)
    for table, names in a.tables.items():
        assert set(names) == set(b.tables[table])
        for name, columns in names.items():
            assert set(columns) == set(b.tables[table][name])
            for column in columns:
                assert np.array_equal(columns[column], b.tables[table][name][column], equal_nan=True), (table, column)


def test_a_frame_of_pandas_has_the_columns_of_the_file(run):
    pandas = pytest.importorskip("pandas")
    frame = pl.read_log(run / "csv/trajectory.csv").frame()
    file = pandas.read_csv(run / "csv/trajectory.csv", float_precision="round_trip")
    assert list(frame.columns) == list(file.columns)
    assert frame.equals(file)


def test_a_log_that_was_cut_off_is_read_to_its_last_whole_time(run, tmp_path):
    text = (run / "csv/trajectory.csv").read_text()
    lines = text.splitlines(keepends=True)
    (tmp_path / "trajectory.csv").write_text("".join(lines[:8]) + lines[8][:30])
    log = pl.read_log(tmp_path)
    assert len(log.time) == 3 and np.array_equal(log.position, pl.read_log(run / "csv").position[:3])


def test_what_is_no_log_is_refused(tmp_path):
    with pytest.raises(FileNotFoundError, match="no trajectory.csv"):
        pl.read_log(tmp_path)
    (tmp_path / "trajectory.csv").write_text("a,b,c\n1,2,3\n")
    with pytest.raises(ValueError, match="is no log"):
        pl.read_log(tmp_path)


def test_a_sweep_is_a_table_with_its_runs(tmp_path, program):
    program("sweep", "scene.yaml", "--out", "out", "--vary", "bodies[0].density=300,600,900",
            "--set", "duration=0.5", "--quiet", scene=BUOY, cwd=tmp_path)
    sweep = pl.read_sweep(tmp_path / "out")
    assert len(sweep) == 3 and sweep.ended().all()
    assert list(sweep["bodies[0].density"]) == [300, 600, 900]
    assert sweep["message"].dtype.kind == "U" or np.isnan(sweep["message"]).all()
    log = sweep.log(2)
    assert log.position[-1, 0, 2] == sweep["buoy.z"][2]
    if pytest.importorskip("pandas"):
        assert list(sweep.frame()["run"]) == [0, 1, 2]
    with pytest.raises(FileNotFoundError):
        pl.read_sweep(tmp_path)
