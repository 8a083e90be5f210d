"""Checks the page and the sheet of tools/gallery.  gallery_test.py PROGRAM; 77: no Pillow."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    from PIL import Image
except ImportError:
    sys.exit(77)

GALLERY = Path(__file__).resolve().parents[3] / "tools/pictures/gallery.py"
SCENE = """\
plimsoll: 1
title: A box
duration: 0.2
bodies: [{name: box, box: {size: [1, 1, 1]}, density: 500, position: [0, 0, 2]}]
render: {every: 0.05, size: [64, 48], %s}
"""


def main(program):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        # Of two cameras the first in the scene is shown, not the first by its name.
        (folder / "one.yaml").write_text(
            SCENE % "cameras: {wide: {from: [6, -8, 3]}, close: {from: [3, -4, 2]}}")
        (folder / "two.yaml").write_text(SCENE % "camera: {from: [6, -8, 3]}")
        out = folder / "gallery"
        subprocess.run([sys.executable, "-B", GALLERY, folder / "one.yaml", folder / "two.yaml",
                        "--out", out], check=True, env={**os.environ, "PLIMSOLL": program})
        page = (out / "index.html").read_text()
        assert "one/frames/wide/frame_0002.png" in page, page  # the middle of five
        assert "two/frames/frame_0002.png" in page, page
        with Image.open(out / "sheet.png") as sheet:
            width, height = sheet.size
            # Two pictures of 4:3 beside each other, with room for a line below.
            assert width > 2 * 300 and 0.3 < height / width < 0.5, sheet.size
            background = sheet.convert("RGB").getpixel((2, 2))
            middle = sheet.convert("RGB").getpixel((width // 4, height // 3))
            assert background == (255, 255, 255) != middle, (background, middle)


if __name__ == "__main__":
    main(str(Path(sys.argv[1]).resolve()))
