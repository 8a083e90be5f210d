"""Draws the picture of each task of scenes/GUIDE.md from what the task runs.

The guide names the picture of a task, scenes/pictures/guide/NAME.png; NAME chooses how it is drawn."""
from __future__ import annotations

import argparse
import math
import os
import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from PIL import Image

from guide_pictures import kPictures
from guide_work import LeftOut, Machine, kRoot, work_through

from documented_scenes import GUIDE, tasks_of, titles_of  # noqa: E402  guide_work makes it known.

kFolder = kRoot / "scenes/pictures/guide"
kColors = (128, 96, 64)  # Sizes of a palette; the first that makes a file small enough is taken.
kBackground = 0.5  # Share of the pixels that the background of a plot has at least.
kCoarse = 0xFC  # Bits of a channel by which colours are told apart when they are counted.
kMostBytes = 40_000  # The guide loads forty such files.


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tools/gallery --guide", description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="pictures to draw, such as tow [all]")
    parser.add_argument("--out", type=Path, default=kFolder, metavar="DIR",
                        help="folder of the pictures [scenes/pictures/guide]")
    return parser.parse_args()


def names_of(text: str) -> dict[str, str]:
    """The titles of the guide's tasks by the names of their pictures."""
    lines = text.split("\n")
    return {picture[1]: title for title, line in zip(titles_of(lines), lines)
            if title and (picture := re.search(r'src="pictures/guide/([\w-]+)\.png"', line))}


def palette_of(image: Image.Image, colors: int) -> Image.Image:
    """A palette in which small parts have their colours, too: a colour counts by the root of its pixels."""
    coarse = image.point(lambda value: value & kCoarse)
    counted = coarse.getcolors(image.width * image.height)
    sample = [color for count, color in counted for _ in range(math.isqrt(count))]
    strip = Image.new("RGB", (len(sample), 1))
    strip.putdata(sample)
    return strip.quantize(colors, method=Image.Quantize.MEDIANCUT, kmeans=2)


def is_drawn(image: Image.Image) -> bool:
    """True if a plot or text, which has a background of one colour, false if rendered."""
    pixels = image.width * image.height
    return max(count for count, _ in image.getcolors(pixels)) > kBackground * pixels


def save(image: Image.Image, to: Path) -> None:
    """Writes a picture with as many colours as its size allows; the shades of a rendered one are
    dithered."""
    for colors in kColors:
        if is_drawn(image):
            flat = image.quantize(colors, dither=Image.Dither.NONE)
        else:
            flat = image.quantize(palette=palette_of(image, colors), dither=Image.Dither.FLOYDSTEINBERG)
        flat.save(to, optimize=True)
        if to.stat().st_size <= kMostBytes:
            return


def draw(name: str, steps: list, machine: Machine, folder: Path, out: Path) -> bool:
    """Works through a task and draws its picture; returns whether nothing is wrong."""
    try:
        work = work_through(steps, machine, folder)
        save(kPictures[name](work), out / f"{name}.png")
    except LeftOut as left_out:
        print(f"{name}: left out: {left_out}", file=sys.stderr)
    except Exception as error:  # Other pictures are drawn all the same.
        print(f"{name}: {type(error).__name__}: {error}", file=sys.stderr)
        return False
    else:
        print(out / f"{name}.png", flush=True)
    return True


def main() -> int:
    arguments = parse_arguments()
    text = (kRoot / GUIDE).read_text(encoding="utf-8")
    tasks, titles = tasks_of(text), names_of(text)
    wanted = arguments.names or list(titles)
    unmatched = sorted(titles.keys() ^ kPictures.keys()) + [name for name in wanted if name not in titles]
    if unmatched:
        print(f"tools/gallery: {unmatched[0]} is not in both {GUIDE} and guide_pictures.py", file=sys.stderr)
        return 2
    out = arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    program = Path(os.environ["PLIMSOLL"]).resolve()
    with tempfile.TemporaryDirectory() as place, ThreadPoolExecutor(2) as pool:
        machine = Machine(Path(place), program, str(program.parent / "python"), program.parent / "report")
        drawn = list(pool.map(
            lambda name: draw(name, tasks[titles[name]], machine, Path(place) / "tasks" / name, out), wanted))
    return 0 if all(drawn) else 1


if __name__ == "__main__":
    sys.exit(main())
