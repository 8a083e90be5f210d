"""Motions of floating bodies in waves, against linear theory."""

import sys
from pathlib import Path

import numpy as np

from case import Case, Curve, Plot, Result, Row, compare
from floating_bodies import Floating, kBodies, linear_motions
from plimsoll import Plimsoll, Track

sys.path.append(str(Path(__file__).resolve().parents[2] / "seakeeping"))

from harmonics import response  # noqa: E402

kGravity = 9.80665
kRuns = {"sphere": (10, 20, 30, 40, 80), "barge": (30, 40, 60, 100, 200, 800),
         "spar": (20, 30, 40, 80, 200, 800)}
kResonant = {"sphere": (10,), "barge": (30,), "spar": (80,)}
kHeadlines = {"sphere": (10, 20), "barge": (30, 100), "spar": (40, 80)}
kGoal, kResonantGoal = 0.03, 0.1
kLong = 40  # Body lengths: where waves are long for the body, every motion is judged.
kLongGoal = 0.01
kAmplitude = 3e-4  # Of the waves, over the length of the body.
kCycles, kSteps, kStates = 24, 100, 40  # Periods of a run; steps and logged states in a period.
# The freeboard of the scene's spar is 2 m, this one's its draught: what is dry does not matter.
kHighSpar = {"bodies[0].cylinder": {"radius": 1, "height": 20, "slices": 48, "stacks": 20},
             "bodies[0].position": [0, 0, 0], "bodies[0].center_of_mass": [0, 0, -6]}


def operators(body: Floating, track: Track, wavelength: float) -> dict[str, complex]:
    """First harmonics over the amplitude of the wave, pitch over its slope."""
    k, amplitude = 2 * np.pi / wavelength, kAmplitude * body.length
    w, x, y, z = track.quaternion.T
    pitch = np.arcsin(np.clip(2 * (w * y - z * x), -1, 1))
    series = {"surge": track.position[:, 0], "heave": track.position[:, 2], "pitch": pitch}
    return {name: response(track.t, series[name], np.sqrt(kGravity * k),
                           k * track.position[:, 0]).amplitude
            / (amplitude * (k if name == "pitch" else 1)) for name in body.motions}


def measured(plimsoll: Plimsoll, body: Floating, wavelength: float,
             changes: dict | None = None) -> dict[str, complex]:
    period = np.sqrt(2 * np.pi * wavelength / kGravity)
    wave = {"amplitude": kAmplitude * body.length, "wavelength": wavelength}
    name = f"{body.name}_{wavelength}_{len(changes or {})}"
    track = plimsoll.run_one(f"validation/{body.name}_in_waves.yaml", name, {
        "water.surface": {"waves": [wave]}, "duration": kCycles * period,
        "step": period / kSteps, "log.every": period / kStates, **(changes or {})})
    return operators(body, track, wavelength)


def theory(body: Floating, motion: str, wavelength: float) -> float:
    lengths, reference = linear_motions(body.name, motion)
    return abs(reference[np.flatnonzero(lengths == wavelength)[0]])


def row_of(body: Floating, motion: str, wavelength: float, ours: complex) -> Row:
    long = wavelength == kLong * body.length
    resonant = wavelength in kResonant[body.name]
    tolerance = kLongGoal if long else kResonantGoal if resonant else kGoal
    unit = "–" if motion == "pitch" else "m/m"
    return compare(f"{motion} of the {body.name}, λ = {wavelength} m", unit,
                   theory(body, motion, wavelength), abs(ours), tolerance, kind="goal",
                   headline=motion == "heave" and wavelength in kHeadlines[body.name])


def plot_of(body: Floating, ours: dict[int, dict[str, complex]]) -> Plot:
    curves = []
    for style, motion in zip(("k-", "k--", "k:"), body.motions):
        lengths, reference = linear_motions(body.name, motion)
        curves.append(Curve(f"{motion}, linear theory", lengths, np.abs(reference), style))
    for style, motion in zip("os^", body.motions):
        curves.append(Curve(f"{motion}, ours", list(ours),
                            [abs(one[motion]) for one in ours.values()], style))
    return Plot(f"A floating {body.name} in regular waves", "wavelength [m]",
                "amplitude over a, pitch over ka", curves, log_x=True, log_y=body.name != "sphere")


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    for name, wavelengths in kRuns.items():
        body = kBodies[name]
        ours = {length: measured(plimsoll, body, length) for length in wavelengths}
        result.rows += [row_of(body, motion, length, one[motion])
                        for length, one in ours.items() for motion in body.motions]
        result.plots.append(plot_of(body, ours))
    spar = kBodies["spar"]
    for length in (30, 40):
        heave = abs(measured(plimsoll, spar, length, kHighSpar)["heave"])
        result.rows.append(compare(f"heave of a spar with 10 m freeboard, λ = {length} m", "m/m",
                                   theory(spar, "heave", length), heave, kGoal, kind="goal"))
    return result


kCases = [
    Case("floating_motions", "Waves", "Motions of floating bodies in regular waves",
         "A sphere of 1 m radius, a barge of 20 × 8 m with 1.5 m draught and a spar of 1 m radius "
         "and 10 m draught float without drag in waves of small height; the amplitude of each "
         "motion comes from a fit that tells free oscillations apart. The program solves for the "
         "waves that the body sends out and scatters, and remembers them by oscillators.",
         "Linear radiation and diffraction by boundary elements, which share nothing with the "
         "program (potential_flow.py); on a hemisphere they give added mass, damping and force to "
         "0.7 % of WAMIT's. The tolerances are goals: 3 % in every motion, 10 % at resonance, "
         "and 1 % in waves of 40 body lengths.",
         [f"validation/{name}_in_waves.yaml" for name in kRuns], measure),
]
