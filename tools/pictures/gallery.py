"""Runs scenes and shows all their pictures on one page."""
from __future__ import annotations

import argparse
import html
import json
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

kRoot = Path(__file__).resolve().parents[2]
kScenes = kRoot / "scenes"
# The picture that heads the README: a scene, how it is drawn, and the number of its frame.
kShowcase = "wake_of_a_tug"
kShowcaseLook = ("render.size=[1280, 480]", "render.overlay=false", "render.grid=false", "render.every=40",
                 "render.camera={from: [-30, -19, 9], to: [-3, 2, 0.5], fov_deg: 36, follow: tug}")
kShowcaseFrame = 1
kSheet = "teapot_drop"  # Scene whose sheet the README shows.
kSheetWidth = 1344  # [px]
# Whose pictures the README shows beside its list, and the font of their names.
kSix = ("buoys_in_a_wake", "sailing_catamaran", "landing_craft", "moored_buoy", "open_boat", "two_hundred_crates")
kFont = "DejaVuSans.ttf"
kColumns = 3
kCell = 400  # Width of a picture on the sheet [px].
kGap = 16  # Between pictures [px].
kLine = 34  # Height of a name below its picture [px].

kPage = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Plimsoll: gallery</title>
<style>
  :root {{ color-scheme: light dark; }}
  body {{ font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 88rem;
         padding: 0 1.2rem; background: Canvas; color: CanvasText; }}
  h1 {{ font-size: 1.5rem; font-weight: 600; margin: 0; }}
  p {{ margin: .2rem 0 1.6rem; opacity: .75; }}
  main {{ display: grid; gap: 1.6rem; grid-template-columns: repeat(auto-fill, minmax(24rem, 1fr)); }}
  figure {{ margin: 0; }}
  img {{ width: 100%; height: auto; border-radius: 6px; display: block; }}
  figcaption {{ margin-top: .5rem; }}
  figcaption b {{ display: block; font-weight: 600; }}
  small {{ opacity: .75; }}
</style>
<h1>Gallery</h1>
<p>{count} scenes, run and drawn in {seconds:.0f} s. A picture leads to the whole sequence.</p>
<main>
{figures}
</main>
"""

kFigure = """<figure>
<a href="{name}/sheet.png"><img src="{picture}" alt="{title}" loading="lazy"></a>
<figcaption><b>{title}</b><small>scenes/{name}.yaml: {told}</small></figcaption>
</figure>"""


@dataclass(frozen=True)
class Result:
    """A scene that was run."""

    name: str
    folder: Path
    error: str  # Empty: none.

    @property
    def frames(self) -> list[Path]:
        return sorted(self.folder.glob("frames/**/frame_*.png"))

    @property
    def middle(self) -> Path:
        """The picture of the first camera in the middle of the sequence: most scenes have come to
        their point by then."""
        cameras = self.summary.get("pictures", {}).get("cameras") or [""]
        of_first = sorted((self.folder / "frames" / cameras[0]).glob("frame_*.png"))
        return (of_first or self.frames)[len(of_first or self.frames) // 2]

    @property
    def title(self) -> str:
        return self.summary.get("title") or self.name.replace("_", " ")

    @property
    def summary(self) -> dict:
        return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/gallery", description=__doc__,
        epilog="tools/gallery --guide [NAME...] renews the pictures of scenes/GUIDE.md instead.")
    parser.add_argument("scenes", nargs="*", type=Path, metavar="SCENE",
                        help="scene files, or names of those in scenes/ [all of these]")
    parser.add_argument("--out", type=Path, default=Path("out/gallery"), metavar="DIR",
                        help="folder of the page [out/gallery]")
    parser.add_argument("--set", action="append", default=[], metavar="KEY.PATH=VALUE",
                        help="for every scene, such as render.pressure.colors=viridis")
    parser.add_argument("--readme", action="store_true",
                        help=f"renew the pictures of the README: {kShowcase}, the sheet of {kSheet}, and six scenes")
    return parser.parse_args()


def found(scene: Path) -> Path:
    """The file itself, or else the scene of that name."""
    return scene if scene.is_file() else kScenes / f"{scene.stem}.yaml"


def run(program: Path, scene: Path, out: Path, changes: list[str]) -> Result:
    folder = out / scene.stem
    command = [str(program), "run", str(scene), "--quiet", "--threads", "1", "--out", str(folder)]
    for change in changes:
        command += ["--set", change]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    error = done.stderr.strip() if done.returncode else ""
    print(f"{scene.stem}: {error or 'done'}", file=sys.stderr)
    return Result(scene.stem, folder, error)


def figure(result: Result) -> str:
    summary = result.summary
    bodies = len(summary.get("bodies", [])) or None
    told = ", ".join(part for part in (
        f"{bodies} bod{'y' if bodies == 1 else 'ies'}" if bodies else "",
        f"{summary['simulated_seconds']:g} s", f"{len(result.frames)} pictures") if part)
    picture = result.middle.relative_to(result.folder.parent)
    return kFigure.format(name=result.name, picture=picture.as_posix(),
                          title=html.escape(result.title), told=told)


def showcase(program: Path, out: Path, to: Path) -> None:
    """Draws the run of the showcase in its own look."""
    from PIL import Image
    folder = out / "showcase"
    changes = [word for change in kShowcaseLook for word in ("--set", change)]
    subprocess.run([str(program), "render", str(out / kShowcase), "--out", str(folder), "--quiet", *changes],
                   check=True)
    with Image.open(folder / "frames" / f"frame_{kShowcaseFrame:04}.png") as image:
        image.convert("RGB").save(to, optimize=True)


def publish(sheet: Path, to: Path) -> None:
    """As wide as the README shows it."""
    from PIL import Image
    with Image.open(sheet) as image:
        height = round(image.height * kSheetWidth / image.width)
        small = image.convert("RGB").resize((kSheetWidth, height), Image.Resampling.LANCZOS)
    small.save(to, optimize=True)


def sheet(results: list[Result], to: Path) -> None:
    """Writes the middle picture of each scene with its title below, in rows."""
    from PIL import Image, ImageDraw, ImageFont
    pictures = []
    for result in results:
        with Image.open(result.middle) as image:
            height = round(image.height * kCell / image.width)
            pictures.append(image.convert("RGB").resize((kCell, height), Image.Resampling.LANCZOS))
    columns = min(kColumns, len(pictures))
    tallest = max(picture.height for picture in pictures) + kLine
    rows = -(-len(pictures) // columns)
    page = Image.new("RGB", (columns * (kCell + kGap) + kGap, rows * (tallest + kGap) + kGap), "white")
    pen, font = ImageDraw.Draw(page), ImageFont.truetype(kFont, 15)
    for i, (result, picture) in enumerate(zip(results, pictures)):
        x = kGap + i % columns * (kCell + kGap)
        y = kGap + i // columns * (tallest + kGap)
        page.paste(picture, (x, y))
        pen.text((x + kCell / 2, y + picture.height + 8), result.title, "black", font, anchor="ma")
    page.save(to, optimize=True)


def main() -> int:
    arguments = parse_arguments()
    program = Path(os.environ["PLIMSOLL"]).resolve()
    scenes = [found(scene) for scene in arguments.scenes] or sorted(kScenes.glob("*.yaml"))
    missing = [scene for scene in scenes if not scene.is_file()]
    if missing:
        print(f"tools/gallery: there is no scene {missing[0].stem}", file=sys.stderr)
        return 2
    out = arguments.out
    out.mkdir(parents=True, exist_ok=True)
    begin = time.monotonic()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda scene: run(program, scene, out, arguments.set), scenes))
    drawn = [result for result in results if not result.error and result.frames]
    page = out / "index.html"
    page.write_text(kPage.format(count=len(drawn), seconds=time.monotonic() - begin,
                                 figures="\n".join(figure(result) for result in drawn)),
                    encoding="utf-8")
    print(page)
    if drawn:
        sheet(drawn, out / "sheet.png")
        print(out / "sheet.png")
    if arguments.readme:
        showcase(program, out, kScenes / "pictures" / f"{kShowcase}.png")
        publish(out / kSheet / "sheet.png", kScenes / "pictures" / f"{kSheet}.png")
        by_name = {result.name: result for result in drawn}
        sheet([by_name[name] for name in kSix], kScenes / "pictures" / "six_scenes.png")
    return 0 if len(drawn) == len(results) else 1


if __name__ == "__main__":
    sys.exit(main())
