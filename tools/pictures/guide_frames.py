"""Pictures of runs, and text as a terminal shows it."""
from __future__ import annotations

import re
import shutil
import textwrap
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from guide_work import LeftOut, Work, set_words

kSize = (480, 300)  # All pictures of the guide [px]; it shows them half as wide.
kFiner = 2  # Factor of what is drawn, which smooths edges.
kInk, kGray, kPaper = "#37424d", "#6b7782", "#f6f8fa"
kGreen, kRed, kBlue = "#2f7d3b", "#c8553d", "#0b6e99"
kMono = "DejaVuSansMono.ttf"
kLetters, kLine, kMargin = 19, 29, 18  # Size and height of lines of text, and space beside them [px].
kColumns = 38  # Letters in a line that fit.
kGap = 3  # Half the space between pictures beside each other [px].
kBrowsers = ("chromium", "chromium-browser", "google-chrome")


def frame_of(work: Work, run: str, time: float, camera: str, *changes: str,
             size: tuple = kSize, finer: int = kFiner) -> Image.Image:
    """The picture of a run at a time > 0, without overlay and grid."""
    pixels = [finer * length for length in size]
    look = (f"render.size={pixels}", f"render.every={time}", "render.overlay=false", "render.grid=false",
            *changes, f"render.camera={camera}")
    work.run("plimsoll", "render", run, "--out", "drawn", "--quiet", *set_words(look))
    with Image.open(work.folder / "drawn/frames/frame_0001.png") as image:
        small = image.convert("RGB").resize(size, Image.Resampling.LANCZOS)
    shutil.rmtree(work.folder / "drawn")
    return small


def frame(run: str, time: float, camera: str, *changes: str):
    """Draws a run of the task."""
    return lambda work: frame_of(work, run, time, camera, *changes)


def frame_of_scene(scene: str, time: float, camera: str, *changes: str):
    """Draws a scene that the task only checks, or that its code runs."""
    def draw(work: Work) -> Image.Image:
        work.run_scene(scene, f"duration={time}", *changes)
        return frame_of(work, f"out/{Path(scene).stem}", time, camera, *changes)
    return draw


def frame_of_text(text: str, time: float, camera: str, *changes: str):
    """Draws a scene beside what the task wrote."""
    def draw(work: Work) -> Image.Image:
        (work.folder / "shown.yaml").write_text(text, encoding="utf-8")
        return frame_of_scene("shown.yaml", time, camera, *changes)(work)
    return draw


def film(run: str, times: tuple, camera: str, *changes: str):
    """Draws four pictures of a run, two beside each other. They are not drawn finer, which would make
    arrows thin."""
    def draw(work: Work) -> Image.Image:
        sheet = Image.new("RGB", kSize, "white")
        width, height = kSize[0] // 2, kSize[1] // 2
        for i, time in enumerate(times):
            small = frame_of(work, run, time, camera, *changes, size=(width - kGap, height - kGap), finer=1)
            sheet.paste(small, (i % 2 * (width + kGap), i // 2 * (height + kGap)))
        return sheet
    return draw


def terminal(lines: list[tuple[str, str]]) -> Image.Image:
    """Lines of text, each with its colour."""
    image = Image.new("RGB", kSize, kPaper)
    pen, font = ImageDraw.Draw(image), ImageFont.truetype(kMono, kLetters)
    top = (kSize[1] - kLine * len(lines)) // 2
    pen.rectangle((0, 0, kSize[0] - 1, kSize[1] - 1), outline="#d3dae0")
    for i, (text, color) in enumerate(lines):
        pen.text((kMargin, top + kLine * i), text, color, font)
    return image


def verdicts(work: Work) -> Image.Image:
    """The last command, which compares two runs, with what it says of each quantity."""
    command = "$ " + next(step.text for step in reversed(work.steps) if step.kind == "run").split(" --")[0]
    rows = [line.split() for line in work.printed[-1].splitlines() if line.endswith(" ok")]
    last = work.printed[-1].splitlines()[-1]
    return terminal([(command, kInk), ("", kInk), *((f"{row[0]}  {row[1]:18}{row[-1]}", kGray) for row in rows),
                     ("", kInk), (last, kGreen)])


def choices_of_radiation(work: Work) -> Image.Image:
    """The words of `check` about the radiation of each body, in short lines."""
    lines = [("$ plimsoll check …", kInk), ("", kInk)]
    for told in work.printed[0].splitlines():
        found = re.match(r"\S+: (\w+: (no )?radiation: .*)", told)
        if found:
            color = kRed if found[2] else kGreen
            lines += [(line, color) for line in textwrap.wrap(found[1], kColumns, subsequent_indent="  ")]
    return terminal(lines)


def page(report: str):
    """Draws a page as a browser shows it."""
    def draw(work: Work) -> Image.Image:
        browser = next(filter(None, map(shutil.which, kBrowsers)), None)
        if browser is None:
            raise LeftOut("no chromium")
        shot = work.folder / "page.png"
        work.run(browser, "--headless", "--no-sandbox", "--hide-scrollbars", "--use-gl=swiftshader",
                 "--enable-unsafe-swiftshader", "--virtual-time-budget=10000", "--window-size=1240,775",
                 f"--user-data-dir={work.folder}/browser", f"--screenshot={shot}",
                 (work.folder / report).resolve().as_uri())
        with Image.open(shot) as image:
            return image.convert("RGB").resize(kSize, Image.Resampling.LANCZOS)
    return draw
