"""Fits C_p of front and back to the tabulated drag of bluff bodies and prints the optimum:

    /usr/bin/python3 -B tools/validation/fit_drag.py
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bluff_bodies import kBodies

kLargest = 2.0  # No optimum lies beyond: a C_p of 2 is twice that of a stagnant front.


@dataclass(frozen=True)
class Fit:
    front: float
    back: float
    objective: float  # Mean of |log(C_d ours / C_d tabulated)|.


def objective(front: np.ndarray, back: np.ndarray) -> np.ndarray:
    """At each pair; infinite without any drag."""
    with np.errstate(divide="ignore"):
        logs = [np.abs(np.log((front * body.front + back * body.back) / body.tabulated))
                for body in kBodies]
    return np.mean(logs, axis=0)


def best_of(fronts: np.ndarray, backs: np.ndarray) -> Fit:
    front, back = np.meshgrid(fronts, backs, indexing="ij")
    values = objective(front, back)
    best = np.unravel_index(np.argmin(values), values.shape)
    return Fit(float(front[best]), float(back[best]), float(values[best]))


def fit_drag(spacing: float = 0.01) -> Fit:
    """The best pair of a grid over 0 to 2. The objective has a kink wherever a body is met
    exactly, and minima only there, so that a search by slopes might stop early."""
    grid = spacing * np.arange(round(kLargest / spacing) + 1)
    return best_of(grid, grid)


def refined(coarse: Fit, half_width: float = 0.02, spacing: float = 1e-4) -> Fit:
    """On a finer grid about a fit."""
    offsets = spacing * np.arange(-round(half_width / spacing), round(half_width / spacing) + 1)
    return best_of(np.maximum(0, coarse.front + offsets), np.maximum(0, coarse.back + offsets))


def main() -> None:
    coarse = fit_drag()
    fine = refined(coarse)
    print(f"grid of 0.01:   front {coarse.front:.2f}, back {coarse.back:.2f}, "
          f"objective {coarse.objective:.5f}")
    print(f"grid of 0.0001: front {fine.front:.4f}, back {fine.back:.4f}, "
          f"objective {fine.objective:.5f}")
    for body in kBodies:
        ours = body.drag_coefficient(coarse.front, coarse.back)
        print(f"{body.title:30} tabulated {body.tabulated:.2f}  fitted {ours:.2f}  "
              f"error {ours / body.tabulated - 1:+.0%}")


if __name__ == "__main__":
    main()
