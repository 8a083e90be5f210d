"""Hydrostatics of floating bodies: righting arms, metacentric heights."""

import numpy as np

from case import Case, Result, compare, compare_all
from closed_forms import box_gz
from convergence import mesh_rows
from plimsoll import Body, Plimsoll
from wigley import write_wigley

kSection = "Hydrostatics"
# For derivatives [rad]. The sides of a mesh of Wigley's hull have a kink at the waterline, so that
# the error left is of the first order in the tilt: 1e-8 of BM. Rounding leaves 1e-9.
kTilt = 1e-6


def measure_box(plimsoll: Plimsoll) -> Result:
    """The box of the scene: breadth 4 m, draft 1.2 m, its centre 0.3 m above the water. As it
    heels, the middle of its waterline stays on the water. `hydrostatics` finds the draft of each heel by
    iteration, hence its wider tolerance."""
    angles = np.radians([1, 5, 10, 15, 20, 25, 30])
    arms, volumes = [], []
    for angle in angles:
        body = plimsoll.probe_one("validation/box_heeled.yaml", {
            "bodies[0].orientation.angle_deg": float(np.degrees(angle)),
            "bodies[0].position": [0, -0.3 * np.sin(angle), 0.3 * np.cos(angle)]})
        arms.append(-body.buoyancy.torque[0] / body.buoyancy.force[2])
        volumes.append(body.volume)
    exact = [box_gz(4, 1.2, 1.3, angle) for angle in angles]
    floating = plimsoll.hydrostatics("validation/box_heeled.yaml", heels="5:30:5")
    found = [entry["gz"] for entry in floating["gz"]]
    return Result([
        compare_all("righting arm GZ at seven angles to 30°, worst", "m", exact, arms, 1e-13,
                    scale=max(exact), headline=True),
        compare_all("displaced volume, worst", "m³", [48.0] * 7, volumes, 1e-13, scale=48),
        compare_all("the same by plimsoll hydrostatics, six angles, worst", "m", exact[1:], found,
                    1e-9, scale=max(exact)),
        compare("GM upright by plimsoll hydrostatics", "m", 0.6 + 16 / 14.4 - 1.3,
                floating["rest"]["gm_t"], 1e-9)])


def metacentric_height(plimsoll: Plimsoll, scene: str, axis: int, overrides: dict) -> float:
    """GM about x (0) or y (1), from the torque at a small tilt about the origin [m]."""
    moments = []
    for tilt in (kTilt, -kTilt):
        turn = {"bodies[0].orientation.axis": [1 - axis, axis, 0],
                "bodies[0].orientation.angle_deg": float(np.degrees(tilt))}
        body = plimsoll.probe_one(scene, {**overrides, **turn})
        moments.append(-body.buoyancy.torque[axis] / body.buoyancy.force[2])
    return (moments[0] - moments[1]) / (2 * np.sin(kTilt))


def wigley_values(plimsoll: Plimsoll, stations: int) -> list[float]:
    """V, BM_T and BM_L of Wigley's hull on a mesh of this fineness."""
    scene = "validation/wigley_heeled.yaml"
    plimsoll.work.mkdir(parents=True, exist_ok=True)
    mesh = plimsoll.work / f"wigley_{stations}.obj"
    write_wigley(mesh, stations=stations, rows=stations // 2)
    overrides = {"bodies[0].mesh.file": str(mesh)}
    upright: Body = plimsoll.probe_one(scene, {**overrides, "bodies[0].orientation.angle_deg": 0})
    # The centre of mass stands in the exact centre of buoyancy, so GM is BM.
    return [upright.volume, metacentric_height(plimsoll, scene, 0, overrides),
            metacentric_height(plimsoll, scene, 1, overrides)]


def measure_wigley(plimsoll: Plimsoll) -> Result:
    values = np.array([wigley_values(plimsoll, n) for n in (32, 64, 128)])
    length, breadth, draft = 10, 1, 0.625
    exact = [4 / 9 * length * breadth * draft, 3 * breadth**2 / (35 * draft),
             3 * length**2 / (40 * draft)]
    result = Result()
    names = (("displaced volume", "m³"), ("BM transverse", "m"), ("BM longitudinal", "m"))
    for (name, unit), reference, ours in zip(names, exact, values.T):
        result.rows += mesh_rows(name, unit, reference, ours, "128 × 64 panels a side",
                                 headline=True)
    return result


def measure_ellipsoid(plimsoll: Plimsoll) -> Result:
    heights, volumes, at_rest = [], [], []
    for count in (24, 48, 96):
        mesh = {"bodies[0].ellipsoid.slices": count, "bodies[0].ellipsoid.stacks": count}
        scene = "validation/ellipsoid_buoy.yaml"
        heights.append(metacentric_height(plimsoll, scene, 0, mesh))
        upright = plimsoll.probe_one(scene, {**mesh, "bodies[0].orientation.angle_deg": 0})
        volumes.append(upright.volume)
        at_rest.append(plimsoll.hydrostatics(scene, mesh)["rest"]["gm_t"])
    volume = 2 / 3 * np.pi * 5 * 5 * 2.5
    height = np.pi * 5**4 / 4 / volume - 3 / 8 * 2.5 + 2
    finest = "18,240 triangles"
    return Result([
        *mesh_rows("GM", "m", height, heights, finest, headline=True),
        *mesh_rows("GM by plimsoll hydrostatics", "m", height, at_rest, finest),
        *mesh_rows("displaced volume", "m³", volume, volumes, finest)])


kCases = [
    Case("box_gz", kSection, "Righting arm of a box",
         "A box of 10 × 4 × 3 m with a draft of 1.2 m and its centre of mass 0.2 m below its "
         "centre, heeled by up to 30°, of 12 triangles. GZ is the torque of the buoyancy about "
         "the centre of mass, over the buoyancy.",
         "Wall-sided formula: GZ = sinφ(GM + ½BM tan²φ), exact for a box until an edge of deck or "
         "bilge meets the water (31° here).",
         ["validation/box_heeled.yaml"], measure_box),
    Case("wigley", kSection, "Wigley's hull",
         "y = (B/2)(1 − (2x/L)²)(1 − (z/T)²) with L = 10, B = 1 and T = 0.625 m, on three meshes. "
         "The centre of mass stands in the exact centre of buoyancy, so that the measured GM is "
         "BM.",
         "Integrals of the polynomial: V = (4/9)LBT, BM<sub>T</sub> = 3B²/(35T), BM<sub>L</sub> = "
         "3L²/(40T), and the centre of buoyancy (3/8)T below the water.",
         ["validation/wigley_heeled.yaml"], measure_wigley),
    Case("ellipsoid_buoy", kSection, "Half-ellipsoid buoy",
         "A buoy of 134,172 kg whose immersed half is that of an ellipsoid with semi-axes 5, 5 "
         "and 2.5 m, its centre of mass 2 m below the water.",
         "V = (2/3)πabc, BM = πa⁴/(4V) = "
         "3.75 m, KB = (5/8)c, so GM = "
         "3.75 − 0.9375 + 2 = 4.8125 m.", ["validation/ellipsoid_buoy.yaml"], measure_ellipsoid),
]
