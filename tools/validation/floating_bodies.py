"""Bodies whose motions in waves linear theory tells: what the equations of motion need of them.

They are those of scenes/validation/*_in_waves.yaml, in water of 1000 kg/m³.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np

kTable = Path(__file__).with_name("linear_motions.csv")
kDensity = 1000.0
kMotions = ("surge", "heave", "pitch")


@dataclass(frozen=True)
class Inertia:
    """What the linear equations of motion need of a floating body, about its centre of mass."""

    mass: float
    pitch: float  # Moment of inertia [kg m²].
    heave_stiffness: float  # ρ g times the waterplane's area [N/m].
    pitch_stiffness: float  # ρ g V GM [N m].
    centre: float  # Height of the centre of mass above the water [m].


@dataclass(frozen=True)
class Floating:
    """A body at rest in still water."""

    name: str
    length: float  # The largest dimension, of a spar with its mirror image in the surface [m].
    inertia: Inertia
    wavelengths: tuple[float, ...]  # Those of the reference [m].
    motions: tuple[str, ...] = kMotions


def _sphere() -> Floating:
    mass = kDensity * 2 / 3 * np.pi
    inertia = Inertia(mass, 0.4 * mass, 1.5 * 9.80665 * mass, 0, 0)
    return Floating("sphere", 2, inertia, (8, 10, 13, 16, 20, 25, 30, 40, 60, 80),
                    ("surge", "heave"))


def _barge() -> Floating:
    length, breadth, draft = 20, 8, 1.5
    mass = kDensity * length * breadth * draft
    metacentric = length**2 / (12 * draft) - draft / 2
    inertia = Inertia(mass, mass * (length**2 + (2 * draft)**2) / 12,
                      9.80665 * mass / draft, 9.80665 * mass * metacentric, 0)
    return Floating("barge", length, inertia,
                    (20, 25, 30, 40, 50, 60, 80, 100, 150, 200, 400, 800))


def _spar() -> Floating:
    draft, centre = 10, -6
    mass = kDensity * np.pi * draft
    metacentric = 1 / (4 * draft) - draft / 2 - centre
    inertia = Inertia(mass, 12.25 * mass, 9.80665 * mass / draft,
                      9.80665 * mass * metacentric, centre)
    return Floating("spar", 2 * draft, inertia,
                    (15, 20, 25, 30, 35, 40, 50, 58, 80, 100, 115, 145, 170, 200, 250, 300, 400,
                     800))


kBodies = {body.name: body for body in (_sphere(), _barge(), _spar())}


def linear_motions(name: str, motion: str) -> tuple[np.ndarray, np.ndarray]:
    """The reference: wavelengths [m], and complex amplitudes over the wave's (pitch: over its slope
    k a), x = Re(amplitude e^{iωt}) under a crest at time 0."""
    with open(kTable, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file)
                if row["body"] == name and row["motion"] == motion]
    lead = np.radians([float(row["phase_deg"]) for row in rows])
    return (np.array([float(row["wavelength"]) for row in rows]),
            np.array([float(row["amplitude"]) for row in rows]) * np.exp(1j * lead))
