"""Drag of hulls that drift across their length, against that of their sections."""

from case import Case, Result, compare
from plimsoll import Plimsoll
from reference_values import value

kScene = "validation/drifting_hulls.yaml"
kGoal = 0.20
kLength = 20  # [m]


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    hulls = {"barge": "barge, twice as broad as its double body is high, sharp bilges",
             "drum": "half a drum"}
    bodies = plimsoll.probe(kScene)
    for name, title in hulls.items():
        body = bodies[name]
        drag = -(body.pressure_drag.force[1] + body.viscous_drag.force[1])
        result.rows.append(compare(f"C_d across, {title}", "–", value(f"drift.{name}"),
                                   drag / (500 * kLength * 1), kGoal, kind="goal", headline=True))
    return result


kCases = [
    Case("drift", "Drag and lift", "Hulls that drift across",
         "Two hulls, ten times as long as their double bodies are high, drift across their length "
         "with a formed wake. C_d refers to length times draught. Forces on flat water are exact: "
         "what remains is the error of the model.",
         "The surface mirrors the hull: its sections are those of the double body in plane flow, "
         "less what ends take (DNV-RP-C205, appendix E; White, table 7.3).", [kScene], measure)]
