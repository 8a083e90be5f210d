"""Measures what each mechanism of the engine is for: see tools/ablate."""

from __future__ import annotations

import argparse
import csv
import sys
import time
from pathlib import Path

kRoot = Path(__file__).resolve().parents[2]
sys.path.append(str(kRoot / "tools" / "validation"))

import constants  # noqa: E402
from laboratory import (Laboratory, Scene, SceneResult, StressResult,  # noqa: E402
                        Variant, kUnchanged)

kHere = Path(__file__).resolve().parent
kSmallest = 1e-7  # Change of an error that is not shown [m].
kShown = 0.01  # Change of an error, over it, that is not shown.


class Mechanism:
    """A mechanism and what switches it off."""

    def __init__(self, row: dict[str, str]):
        self.name = row["name"]
        self.meaning = row["what it does"]
        self.values = tuple(tuple(word.split("=")) for word in row["constants"].split())

    def variant(self) -> Variant:
        return Variant(self.name, self.values)


def read_mechanisms() -> dict[str, Mechanism]:
    """@throws SystemExit for one that names a constant that the engine has not."""
    known = constants.constants_of(constants.header().read_text())
    with open(kHere / "mechanisms.csv", encoding="utf-8") as file:
        found = [Mechanism(row) for row in csv.DictReader(file)]
    for mechanism in found:
        for name, value in mechanism.values:
            if name not in known:
                raise SystemExit(f"mechanisms.csv: {mechanism.name}: the engine has no {name}")
            if known[name].type != "double" and not float(value).is_integer():
                raise SystemExit(f"mechanisms.csv: {mechanism.name}: {name} is a whole number")
    return {mechanism.name: mechanism for mechanism in found}


def read_scenes() -> dict[str, Scene]:
    with open(kHere / "scenes.csv", encoding="utf-8") as file:
        return {row["scene"]: Scene(row["scene"], float(row["seconds"]))
                for row in csv.DictReader(file)}


def chosen_variant(words: str, mechanisms: dict[str, Mechanism]) -> Variant:
    """Of `a` or, several switched off together, `a+b`."""
    names = words.split("+")
    for name in names:
        if name not in mechanisms:
            raise SystemExit(f"found {name}, expected a mechanism: {', '.join(mechanisms)}")
    return Variant(words, sum((mechanisms[name].values for name in names), ()))


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/ablate", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Switches mechanisms of the engine off, one at a time, and measures what gets "
                    "worse: in scenes the error\nagainst the unchanged engine at an eighth of the "
                    "step (the mean over the bodies of the root mean square of\ntheir places' "
                    "errors), in the stress runs inside the operating envelope the failures.")
    parser.add_argument("mechanisms", nargs="*", metavar="MECHANISM",
                        help="which [all]; a+b switches both off at once")
    parser.add_argument("--list", action="store_true", help="print the mechanisms and scenes")
    parser.add_argument("--scenes", nargs="*", metavar="SCENE", help="which scenes [all]; "
                        "without a name none")
    parser.add_argument("--stress", default="subset", metavar="none|subset|all|FILE",
                        help="which stress runs: those of tools/test --all, the whole matrix, or "
                        "those that a file names, one a line [subset]")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time [2]")
    parser.add_argument("--programs", type=Path, default=kRoot / "build/ablation",
                        help="folder of the programs [build/ablation]")
    parser.add_argument("--out", type=Path, default=kRoot / "out/ablate",
                        help="folder for runs and results [out/ablate]; runs in it are not repeated")
    return parser.parse_args()


def say(text: str, start: float = time.monotonic()) -> None:
    print(f"{time.monotonic() - start:6.0f} s  {text}", file=sys.stderr, flush=True)


def scene_words(results: dict[str, dict[str, SceneResult]], variant: str) -> str:
    """What a variant changes: the factor of the error by scene, the largest change first."""
    changes, small = [], 0
    for scene, by_variant in results.items():
        result, plain = by_variant[variant], by_variant[kUnchanged.name]
        if result.stopped:
            changes.append((float("inf"), f"{scene} stops"))
        elif not result.same:
            ratio = result.error / plain.error if plain.error > 0 else float("inf")
            if (abs(result.error - plain.error) < kSmallest or abs(ratio - 1) < kShown):
                small += 1
            else:
                changes.append((abs(ratio - 1), f"{scene} {ratio:.3g} ×"))
    words = [text for _, text in sorted(changes, reverse=True)]
    if small:
        words.append(f"{small} by less than {kShown:.0%} or {kSmallest:g} m")
    return ", ".join(words) or "–"


def stress_words(result: StressResult | None) -> list[str]:
    if result is None:
        return ["·"] * 4
    return [str(result.failed), str(result.changed), str(result.unconverged), str(result.clamped)]


def table(variants: list[Variant], scenes: dict[str, dict[str, SceneResult]],
          stress: dict[str, StressResult]) -> str:
    runs = stress[kUnchanged.name].runs if stress else 0
    lines = [f"| switched off | scenes of {len(scenes)} that change (error, × of the unchanged) | "
             f"stress: failures of {runs} | changed | unconverged | clamped |",
             "| --- | --- | ---: | ---: | ---: | ---: |"]
    for variant in [kUnchanged, *variants]:
        words = "" if variant is kUnchanged else scene_words(scenes, variant.name)
        lines.append(" | ".join(["| " + variant.name, words if scenes else "·",
                                 *stress_words(stress.get(variant.name))]) + " |")
    return "\n".join(lines)


def write_results(file: Path, scenes: dict[str, dict[str, SceneResult]]) -> None:
    with open(file, "w", newline="", encoding="utf-8") as out:
        rows = csv.writer(out)
        rows.writerow(["scene", "switched off", "error [m]", "same bytes"])
        for scene, results in scenes.items():
            for variant, result in results.items():
                rows.writerow([scene, variant, "" if result.error is None else result.error,
                               int(result.same)])


def print_lists(mechanisms: dict[str, Mechanism], scenes: dict[str, Scene]) -> None:
    for mechanism in mechanisms.values():
        values = " ".join("=".join(pair) for pair in mechanism.values)
        print(f"{mechanism.name:18} {mechanism.meaning} ({values})")
    print("\nscenes, and how much of them [s]:")
    for scene in scenes.values():
        print(f"{scene.name:30} {scene.seconds:g}")


def stress_choice(words: str) -> list[str]:
    """Options of the stress test."""
    if words not in ("subset", "all"):
        return ["--only", str(Path(words).resolve())]
    once_failed = ["--also", str(kRoot / "tests/stress/once_failed.txt")]
    return (["--subset"] if words == "subset" else []) + once_failed


def main() -> int:
    arguments = parse_arguments()
    mechanisms, known_scenes = read_mechanisms(), read_scenes()
    if arguments.list:
        print_lists(mechanisms, known_scenes)
        return 0
    variants = [chosen_variant(words, mechanisms) for words in arguments.mechanisms or mechanisms]
    names = list(known_scenes) if arguments.scenes is None else arguments.scenes
    for name in names:
        if name not in known_scenes:
            raise SystemExit(f"found {name}, expected a scene: {', '.join(known_scenes)}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    laboratory = Laboratory(arguments.programs.resolve(), kRoot / "scenes",
                            arguments.out.resolve(), say)
    scenes = {}
    for name in names:
        scenes[name] = laboratory.scene_results(known_scenes[name], variants, arguments.jobs)
        write_results(arguments.out / "scenes.csv", scenes)
    stress = {}
    if arguments.stress != "none":
        stress = laboratory.stress_results(variants, stress_choice(arguments.stress),
                                           arguments.jobs)
    text = table(variants, scenes, stress)
    (arguments.out / "table.md").write_text(text + "\n")
    print(text)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("\ninterrupted; repeat the command to go on", file=sys.stderr)
        sys.exit(130)
