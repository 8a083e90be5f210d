"""A ship under way in waves, against strip theory's terms of forward speed."""

from dataclasses import dataclass

import numpy as np

from case import Case, Curve, Plot, Result, compare
from plimsoll import Plimsoll, Track

kScene = "validation/wigley_under_way.yaml"

kLength, kGravity, kDensity = 3.0, 9.80665, 1000.0
kMass, kMoment = 74.9, 42.1
kFroudeNumbers = (0.0, 0.2, 0.3)
kWavelengths = (1.0, 1.25, 1.5, 2.0)  # Over the length.
kSteepness = 1 / 600  # Amplitude over wavelength.
kGoals = {"heave": 0.03, "pitch": 0.03}


@dataclass(frozen=True)
class AtRest:
    """Heave and pitch without forward speed, as the program solves them, e^{−iωt}."""

    frequencies: np.ndarray
    added_mass: np.ndarray
    damping: np.ndarray
    froude_krylov: np.ndarray
    diffraction: np.ndarray
    stiffness: np.ndarray

    def at(self, values: np.ndarray, frequency: float) -> np.ndarray:
        return values[np.argmin(np.abs(self.frequencies - frequency))]


def speeds() -> list[float]:
    return [froude * np.sqrt(kGravity * kLength) for froude in kFroudeNumbers]


def encounter(speed: float, k: float) -> float:
    return np.sqrt(kGravity * k) + k * speed


def at_rest(plimsoll: Plimsoll) -> AtRest:
    wave_numbers = [2 * np.pi / (ratio * kLength) for ratio in kWavelengths]
    met = {encounter(speed, k) for speed in (0.0, *speeds()) for k in wave_numbers}
    found = plimsoll.radiation(plimsoll.scenes / kScene, sorted(met))
    rows = found["frequencies"]
    pair = np.ix_((2, 4), (2, 4))
    head = len(found["headings"]) // 2

    def load(row: dict, part: str) -> np.ndarray:
        return (np.array(row[f"{part}_real"])[head]
                + 1j * np.array(row[f"{part}_imag"])[head])[[2, 4]]

    floats = plimsoll.hydrostatics(kScene)["start"]
    metacentric = floats["gm_l"]
    return AtRest(np.array([row["omega"] for row in rows]),
                  np.array([np.array(row["added_mass"])[pair] for row in rows]),
                  np.array([np.array(row["damping"])[pair] for row in rows]),
                  np.array([load(row, "froude_krylov") for row in rows]),
                  np.array([load(row, "diffraction") for row in rows]),
                  np.diag([kDensity * kGravity * floats["waterplane_area"],
                           kMass * kGravity * metacentric]))


def strip_theory(ship: AtRest, speed: float, k: float) -> np.ndarray:
    """Heave [m/m] and pitch over the slope of the wave, with the terms of speed of Salvesen, Tuck
    and Faltinsen (1970) for a ship whose ends are sharp.

    Their loads of a wave are F_3 = ρα ∫ (f + h) dξ and F_5 = −ρα ∫ [ξ (f + h) + U/(iω) h] dξ for
    e^{iωt}, with the Froude-Krylov part f and the part h ~ ω₀ψ of the diffraction, whose potential
    ψ ~ iω is that of heave at the frequency of encounter ω. So h grows as ω/ω₀ from its value at
    rest, and with e^{−iωt}, as here, the last term of F_5 is + U/(iω) F_D3. What ψ/iω itself
    changes by between ω₀ and ω is left out, here as in the program.
    """
    w = encounter(speed, k)
    a, b = ship.at(ship.added_mass, w).copy(), ship.at(ship.damping, w).copy()
    a33, b33 = a[0, 0], b[0, 0]
    a += np.array([[0, -speed / w**2 * b33],
                   [speed / w**2 * b33, (speed / w)**2 * a33]])
    b += np.array([[0, speed * a33], [-speed * a33, (speed / w)**2 * b33]])
    inertia = np.diag([kMass, kMoment])
    impedance = -w**2 * (inertia + a) - 1j * w * b + ship.stiffness
    still = encounter(0, k)
    scattered = w / still * ship.at(ship.diffraction, still)
    excitation = ship.at(ship.froude_krylov, still) + scattered
    excitation[1] += speed / (1j * w) * scattered[0]
    motion = np.linalg.solve(impedance, excitation)
    return np.abs(motion) / (1, k)


def run_motion(plimsoll: Plimsoll, speed: float, k: float) -> np.ndarray:
    w = encounter(speed, k)
    amplitude = kSteepness * 2 * np.pi / k
    period = 2 * np.pi / w
    track: Track = plimsoll.run_one(kScene, f"under_way_{speed:.3f}_{k:.3f}", {
        "water.current": [-speed, 0, 0],
        "water.surface.waves[0]": {"amplitude": amplitude, "wavelength": 2 * np.pi / k,
                                   "heading_deg": 180},
        "duration": 12 + 8 * period})
    last = track.t > track.t[-1] - 6 * period
    t, q = track.t[last], track.quaternion[last].T
    series = np.column_stack([track.position[last][:, 2], 2 * np.arctan2(q[2], q[0])])
    base = np.column_stack([np.cos(w * t), np.sin(w * t), np.ones_like(t), t])
    fit = np.linalg.lstsq(base, series, rcond=None)[0]
    return np.hypot(fit[0], fit[1]) / (amplitude, amplitude * k)


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    ship = at_rest(plimsoll)
    for froude, speed in zip(kFroudeNumbers, speeds()):
        expected, found = [], []
        for ratio in kWavelengths:
            k = 2 * np.pi / (ratio * kLength)
            expected.append(strip_theory(ship, speed, k))
            found.append(run_motion(plimsoll, speed, k))
            for i, (motion, goal) in enumerate(kGoals.items()):
                result.rows.append(compare(
                    f"{motion}, Fn = {froude:g}, λ = {ratio:g} L",
                    "m/m" if motion == "heave" else "–", expected[-1][i], found[-1][i],
                    goal if froude > 0 else 0.02, kind="goal",
                    headline=froude == 0.3 and ratio == 1.25))
        curves = []
        for i, motion in enumerate(kGoals):
            curves += [Curve(f"{motion}, strip theory", kWavelengths,
                             [one[i] for one in expected], ("k-", "k--")[i]),
                       Curve(f"{motion}, ours", kWavelengths, [one[i] for one in found],
                             ("o", "s")[i])]
        result.plots.append(Plot(f"Wigley's hull at Fn = {froude:g}", "wavelength over length",
                                 "amplitude over a, pitch over ka", curves))
    return result


kCases = [
    Case("ship_under_way", "Waves", "A ship under way in head waves",
         "Wigley's hull of 3 m, free to heave and pitch, in head waves of small height at Froude "
         "numbers up to 0.3. Radiation and diffraction are those of the ship at rest, whose frame "
         "pitches with the hull; the momentum of the water that it moves, of the waves that it "
         "makes and of those that it scatters turns it by Kirchhoff's equations.",
         "Strip theory: the program's own coefficients at rest with the terms of forward speed, "
         "those of the diffraction among them (their F_3 and F_5), of Salvesen, Tuck and Faltinsen "
         "(SNAME 78 (1970) 250) at the frequency of encounter. The tolerances are goals: 3 % of "
         "heave and pitch, and 2 % without speed. Without radiation the heave is up to six times too "
         "large.", [kScene], measure),
]
