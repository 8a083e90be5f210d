"""Added mass in unbounded fluid and at the surface, and the moment it causes."""

from __future__ import annotations

import numpy as np

import meshes
from case import Case, Result, Row, compare
from closed_forms import kLambAxes, lamb_coefficients, lamb_rotation, munk_moment
from convergence import step_rows
from plimsoll import Plimsoll
from reference_values import value

kSection = "Added mass"
kDensity = 1000.0  # Of the water [kg/m^3]: the program's own.
kPolyhedra = 2e-3  # What is asked of bodies that are polyhedra.
kRound = 3e-3  # Of a cylinder and a torus: facets and edges both.
kUvSphere = 2e-3
kSmooth = 2e-4  # Of a sphere of nearly equal triangles.
kEllipsoid = 1e-3  # The polyhedron departs from its ellipsoid by 1e-4.
kAtSurface = 1e-2
kFrequency = 8  # Edges of the icosahedron are cut into so many parts: 1,280 triangles.
kTriangles = "1,280 triangles"
kBodies = "validation/pushed_bodies.yaml"
kMethods = (("", ()), ("the thesis's method", ("--method", "constant")))


def goal_rows(found: dict, quantity: str, unit: str, reference: float, entry: int, goal: float, *,
              scale: float = 1.0, headline: bool = False,
              thesis: float | None = None) -> list[Row]:
    """Ours, judged by the goal, and the thesis's method on the same mesh, shown. `scale` brings
    the matrix's diagonal `entry` to the reference's shape and unit."""
    rows = []
    for method, body in found.items():
        ours = scale * body["added_mass"][entry][entry]
        judged = {"kind": "goal", "headline": headline, "thesis": thesis} if not method else {}
        rows.append(compare(f"{quantity}, {method}" if method else quantity, unit, reference, ours,
                            None if method else goal, **judged))
    return rows


def solved(plimsoll: Plimsoll, name: str, mesh: meshes.Mesh) -> dict[str, dict]:
    """By the default and by the thesis's method, of one mesh."""
    path = plimsoll.work / f"{name}.obj"
    meshes.write_obj(path, mesh)
    return {method: plimsoll.added_mass(path, *options) for method, options in kMethods}


def primitive(plimsoll: Plimsoll, name: str, shape: dict) -> dict[str, dict]:
    """The same of a primitive of the scene language."""
    scene = plimsoll.write_scene(name, {
        "plimsoll": 1, "duration": 1, "water": {"density": kDensity},
        "bodies": [{"name": name, "density": kDensity, "position": [0, 0, -10], **shape}]})
    return {method: plimsoll.added_mass(scene, *options) for method, options in kMethods}


def measure_polyhedra(plimsoll: Plimsoll) -> Result:
    result = Result()
    box = {"box": {"size": [2, 2, 2]}}
    cube = primitive(plimsoll, "cube", box)
    result.rows += goal_rows(cube, "surge, cube of 12 triangles", "kg",
                             value("added_mass.cube"), 0, kPolyhedra, headline=True,
                             thesis=value("thesis.added_mass.cube_12"))
    result.rows += goal_rows(cube, "roll, cube of 12 triangles", "kg m²",
                             value("added_mass.cube.roll"), 3, kPolyhedra)
    box["box"]["divisions"] = 8
    fine = primitive(plimsoll, "cube_768", box)["the thesis's method"]
    result.rows += [
        compare("surge, cube of 768 triangles, the thesis's method", "kg",
                value("added_mass.cube"), fine["added_mass"][0][0], None,
                thesis=value("thesis.added_mass.cube_768")),
        compare("surge, cube: what the thesis took for the exact value", "kg",
                value("added_mass.cube"), value("thesis.added_mass.cube_exact"), None)]
    for name in ("tetrahedron", "octahedron", "dodecahedron", "icosahedron"):
        mesh = getattr(meshes, name)()
        result.rows += goal_rows(solved(plimsoll, name, mesh), f"any direction over ρV, {name}",
                                 "–", value(f"added_mass.{name}"), 0, kPolyhedra,
                                 scale=1 / (kDensity * meshes.volume(mesh)),
                                 headline=name == "tetrahedron")
    return result


def sphere_rows(plimsoll: Plimsoll) -> list[Row]:
    ico = primitive(plimsoll, "icosphere", {"icosphere": {"radius": 1, "subdivisions": 3}})
    uv = primitive(plimsoll, "uv_sphere", {"sphere": {"radius": 1, "slices": 50, "stacks": 50}})
    half = lambda found: 0.5 * kDensity * found[""]["volume"]
    rows = goal_rows(ico, f"surge, sphere of {kTriangles} alike, of the mesh's volume", "kg",
                     half(ico), 0, kSmooth, headline=True)
    for entry, motion in ((0, "surge"), (2, "heave")):
        rows += goal_rows(uv, f"{motion}, sphere of 4,900 triangles, of the mesh's volume", "kg",
                          half(uv), entry, kUvSphere)
    return rows + [
        compare(f"{motion}, sphere of 4,900 triangles, against the smooth sphere", "kg",
                kDensity * 2 / 3 * np.pi, uv[""]["added_mass"][entry][entry], None,
                thesis=value(f"thesis.added_mass.sphere_4900.{entry}"))
        for entry, motion in ((0, "surge"), (1, "sway"), (2, "heave"))]


def cylinder_rows(plimsoll: Plimsoll) -> list[Row]:
    """Of radius 1 and height 2 m; what a prism of 64 sides lacks of its volume is made up for."""
    found = primitive(plimsoll, "cylinder",
                      {"cylinder": {"radius": 1, "height": 2, "slices": 64, "stacks": 8}})
    fuller = 2 * np.pi / found[""]["volume"]
    rows = []
    for entry, motion in ((0, "across"), (2, "along"), (3, "pitch")):
        rows += goal_rows(found, f"{motion}, cylinder L/D = 1 of 1,920 triangles",
                          "kg m²" if entry == 3 else "kg",
                          kDensity * value(f"added_mass.cylinder.{motion}"), entry, kRound,
                          scale=fuller)
    return rows


def torus_rows(plimsoll: Plimsoll) -> list[Row]:
    found = solved(plimsoll, "torus", meshes.torus_of_volume(1, 0.3, around=56, across=18))
    rows = []
    for entry, motion in ((0, "across"), (2, "along"), (3, "pitch")):
        rows += goal_rows(found, f"{motion} the axis, torus of 2,016 triangles"
                          if entry < 3 else "pitch, torus of 2,016 triangles",
                          "kg m²" if entry == 3 else "kg",
                          kDensity * value(f"added_mass.torus.{motion}"), entry, kRound)
    return rows


def ellipsoid_rows(plimsoll: Plimsoll, axes: tuple[float, float, float]) -> list[Row]:
    """Against Lamb's integrals, the mesh enlarged to the ellipsoid's volume V: turns grow by its
    fifth power of length where surge grows by the third."""
    mesh = meshes.ellipsoid(axes, kFrequency)
    name = ":".join(map(str, axes))
    found = solved(plimsoll, "ellipsoid_" + name.replace(":", "_"), mesh)
    exact = 4 / 3 * np.pi * np.prod(axes)
    grown = exact / meshes.volume(mesh)
    rows = []
    for entry, motion in ((0, "surge"), (1, "sway"), (2, "heave")):
        rows += goal_rows(found, f"{motion} over ρV, ellipsoid {name} of {kTriangles}", "–",
                          lamb_coefficients(axes)[entry], entry, kEllipsoid,
                          scale=grown / (kDensity * exact),
                          headline=axes == (3, 2, 1) and entry == 2)
    for axis, motion in enumerate(("roll", "pitch", "yaw")):
        if exact_rotation := lamb_rotation(axes)[axis]:
            rows += goal_rows(found, f"{motion} over ρV, ellipsoid {name} of {kTriangles}", "m²",
                              exact_rotation, 3 + axis, kEllipsoid,
                              scale=grown**(5 / 3) / (kDensity * exact))
    return rows


def measure_round(plimsoll: Plimsoll) -> Result:
    return Result([*sphere_rows(plimsoll), *cylinder_rows(plimsoll), *torus_rows(plimsoll),
                   *(row for axes in kLambAxes for row in ellipsoid_rows(plimsoll, axes))])


kHalfSphere = "validation/half_submerged_sphere.yaml"
# By symmetry half of `deep` is exact but for the faces across the waterline, on which ψ is taken
# as linear. No farther than an edge from it, e = 0.16 m at most, they hold the part e³ of the
# heave, 3/2 the integral of z² over |z| < e being that.
kWaterline = 0.16**3


def measure_surface(plimsoll: Plimsoll) -> Result:
    surface = plimsoll.probe_one(kHalfSphere)
    half = plimsoll.probe_one(kHalfSphere, {"hydro.added_mass": "deep"})
    whole = plimsoll.probe_one(kHalfSphere, {"hydro.added_mass": "deep",
                                             "bodies[0].position": [0, 0, -3]})
    displaced = kDensity * surface.volume
    over = lambda entry: surface.added_mass[entry, entry] / displaced
    return Result([
        compare("heave over the displaced mass, `surface`", "–", 0.5, over(2), kAtSurface,
                kind="goal", headline=True),
        compare("surge over the displaced mass, `surface`", "–", value("added_mass.half_sphere"),
                over(0), kAtSurface, kind="goal"),
        compare("sway over the displaced mass, `surface`", "–", value("added_mass.half_sphere"),
                over(1), kAtSurface, kind="goal"),
        compare("heave, `deep`, of the wholly submerged sphere's", "–", 0.5,
                half.added_mass[2, 2] / whole.added_mass[2, 2], kWaterline, kind="mesh")])


kMunk = "validation/munk_moment.yaml"
kSpheroid = (2, 1, 1)
# Lamb's matrix and the inertia stand in the scene with seven digits.
kDigits = 1e-6
kMunkSteps = (0.04, 0.02, 0.01)


def turning_moment(plimsoll: Plimsoll, step: float) -> float:
    """The moment that gives a body at rest the rate it has after one step [N m]."""
    track = plimsoll.run_one(kMunk, f"step_{step:g}", {"step": step, "duration": step})
    volume = 4 / 3 * np.pi * np.prod(kSpheroid)
    inertia = kDensity * volume * (1 + lamb_rotation(kSpheroid)[2])  # (a² + b²)/5 = 1 m².
    return -inertia * track.angular_velocity[-1, 2] / step


def measure_munk(plimsoll: Plimsoll) -> Result:
    """Errors of A_11 and A_22 of the goal each move their difference by no more than the goal of
    their sum."""
    exact = munk_moment(lamb_coefficients(kSpheroid), kSpheroid, kDensity)
    first, second, _ = lamb_coefficients(kSpheroid)
    tolerance = kEllipsoid * (first + second) / (second - first)
    mesh = meshes.ellipsoid(kSpheroid, kFrequency)
    grown = 4 / 3 * np.pi * np.prod(kSpheroid) / meshes.volume(mesh)
    rows = []
    for method, body in solved(plimsoll, "spheroid", mesh).items():
        matrix = np.array(body["added_mass"])
        ours = 0.5 * grown * (matrix[1, 1] - matrix[0, 0])  # V² sin 2α = 1 m²/s².
        judged = {} if method else {"kind": "goal", "headline": True}
        rows.append(compare(f"½(A₂₂ − A₁₁)V² sin 2α, {method or f'A of {kTriangles}'}", "N m",
                            exact, ours, None if method else tolerance, **judged))
    moments = [turning_moment(plimsoll, step) for step in kMunkSteps]
    return Result([*step_rows("moment on the moving body, Lamb's A", "N m", exact, moments,
                              kDigits), *rows])


kCases = [
    Case("added_mass_polyhedra", kSection, "Added mass of polyhedra from their own faces",
         "A 2 m cube of 12 triangles, whose exact shape the mesh is, and the regular solids, "
         "`plimsoll addedmass` at its default tolerance; beside it a constant potential on each "
         "triangle, collocated at its centroid, which is the thesis's method. The thesis's Table 4 "
         "calls 5600 kg the cube's analytical value; it is 10 % too large, and its result for "
         "768 triangles, 5207 kg, is 2 % above the truth and not 7 % below.",
         "Numbers of five digits, which but for the roll of the cube the program's own tests hold "
         "it against too: cube 0.63841 ρV and 1256.4 kg m², tetrahedron 0.80708, octahedron "
         "0.58720, dodecahedron 0.54235, icosahedron 0.52368 of ρV. They are not computed here.",
         [kBodies], measure_polyhedra),
    Case("added_mass_round", kSection, "Added mass of round bodies",
         "Spheres, a cylinder, a torus and ellipsoids from meshes as users give them, beside the "
         "thesis's method on the same meshes. Spheres are compared with half of their own "
         "displaced mass; the other meshes are scaled to the smooth body's volume.",
         "Sphere: half the displaced mass. Ellipsoids: Lamb's integrals, Hydrodynamics §114 and "
         "§115, by quadrature. Cylinder of length 2R: 3.63982 ρR³ across, 3.67796 along, "
         "0.80990 ρR⁵ in pitch; torus of radii 1 and 0.3: 0.79117, 1.83834 and 0.77990 ρ. "
         "These are not computed here.",
         [kBodies], measure_round),
    Case("added_mass_surface", kSection, "Added mass of a half-submerged sphere",
         f"A sphere of {kTriangles}, its centre in the water's surface, by `plimsoll probe`: with "
         "`model: surface` as a scene has it, interpolated between solved attitudes and draughts, "
         "and with `deep`, the wetted half's share of the body in unbounded fluid.",
         "Potential 0 on the surface, high frequency: heave is that of the whole sphere, 1/2 of "
         "the displaced mass; surge 0.2732. `deep`: by symmetry half of the whole.",
         [kHalfSphere], measure_surface),
    Case("munk_moment", kSection, "Munk's moment on a spheroid",
         "A spheroid with semi-axes 2, 1 and 1 m at 1 m/s, 45° off its long axis: the moment that "
         "turns it broadside, from the turning rate of a body let go with Lamb's matrix, and from "
         "the matrix that the program finds for its mesh.",
         "½(A₂₂ − A₁₁)V² sin 2α with Lamb's coefficients 0.210015 and 0.704210: 2070.08 N m.",
         [kMunk], measure_munk),
]
