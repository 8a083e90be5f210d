"""Buoyancy of spheres and cubes against depth (thesis, Figs 6 and 7)."""

import numpy as np

from case import Case, Curve, Plot, Result, compare, compare_all
from closed_forms import cap_volume, kGravity, uv_sphere_volume_below
from convergence import mesh_rows
from plimsoll import Plimsoll
from reference_values import value

kSection = "Buoyancy"
kWeight = 1000 * kGravity  # Of the water [N/m^3].


def forces(plimsoll: Plimsoll, scene: str, depths) -> np.ndarray:
    """Buoyancy of the scene's body of 2 m height with its lowest point at these depths [N]."""
    return np.array([
        plimsoll.probe_one(scene, {"bodies[0].position": [0, 0, 1 - depth]}).buoyancy.force[2]
        for depth in depths])


def measure_sphere(plimsoll: Plimsoll) -> Result:
    depths = np.linspace(0.125, 2.25, 18)
    smooth = np.array([kWeight * cap_volume(1, d) for d in depths])
    result = Result()
    curves = [Curve("smooth sphere, exact", depths, smooth, "k-")]
    for triangles, count, style in ((480, 16, "o"), (4900, 50, "+")):
        ours = forces(plimsoll, f"thesis_sphere_{triangles}.yaml", depths)
        exact = [kWeight * uv_sphere_volume_below(1, count, count, d - 1) for d in depths]
        result.rows += [
            compare_all(f"{triangles} triangles, at 18 depths, against the polyhedron itself", "N",
                        exact, ours, 1e-12, scale=smooth[-1], headline=triangles == 4900),
            compare(f"{triangles} triangles, part of the smooth sphere's buoyancy that is missing",
                    "–", 1 - exact[-1] / smooth[-1], 1 - ours[-1] / smooth[-1], 1e-12, scale=1,
                    thesis=value(f"thesis.buoyancy.sphere_{triangles}")),
        ]
        curves.append(Curve(f"{triangles} triangles", depths, ours, style))
    result.rows += convergence(plimsoll)
    result.plots.append(Plot("Buoyancy of spheres of radius 1 m",
                             "immersion of the lowest point [m]", "buoyancy [N]", curves))
    return result


def convergence(plimsoll: Plimsoll):
    """A sphere immersed to 1.25 m, with panels halved twice."""
    forces_of_meshes = []
    for count in (24, 48, 96):
        body = plimsoll.probe_one("thesis_sphere_480.yaml", {
            "bodies[0].position": [0, 0, -0.25], "bodies[0].sphere.slices": count,
            "bodies[0].sphere.stacks": count})
        forces_of_meshes.append(body.buoyancy.force[2])
    return mesh_rows("buoyancy of the smooth sphere, immersed to 1.25 m", "N",
                     kWeight * cap_volume(1, 1.25), forces_of_meshes, "18,240 triangles")


def measure_cube(plimsoll: Plimsoll) -> Result:
    depths = np.linspace(0.125, 2.25, 18)
    exact = kWeight * 4 * np.minimum(depths, 2)
    result = Result()
    curves = [Curve("exact", depths, exact, "k-")]
    for triangles, style in ((12, "o"), (768, "+")):
        ours = forces(plimsoll, f"thesis_cube_{triangles}.yaml", depths)
        result.rows.append(compare(
            f"{triangles} triangles, largest relative error at 18 depths", "–", 0,
            np.max(np.abs(ours - exact)) / exact[-1], 1e-14 * np.sqrt(triangles), scale=1,
            thesis=value(f"thesis.buoyancy.cube_{triangles}"), headline=triangles == 768))
        curves.append(Curve(f"{triangles} triangles", depths, ours, style))
    result.plots.append(Plot("Buoyancy of cubes of 2 m", "immersion of the lower face [m]",
                             "buoyancy [N]", curves))
    return result


kCases = [
    Case("buoyancy_sphere", kSection, "Buoyancy of a sphere against depth",
         "Thesis, Fig. 6. Spheres of 480 and 4,900 triangles are held at eighteen depths. What "
         "separates them from a smooth sphere is their shape, which is known; what remains is the "
         "error of the integration.",
         "The mesh is a stack of frusta with regular polygons for sections: its volume below any "
         "height has a closed form. The smooth sphere's is πd²(3R − d)/3.",
         ["thesis_sphere_480.yaml", "thesis_sphere_4900.yaml"], measure_sphere),
    Case("buoyancy_cube", kSection, "Buoyancy of a cube against depth",
         "Thesis, Fig. 7. A cube is represented exactly by 12 triangles or by 768, so only "
         "round-off may remain.",
         "ρg a²d. The tolerance is forty-five roundings of each triangle's force, added like "
         "random errors.",
         ["thesis_cube_12.yaml", "thesis_cube_768.yaml"], measure_cube),
]
