"""Drag of 34 blunt and slender bodies against the tables: what the panel method's model is worth."""

import numpy as np

from case import Case, Curve, Plot, Result, Row, compare, compare_all
from drag_bodies import DragBody, kBodies, kDefault, kThesis, Law
from meshes import write_obj
from plimsoll import Body, kNone, Plimsoll

kScene = "validation/bluff_bodies.yaml"
kSteadyScene = "validation/steady_speed.yaml"
kSpeeds = (0.5, 2.0, 8.0)  # [m/s]
kMoreSpeeds = (0.001, 0.01, 0.03, 0.1, 0.25, 1.0, 1.5, 4.0, 30.0)  # For one steady speed.
kLaws = {"fitted": kDefault, "thesis": kThesis}
kRoundOff = 1e-12
kAtRest = 1e-9  # What a minute leaves of the difference from the last speed.
kPull = 500.0  # In the scene [N].
kMedianGoal = 0.15
kSlenderGoal = 1.3


def write_bodies(plimsoll: Plimsoll):
    """The scene of all bodies, side by side."""
    plimsoll.work.mkdir(parents=True, exist_ok=True)
    for body in kBodies:
        write_obj(plimsoll.work / f"{body.name}.obj", body.mesh)
    return plimsoll.write_scene("tabulated_drag", {
        "plimsoll": 1, "duration": 0, "water": {"density": 1000},
        "hydro": {"lift": False, "added_mass": kNone},
        "bodies": [{"name": body.name, "mesh": {"file": f"{body.name}.obj"}, "density": 1000,
                    "position": [0, 50 * i, -50]} for i, body in enumerate(kBodies)]})


def drag_of(body: Body) -> float:
    """Of a body that moves along x [N]."""
    return -float(body.pressure_drag.force[0] + body.viscous_drag.force[0])


def forces(plimsoll: Plimsoll, scene, preset: str, speed: float) -> np.ndarray:
    """Drag of every body as it is run [N]."""
    probed = plimsoll.probe(scene, {"hydro.preset": preset, **{
        f"bodies[{body.name}].linear_velocity": [speed, 0, 0] for body in kBodies}})
    return np.array([drag_of(probed[body.name]) for body in kBodies])


def coefficients(forces_at: dict[float, np.ndarray]) -> np.ndarray:
    """C_d, a row a body and a column a speed of kSpeeds."""
    areas = np.array([body.reference_area for body in kBodies])
    return np.stack([forces_at[v] / (500 * areas * v**2) for v in kSpeeds], axis=1)


def references() -> np.ndarray:
    return np.array([[body.reference(v, 1) for v in kSpeeds] for body in kBodies])


def slender_factor(ratios: np.ndarray) -> float:
    slender = np.array([body.slender for body in kBodies])
    return float(np.exp(np.max(np.abs(np.log(ratios[slender])))))


def falls(forces_at: dict[float, np.ndarray]) -> int:
    """Bodies whose drag falls somewhere as they become faster: some force has several steady
    speeds."""
    table = np.stack([forces_at[v] for v in sorted(forces_at)])
    return int(np.count_nonzero(np.any(np.diff(table, axis=0) <= 0, axis=0)))


def model_rows(forces_at: dict[str, dict[float, np.ndarray]]) -> list[Row]:
    """The model against the tables: the default is held to its aims, the thesis is shown."""
    rows = []
    for preset in kLaws:
        ratios = coefficients(forces_at[preset]) / references()
        judged = preset == "fitted"
        options = {"headline": True, "kind": "goal"}
        rows += [
            compare(f"median error of C_d against the tables, {preset}", "–", 0,
                    float(np.median(np.abs(ratios - 1))), kMedianGoal if judged else None, scale=1,
                    **options),
            compare(f"largest factor between C_d and the table, slender bodies, {preset}", "–", 1,
                    slender_factor(ratios), kSlenderGoal - 1 if judged else None, scale=1,
                    **options),
            compare(f"bodies that have several steady speeds under one force, {preset}", "–", 0,
                    falls(forces_at[preset]), kRoundOff if judged else None, scale=1,
                    headline=True)]
    return rows


def rows_of_body(i: int, body: DragBody, ours: dict[str, np.ndarray]) -> list[Row]:
    """Judged: the law summed over the panels here, at the worst of the speeds. Shown: the table."""
    rows = [compare_all(f"C_d over that of the law, {body.title}, {preset}", "–", np.ones(3),
                        ours[preset][i] / [body.drag(law, v) for v in kSpeeds], kRoundOff, scale=1)
            for preset, law in kLaws.items()]
    return rows + [compare(f"C_d against the table at {v:g} m/s, {body.title}, {preset}", "–",
                           body.reference(v, 1), ours[preset][i][j], None)
                   for preset in kLaws for j, v in enumerate(kSpeeds)]


def steady_rows(plimsoll: Plimsoll) -> list[Row]:
    """Two ellipsoids 8:1 under one force, one slow and one fast at first."""
    rows = []
    for preset in kLaws:
        tracks, _ = plimsoll.run(kSteadyScene, f"steady_{preset}", {"hydro.preset": preset})
        last = {name: track.velocity[-1, 0] for name, track in tracks.items()}
        probed = plimsoll.probe(kSteadyScene, {"hydro.preset": preset, **{
            f"bodies[{name}].linear_velocity": [speed, 0, 0] for name, speed in last.items()}})
        rows.append(compare(f"last speed of an ellipsoid 8:1 that was fast at first, against "
                            f"one that was slow, {preset}", "m/s", last["slow"], last["fast"],
                            kAtRest if preset == "fitted" else None,
                            headline=preset == "fitted"))
        rows += [compare(f"drag at the last speed against the pull, {name} at first, {preset}",
                         "N", kPull, drag_of(body), kAtRest) for name, body in probed.items()]
    return rows


def figure(ours: dict[str, np.ndarray]) -> Plot:
    """At 2 m/s, the first body on top."""
    titles = [body.title for body in kBodies][::-1]
    curves = [Curve("tabulated", references()[::-1, 1], titles, "k|")]
    curves += [Curve(preset, ours[preset][::-1, 1], titles, style)
               for preset, style in zip(kLaws, ("o", "x"))]
    return Plot("Drag coefficients of bodies of 1 m at 2 m/s", "C_d", "", curves, log_x=True)


def measure(plimsoll: Plimsoll) -> Result:
    scene = write_bodies(plimsoll)
    forces_at = {preset: {v: forces(plimsoll, scene, preset, v) for v in kSpeeds + kMoreSpeeds}
                 for preset in kLaws}
    ours = {preset: coefficients(forces_at[preset]) for preset in kLaws}
    rows = model_rows(forces_at) + steady_rows(plimsoll)
    rows += [row for i, body in enumerate(kBodies) for row in rows_of_body(i, body, ours)]
    return Result(rows, [figure(ours)])


kCases = [
    Case("tabulated_drag", "Drag and lift", "Drag of 34 bodies against the tables",
         "Wholly submerged bodies of 1 m diameter at 0.5, 2 and 8 m/s, as they are run, with the "
         "default coefficients and with those of the thesis: C_d = F / (½ρAv²), A the frontal "
         "area. Against the tables the error is one of the model: drag by panels knows no wake. "
         "Slender are those of L/D ≥ 4 along their motion, streamlined bodies, the cone of 10° "
         "and the plate edge-on.",
         "The law of drag summed over the panels here. Tabulated: blunt bodies by Hoerner, "
         "<i>Fluid-Dynamic Drag</i>, 1965, ch. 3, and White, <i>Fluid Mechanics</i>, table 7.3, "
         "below the drag crisis; bodies of revolution by Hoerner's formula of ch. 6, the plate by "
         "Prandtl and Schlichting, at their Reynolds numbers. Drag that grows with speed from "
         "0.001 to 30 m/s has one steady speed under each force.",
         [kScene, kSteadyScene], measure),
]
