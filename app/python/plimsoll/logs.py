"""The logs of a run as NumPy arrays."""

from __future__ import annotations

import csv
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, List, Tuple, Union

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]

_TABLES = ("lines", "joints", "machines", "controls", "probes", "interior")
# The titles of the columns of names, as HDF5 calls the tables' rows.
_ROWS = {"lines": "line", "joints": "joint", "machines": "machine", "controls": "set_point", "probes": "probe"}


@dataclass(frozen=True)
class BodyLog:
    """One body over time: a part of a Log, without copies."""

    name: str
    time: FloatArray  #: (T,) [s]
    position: FloatArray  #: (T, 3): the centre of mass, in W [m]
    orientation: FloatArray  #: (T, 4): w, x, y, z
    velocity: FloatArray  #: (T, 3), in W [m/s]
    angular_velocity: FloatArray  #: (T, 3), in W [rad/s]
    forces: Dict[str, FloatArray]  #: as Log.forces, without the axis of bodies


@dataclass(frozen=True)
class Log:
    """What a run logged: T times of N bodies."""

    file: Path
    bodies: List[str]
    time: FloatArray  #: (T,) [s]
    position: FloatArray  #: (T, N, 3): the centres of mass, in W [m]
    orientation: FloatArray  #: (T, N, 4): w, x, y, z
    velocity: FloatArray  #: (T, N, 3), in W [m/s]
    angular_velocity: FloatArray  #: (T, N, 3), in W [rad/s]
    #: Each load (T, N, 6) [N, N m] and each other column (T, N) of forces.csv; empty if not logged.
    forces: Dict[str, FloatArray] = field(default_factory=dict)
    #: The tables `lines`, `joints`, `machines`, `controls`, `probes` and `interior` that there are:
    #: tables["lines"]["ropes[tow]"]["tension"] is (T,).
    tables: Dict[str, Dict[str, Dict[str, FloatArray]]] = field(default_factory=dict)

    def body(self, name: str) -> BodyLog:
        """One body. Raises KeyError for an unknown name."""
        if name not in self.bodies:
            raise KeyError(f"{self.file} has no body {name!r}; it has {', '.join(self.bodies)}")
        i = self.bodies.index(name)
        return BodyLog(
            name=name,
            time=self.time,
            position=self.position[:, i],
            orientation=self.orientation[:, i],
            velocity=self.velocity[:, i],
            angular_velocity=self.angular_velocity[:, i],
            forces={load: values[:, i] for load, values in self.forces.items()},
        )

    def frame(self) -> Any:
        """The motion as a pandas frame with the columns of trajectory.csv. Needs pandas."""
        import pandas

        times, bodies = len(self.time), len(self.bodies)
        numbers = np.concatenate(
            [self.position, self.orientation, self.velocity, self.angular_velocity], axis=2
        ).reshape(times * bodies, 13)
        frame = pandas.DataFrame(numbers, columns="x y z qw qx qy qz vx vy vz wx wy wz".split())
        frame.insert(0, "time", np.repeat(self.time, bodies))
        frame.insert(1, "body", self.bodies * times)
        return frame


def read_log(run: Union[str, "os.PathLike[str]"]) -> Log:
    """Read the log of a run: its folder, a trajectory.csv, or a run.h5 (which needs h5py).

    A last time that was cut off is left out. Raises FileNotFoundError, and ValueError for a file
    that is no log.
    """
    path = Path(run)
    if path.is_dir():
        found = [path / name for name in ("run.h5", "trajectory.csv") if (path / name).exists()]
        if not found:
            raise FileNotFoundError(f"{path} has no trajectory.csv and no run.h5")
        path = found[0]
    if path.suffix == ".h5":
        return _read_hdf5(path)
    return _read_csv(path)


def _read_csv(file: Path) -> Log:
    header, names, numbers = _read_columns(file)
    if header[:2] != ["time", "body"] or len(header) != 15:
        raise ValueError(f"{file}: is no log of a motion: it begins with {','.join(header[:4])}")
    time = numbers[:, 0, 0]
    forces: Dict[str, FloatArray] = {}
    beside = file.with_name("forces.csv")
    if beside.exists():
        forces_header, forces_names, forces_numbers = _read_columns(beside)
        if forces_names == names:
            forces = _loads(forces_header[2:], forces_numbers[: len(time), :, 1:])
    tables = {}
    for table in _TABLES:
        place = file.with_name(f"{table}.csv")
        if place.exists():
            tables[table] = _read_table(place)
    return Log(
        file=file,
        bodies=names,
        time=time,
        position=numbers[:, :, 1:4],
        orientation=numbers[:, :, 4:8],
        velocity=numbers[:, :, 8:11],
        angular_velocity=numbers[:, :, 11:14],
        forces=forces,
        tables=tables,
    )


def _read_columns(file: Path) -> Tuple[List[str], List[str], FloatArray]:
    """Return the header, the names of the second column, and (T, N, columns) of numbers."""
    with open(file, encoding="utf-8", newline="") as stream:
        rows = csv.reader(stream)
        header: List[str] = next(rows, [])
        if len(header) < 3:
            raise ValueError(f"{file}: is no log")
        names: List[str] = []
        for row in rows:
            if len(row) < 2 or row[1] in names:
                break
            names.append(row[1])
    if not names:
        return header, names, np.empty((0, 0, len(header) - 1))
    columns = [0, *range(2, len(header))]
    with open(file, encoding="utf-8", newline="") as stream:
        lines = stream.readlines()[1:]
    if lines and not lines[-1].endswith("\n"):
        lines.pop()
    whole = len(lines) // len(names) * len(names)
    numbers = np.loadtxt(lines[:whole], delimiter=",", usecols=columns, ndmin=2, comments=None)
    return header, names, numbers.reshape(-1, len(names), len(columns))


def _loads(columns: List[str], numbers: FloatArray) -> Dict[str, FloatArray]:
    """Join the six columns of each load."""
    loads = {}
    i = 0
    while i < len(columns):
        if columns[i].endswith("_fx"):
            loads[columns[i][:-3]] = numbers[:, :, i : i + 6]
            i += 6
        else:
            loads[columns[i]] = numbers[:, :, i]
            i += 1
    return loads


def _read_table(file: Path) -> Dict[str, Dict[str, FloatArray]]:
    """Return name → column → (T,); an empty field is NaN."""
    collected: Dict[str, List[List[float]]] = {}
    with open(file, encoding="utf-8", newline="") as stream:
        rows = csv.reader(stream)
        header: List[str] = next(rows, [])
        # The water inside has two columns of names: the body and its pocket.
        keys = 2 if header[1:3] == ["body", "pocket"] else 1
        for row in rows:
            if len(row) < len(header):
                break
            name = ".".join(row[1 : 1 + keys])
            values = [row[0], *row[1 + keys :]]
            collected.setdefault(name, []).append([float(value) if value else np.nan for value in values])
    columns = ["time", *header[1 + keys :]]
    return {
        name: dict(zip(columns, np.array(values, dtype=float).T)) for name, values in collected.items()
    }


def _read_hdf5(file: Path) -> Log:
    import h5py

    with h5py.File(file, "r") as log:
        if "body" not in log or "position" not in log:
            raise ValueError(f"{file}: is no log of a motion")
        bodies = [_text(name) for name in log["body"][()]]
        time = log["time"][()]
        motion = ("position", "orientation", "linear_velocity", "angular_velocity")
        rows = set(_ROWS.values())
        forces = {}
        for name, data in log.items():
            own = name in motion or name in ("time", "body") or name in rows
            if not own and not any(name.startswith(row + "_") for row in rows):
                forces[name] = data[()]
        tables = {}
        for table, row in _ROWS.items():
            if row in log:
                tables[table] = _table_of(log, row, time)
        return Log(
            file=file,
            bodies=bodies,
            time=time,
            position=log["position"][()],
            orientation=log["orientation"][()],
            velocity=log["linear_velocity"][()],
            angular_velocity=log["angular_velocity"][()],
            forces=forces,
            tables=tables,
        )


def _table_of(log: Any, row: str, time: FloatArray) -> Dict[str, Dict[str, FloatArray]]:
    names = [_text(name) for name in log[row][()]]
    table: Dict[str, Dict[str, FloatArray]] = {name: {"time": time} for name in names}
    for name, data in log.items():
        if not name.startswith(row + "_"):
            continue
        titles = data.attrs.get("columns", name[len(row) + 1 :])
        columns = _text(titles).replace(",", " ").split() if isinstance(titles, (str, bytes)) else [_text(t) for t in titles]
        values = data[()]
        for i, of in enumerate(names):
            for j, column in enumerate(columns):
                table[of][column] = values[:, i] if values.ndim == 2 else values[:, i, j]
    return table


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
