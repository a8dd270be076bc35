"""Reads notebook cards: they must be well-formed, harmless, and in the page's own colours."""

from __future__ import annotations

import base64
import io
import re
import xml.etree.ElementTree as ElementTree

import numpy as np
from numpy.typing import NDArray
from PIL import Image

EMBEDDED = "data:image/png;base64,"


class Card:
    """A card's elements, text and pictures."""

    def __init__(self, text: str) -> None:
        assert not text.startswith("<pre>"), f"expected a card, got the plain text {text}"
        # Browsers accept tags that XML refuses, such as <img> without an end.
        self.root = ElementTree.fromstring(re.sub(r"(<img\b[^>]*)>", r"\1/>", text))
        for element in self.root.iter():
            assert element.tag not in ("script", "style", "link", "iframe", "object")
            names = element.attrib.keys()
            assert not any(name.startswith("on") or name == "href" for name in names), element.attrib
            assert element.get("src", EMBEDDED).startswith(EMBEDDED)
            style = element.get("style", "")
            assert "url(" not in style
            assert not re.search(r"(?<!-)color:(?!#)|background(?!:none)", style), f"a colour of one theme: {style}"
            assert element.tag != "text" or element.get("fill") == "currentColor"
        self.text = " ".join("".join(self.root.itertext()).split())

    def facts(self) -> dict[str, str]:
        """Rows of two cells."""
        rows = [["".join(cell.itertext()) for cell in row] for row in self.root.iter("tr")]
        return {row[0]: row[1] for row in rows if len(row) == 2}

    def pictures(self) -> list[NDArray[np.uint8]]:
        """Embedded pictures (H, W, 3 or 4)."""
        sources = [element.attrib["src"] for element in self.root.iter("img")]
        return [decoded(base64.b64decode(source.removeprefix(EMBEDDED))) for source in sources]

    def count(self, tag: str) -> int:
        """Number of elements of a tag."""
        return sum(1 for _ in self.root.iter(tag))


def decoded(png: bytes) -> NDArray[np.uint8]:
    with Image.open(io.BytesIO(png), formats=["PNG"]) as image:
        return np.asarray(image)
