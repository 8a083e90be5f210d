"""The table and the runs of `plimsoll sweep`."""

from __future__ import annotations

import csv
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List, Union

import numpy as np
import numpy.typing as npt

from plimsoll.logs import Log, read_log


@dataclass(frozen=True)
class Sweep:
    """A sweep: R runs."""

    folder: Path
    #: The columns of sweep.csv by title, (R,): numbers, or texts where not all are numbers. What a
    #: run lacks is NaN or an empty text.
    columns: Dict[str, npt.NDArray[Any]]

    def __len__(self) -> int:
        return len(self.columns["run"])

    def __getitem__(self, title: str) -> npt.NDArray[Any]:
        return self.columns[title]

    def ended(self) -> npt.NDArray[np.bool_]:
        """Return a mask of the runs that ended well."""
        mask: npt.NDArray[np.bool_] = self.columns["exit_code"] == 0
        return mask

    def folder_of(self, run: int) -> Path:
        """Return the folder of a run, counted as in the column `run`."""
        return self.folder / "runs" / f"{run:04d}"

    def log(self, run: int) -> Log:
        """Read the log of a run."""
        return read_log(self.folder_of(run))

    def frame(self) -> Any:
        """Return the table as a pandas frame. Needs pandas."""
        import pandas

        return pandas.DataFrame(self.columns)


def read_sweep(folder: Union[str, "os.PathLike[str]"]) -> Sweep:
    """Read the folder of a sweep. Raises FileNotFoundError if it has no sweep.csv."""
    path = Path(folder)
    with open(path / "sweep.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    if not rows or rows[0][:1] != ["run"]:
        raise ValueError(f"{path / 'sweep.csv'}: is no table of a sweep")
    columns = {title: _column([row[i] for row in rows[1:]]) for i, title in enumerate(rows[0])}
    return Sweep(folder=path, columns=columns)


def _column(texts: List[str]) -> npt.NDArray[Any]:
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts)
