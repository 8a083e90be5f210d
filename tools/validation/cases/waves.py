"""Waves as bodies meet them: dispersion, spectra, the force on a long barge."""

import numpy as np

from case import Case, Curve, Plot, Result, compare
from cases.motion import crossings
from plimsoll import Plimsoll
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
                                   (times[10] - times[0]) / 10, 1e-5, headline=period == 8))
    return result


def measure_barge(plimsoll: Plimsoll) -> Result:
    """Half the difference between crest and trough amidships, over rho g A a."""
    result = Result()
    scale = 1025 * 9.81 * 100 * 20 * 0.5
    numbers = (0.1, 0.5, 1, 2, 4)
    ours = []
    for kl in numbers:
        forces = []
        for phase in (0, 180):
            wave = {"amplitude": 0.5, "wavelength": 2 * np.pi / kl * 100, "phase_deg": phase}
            body = plimsoll.probe_one("validation/barge_in_head_wave.yaml",
                                      {"water.surface.waves": [wave]})
            forces.append(body.buoyancy.force[2])
        ours.append((forces[0] - forces[1]) / 2 / scale)
        # Panels are refined until the surface bends by less than 0.5 % of its deviation on each,
        # of which two thirds may be left in the force.
        result.rows += [
            compare(f"kL = {kl:g}, hydrostatic pressure below the surface", "–",
                    value(f"froude_krylov.hydrostatic.{kl:g}"), ours[-1], 3.4e-3, scale=1,
                    headline=kl == 2),
            compare(f"kL = {kl:g}, with the decay that real waves have", "–",
                    value(f"froude_krylov.airy.{kl:g}"), ours[-1], None, scale=1)]
    axis = np.linspace(0.01, 4, 100)
    result.plots.append(Plot("Heave force of a box barge in head waves", "kL",
                             "force / (ρ g A a)", [
        Curve("without decay", axis, np.sinc(axis / 2 / np.pi), "k-"),
        Curve("Airy, draft 5 m", axis, np.sinc(axis / 2 / np.pi) * np.exp(-axis / 20), "k--"),
        Curve("ours", numbers, ours, "o")]))
    return result


kStaffs, kSpacing = 4096, 4.0  # m; waves down to 8 m are resolved, the sea's shortest are longer.


def staffs(plimsoll: Plimsoll, gamma: float) -> np.ndarray:
    """Heights of the sea along a line at time 0, from the volumes that thin posts displace [m]."""
    bodies = [{"name": f"s{i}", "box": {"size": [0.1, 0.1, 20]}, "density": 500, "lock": "all",
               "collision": "none", "position": [kSpacing * i, 0, 0]} for i in range(kStaffs)]
    scene = plimsoll.write_scene(f"staffs_{gamma:g}", {
        "plimsoll": 1, "duration": 0, "gravity": 9.81,
        "water": {"surface": {"spectrum": {"type": "jonswap", "significant_height": 2,
                                           "peak_period": 8, "gamma": gamma, "seed": 1,
                                           "components": 16}}},
        "hydro": {"pressure_drag": False, "lift": False, "viscous_drag": False}, "bodies": bodies})
    volumes = np.array([body.volume for body in plimsoll.probe(scene).values()])
    return volumes / 0.01 - 10


def spectrum_of(heights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Angular frequencies of deep water, and the variance at each, through a Hann window."""
    window = np.hanning(len(heights))
    lines = np.abs(np.fft.rfft(heights * window))**2 * 2 / (len(heights) * np.sum(window**2))
    numbers = 2 * np.pi * np.fft.rfftfreq(len(heights), kSpacing)
    return np.sqrt(9.81 * numbers), lines


def measure_jonswap(plimsoll: Plimsoll) -> Result:
    result = Result()
    curves = []
    for gamma in (1, 3.3, 7):
        heights = staffs(plimsoll, gamma)
        omega, variance = spectrum_of(heights)
        mean_period = 2 * np.pi * variance.sum() / np.sum(omega * variance)
        result.rows += [
            compare(f"significant height, γ = {gamma:g}", "m", 2, 4 * np.std(heights), 0.02,
                    headline=gamma == 3.3),
            compare(f"mean period T01, γ = {gamma:g}", "s", 8 * value(f"jonswap.t01.{gamma:g}"),
                    mean_period, 0.02)]
        shown = slice(0, 400)
        if gamma == 3.3:
            curves.append(Curve("surface", kSpacing * np.arange(400), heights[shown]))
    result.plots.append(Plot("The sea along 1.6 km, γ = 3.3", "x [m]", "height [m]", curves))
    return result


kCases = [
    Case("dispersion", kSection, "Dispersion of deep-water waves",
         "A raft that may only heave rides regular waves of four lengths; the period of its "
         "motion is that of the wave.",
         "Airy: ω² = gk, g = 9.81 m/s². The lengths are given "
         "to 1e-5 m, the crossings found to less than 1e-5 of "
         "a period.", ["validation/wave_follower.yaml"],
         measure_dispersion),
    Case("froude_krylov", kSection, "Heave force of a long barge in head waves",
         "A box barge of 100 × 20 m, draft 5 m, of 12 triangles, on crest and trough. Plimsoll "
         "takes the pressure as hydrostatic below the local surface; the rows without a tolerance "
         "show how far that is from waves whose pressure decays with depth.",
         "The mean of the wave over the length: sin(kL/2)/(kL/2); with decay, times exp(−kT). The "
         "tolerance is what the refinement of panels promises, two thirds of 0.5 %.",
         ["validation/barge_in_head_wave.yaml"], measure_barge),
    Case("jonswap", kSection, "A JONSWAP sea",
         "4,096 thin posts stand in a row, 4 m apart, in a sea of H<sub>s</sub> = 2 m and "
         "T<sub>p</sub> = 8 s of 16 waves of equal energy, which keep m<sub>0</sub> and "
         "m<sub>1</sub>; what they displace is the height of the sea, a snapshot over 16 km.",
         "H<sub>s</sub> is four standard "
         "deviations; T01 = "
         "2πm<sub>0</sub>/m<sub>1</sub> by "
         "quadrature of the spectrum, "
         "measured from the snapshot's "
         "spectrum over k with ω² = gk. A "
         "finite line of sea is a sample: 2 "
         "%.", ["validation/jonswap_staff.yaml"], measure_jonswap),
]
