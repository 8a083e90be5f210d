"""Waves as bodies meet them: dispersion, spectra, the force on a long barge."""

import numpy as np

from case import Case, Curve, Plot, Result, compare, compare_all
from cases.motion import crossings
from closed_forms import jonswap_bands, jonswap_moment, jonswap_shape
from plimsoll import kNone, Plimsoll
from reference_values import value

kSection = "Waves"
kPeriods = (5, 8, 10, 12)


def measure_dispersion(plimsoll: Plimsoll) -> Result:
    """Period of a raft's heave from its upward crossings, ten periods apart, after five."""
    result = Result()
    for period in kPeriods:
        track = plimsoll.run_one("validation/wave_follower.yaml", f"period_{period}", {
            "duration": 17 * period, "step": 0.02,
            "water.surface.waves[0].wavelength": value(f"dispersion.{period}")})
        late = track.t > 5 * period
        times = crossings(track.t[late], track.position[late, 2])
        length = value(f"dispersion.{period}")
        result.rows.append(compare(f"period of a wave of {length:.2f} m", "s", period,
                                   (times[10] - times[0]) / 10, 1e-5, headline=period == 8,
                                   kind="step"))
    return result


def measure_barge(plimsoll: Plimsoll) -> Result:
    """Half the difference between crest and trough amidships, over rho g A a."""
    result = Result()
    amplitude = 0.01  # Small: linear theory is the reference.
    scale = 1025 * 9.81 * 100 * 20 * amplitude
    numbers = (0.1, 0.5, 1, 2, 4)
    ours = {"airy": [], "hydrostatic": []}
    for kl in numbers:
        for kinematics, of_all in ours.items():
            forces = []
            for phase in (0, 180):
                wave = {"amplitude": amplitude, "wavelength": 2 * np.pi / kl * 100,
                        "phase_deg": phase}
                body = plimsoll.probe_one(
                    "validation/barge_in_head_wave.yaml",
                    {"water.surface": {"waves": [wave], "kinematics": kinematics}})
                forces.append(body.buoyancy.force[2])
            of_all.append((forces[0] - forces[1]) / 2 / scale)
            # Panels are refined until surface and head bend by less than 0.5 % of the surface's
            # deviation on each, of which two thirds may be left in the force.
            result.rows.append(
                compare(f"kL = {kl:g}, {kinematics} pressure", "–",
                        value(f"froude_krylov.{kinematics}.{kl:g}"), of_all[-1], 3.4e-3, scale=1,
                        headline=kl == 2 and kinematics == "airy", kind="mesh"))
    axis = np.linspace(0.01, 4, 100)
    result.plots.append(Plot("Heave force of a box barge in head waves", "kL",
                             "force / (ρ g A a)", [
        Curve("without decay", axis, np.sinc(axis / 2 / np.pi), "k--"),
        Curve("Airy, draft 5 m", axis, np.sinc(axis / 2 / np.pi) * np.exp(-axis / 20), "k-"),
        Curve("ours", numbers, ours["airy"], "o"),
        Curve("ours, hydrostatic", numbers, ours["hydrostatic"], "s")]))
    return result


kWaves = 128
kPosts, kEven = 2048, 400  # Posts; how many of them stand 4 m apart, the rest anywhere.
kLine = 30e3  # Length of the line [m], on which the waves differ by a period at least.
# A post averages the sea over its width: (k w)^2/24 = 5e-11 of the shortest wave, k = 1.14 1/m.
kWidth = 3e-5
# A frequency, from sums of 40,000 terms in double precision, is rounded by 4e-13. At the far end
# that turns the shortest wave, of 0.06 m, by 2.7e-8: 1.7e-9 m, or 8.5e-10 of the significant
# height.
kFit = 1e-9
kGamma = (1, 3.3, 7)


def post_places() -> np.ndarray:
    random = np.random.default_rng(5)
    return np.concatenate([4.0 * np.arange(kEven), random.uniform(0, kLine, kPosts - kEven)])


def heights_at(plimsoll: Plimsoll, places: np.ndarray, gamma: float) -> np.ndarray:
    """Of the sea at time 0, from the volumes that thin posts displace [m]."""
    bodies = [{"name": f"s{i}", "box": {"size": [kWidth, kWidth, 20]}, "density": 500,
               "lock": "all", "collision": "none", "position": [float(x), 0, 0]}
              for i, x in enumerate(places)]
    scene = plimsoll.write_scene(f"posts_{gamma:g}", {
        "plimsoll": 1, "duration": 0, "gravity": 9.81,
        "water": {"surface": {"spectrum": {"type": "jonswap", "significant_height": 2,
                                           "peak_period": 8, "gamma": gamma, "seed": 1,
                                           "components": kWaves}}},
        "hydro": {"pressure_drag": False, "lift": False, "viscous_drag": False,
                  "added_mass": kNone}, "bodies": bodies})
    volumes = np.array([body.volume for body in plimsoll.probe(scene).values()])
    return volumes / kWidth**2 - 10


def fitted_waves(places: np.ndarray, heights: np.ndarray, numbers: np.ndarray):
    """Complex amplitudes of waves of these numbers, by least squares, and what they leave [m]."""
    phases = np.outer(places, numbers)
    waves = np.hstack([np.cos(phases), -np.sin(phases)])
    parts, *_ = np.linalg.lstsq(waves, heights, rcond=None)
    return parts[:len(numbers)] + 1j * parts[len(numbers):], heights - waves @ parts


def jonswap_rows(gamma: float, omega: np.ndarray, waves: np.ndarray, rest: np.ndarray) -> list:
    """`omega`: of the bands' waves; `waves`, `rest`: of the fit."""
    name = f"γ = {gamma:g}"
    energy = np.abs(waves)**2 / 2
    ours, exact = ([np.sum(e * omega**n) for n in (-1, 0, 1, 2)]
                   for e in (energy, np.full(kWaves, 4 / 16 / kWaves)))
    smooth = [jonswap_moment(gamma, 8, n) for n in (-1, 0, 1, 2)]
    periods = {"mean period T01": lambda m: 2 * np.pi * m[1] / m[2],
               "zero-crossing period T02": lambda m: 2 * np.pi * np.sqrt(m[1] / m[3]),
               "energy period Te": lambda m: 2 * np.pi * m[0] / m[1]}
    rows = [compare(f"significant height, {name}", "m", 2, 4 * np.sqrt(ours[1]), kFit,
                    headline=gamma == 3.3),
            compare_all(f"amplitude of each of {kWaves} waves, worst, {name}", "m",
                        np.full(kWaves, np.sqrt(2 * 4 / 16 / kWaves)), np.abs(waves), kFit,
                        scale=np.sqrt(2 * 4 / 16)),
            compare_all(f"what the waves leave of the sea, worst of {kPosts} posts, {name}", "m",
                        np.zeros(kPosts), rest, kFit, scale=2),
            *(compare(f"{period}, {name}", "s", of(exact), of(ours), kFit)
              for period, of in periods.items()),
            # m_0 and m_1 are kept by the bands; the program's frequency steps are 1/2000 of the
            # peak's, a part of 1/140 of its width, and the midpoint rule's error a 24th its square.
            compare(f"mean period T01 of the spectrum itself, {name}", "s",
                    periods["mean period T01"](smooth), periods["mean period T01"](ours), 2e-6,
                    kind="mesh")]
    rows += [compare(f"{period} of the spectrum itself, {name}", "s", of(smooth), of(ours), None)
             for period, of in list(periods.items())[1:]]
    drift = abs(np.mean(waves / np.abs(waves))) * np.sqrt(kWaves)
    # Of random phases it is a Rayleigh variable: above r with the probability exp(-r^2).
    return rows + [compare(f"resultant of the phases over its deviation, {name}", "–", 0, drift,
                           np.sqrt(np.log(1e4)), scale=1, kind="statistical")]


def measure_jonswap(plimsoll: Plimsoll) -> Result:
    result = Result()
    places = post_places()
    for gamma in kGamma:
        heights = heights_at(plimsoll, places, gamma)
        omega = jonswap_bands(gamma, 8, kWaves)
        waves, rest = fitted_waves(places, heights, omega**2 / 9.81)
        result.rows += jonswap_rows(gamma, omega, waves, rest)
        if gamma == 3.3:
            result.plots += [Plot("The sea along 1.6 km, γ = 3.3", "x [m]", "height [m]", [
                Curve("surface", places[:kEven], heights[:kEven])]),
                spectrum_plot(gamma, omega, waves)]
    return result


def spectrum_plot(gamma: float, omega: np.ndarray, waves: np.ndarray) -> Plot:
    """Energy of the waves over the distance of their neighbours, and the spectrum."""
    axis = np.linspace(0.4, 2, 300)
    density = jonswap_shape(axis * 8 / (2 * np.pi), gamma) * 4 / 16 / jonswap_moment(gamma, 8, 0)
    inner = slice(1, -1)
    return Plot("Energy density, γ = 3.3", "angular frequency [rad/s]", "energy density [m² s]", [
        Curve("JONSWAP", axis, density, "k-"),
        Curve("ours", omega[inner][omega[inner] < 2],
              (np.abs(waves[inner])**2 / (omega[2:] - omega[:-2]))[omega[inner] < 2], ".")])


kCases = [
    Case("dispersion", kSection, "Dispersion of deep-water waves",
         "A raft that may only heave rides regular waves of four lengths; the period of its "
         "motion is that of the wave.",
         "Airy: ω² = gk, g = 9.81 m/s². The lengths are given "
         "to 1e-5 m, the crossings found to less than 1e-5 of "
         "a period.", ["validation/wave_follower.yaml"],
         measure_dispersion),
    Case("froude_krylov", kSection, "Heave force of a long barge in head waves",
         "A box barge of 100 × 20 m, draft 5 m, of 12 triangles, on crest and trough of a small "
         "wave, by both models of the water below waves.",
         "The mean of the wave over the length: sin(kL/2)/(kL/2); with decay, times exp(−kT). The "
         "tolerance is what the refinement of panels promises, two thirds of 0.5 %.",
         ["validation/barge_in_head_wave.yaml"], measure_barge),
    Case("jonswap", kSection, "A JONSWAP sea",
         "2,048 thin posts stand along 30 km of a sea of H<sub>s</sub> = 2 m and T<sub>p</sub> = "
         "8 s, made of 128 waves of equal energy; what they displace is the height of the sea. A "
         "fit by least squares finds the amplitude and the phase of every wave. T01, T02 and Te "
         "are 2π times m<sub>0</sub>/m<sub>1</sub>, (m<sub>0</sub>/m<sub>2</sub>)<sup>½</sup> and "
         "m<sub>−1</sub>/m<sub>0</sub>. Waves of equal energy keep m<sub>0</sub> and "
         "m<sub>1</sub>; what they lack of m<sub>2</sub>, whose tail converges slowly, is shown.",
         "The mean frequencies of 128 bands of equal energy of the spectrum below 20 ω<sub>p</sub>,"
         " computed without the program, with k = ω²/g; the moments of the spectrum by quadrature.",
         ["validation/jonswap_staff.yaml"], measure_jonswap),
]
