"""Tests that the README is right: its example runs, its commands exist, its pictures exist."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

CHECKOUT = Path(__file__).resolve().parents[2]
README = CHECKOUT / "README.md"


def example() -> str:
    found = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    return str(found[0])


def test_the_example_runs(tmp_path: Path) -> None:
    process = subprocess.run(
        [sys.executable, "-W", "error", "-c", example()], cwd=tmp_path, capture_output=True, text=True, timeout=300
    )
    assert process.returncode == 0, process.stderr
    assert re.search(r"[\d,]+ triangles", process.stdout)
    with Image.open(tmp_path / "truth.png") as truth, Image.open(tmp_path / "continuous.png") as continuous:
        assert truth.size == continuous.size


def test_the_commands_exist() -> None:
    makefile = (CHECKOUT / "Makefile").read_text(encoding="utf-8")
    commands = set(re.findall(r"\bmake (\w+)", README.read_text(encoding="utf-8")))
    assert {"demo", "test"} <= commands
    assert commands <= set(re.findall(r"^(\w+):", makefile, re.MULTILINE))


PAGES = ["README.md", "ARCHITECTURE.md", *(f"docs/{page.name}" for page in sorted((CHECKOUT / "docs").glob("*.md")))]


def links(name: str) -> list[Path]:
    """Files of the checkout that a page links to."""
    page = CHECKOUT / name
    found = re.findall(r"\]\((?!https?:|#)([^)#]+)", page.read_text(encoding="utf-8"))
    return [(page.parent / link).resolve() for link in found]


@pytest.mark.parametrize("name", PAGES)
def test_local_links_exist(name: str) -> None:
    for link in links(name):
        assert link.exists(), link


def test_pages_are_reachable_from_the_readme() -> None:
    found = {*links("README.md"), *links("docs/README.md")}
    assert {(CHECKOUT / name) for name in PAGES if name.startswith("docs/")} <= found


def test_pictures_are_used() -> None:
    used = {link for name in PAGES for link in links(name)}
    pictures = [path for path in (CHECKOUT / "docs").iterdir() if path.suffix in (".png", ".jpg")]
    assert pictures
    for path in pictures:
        assert path in used, path


def test_every_cited_work_is_listed() -> None:
    listed = set(re.findall(r"year\s*=\s*\{(\d{4})\}", (CHECKOUT / "references.bib").read_text(encoding="utf-8")))
    cited = set()
    for path in [*(CHECKOUT / "rust/core/src").rglob("*.rs"), *(CHECKOUT / "python").rglob("*.py")]:
        # A year follows a word, a comma or a bracket; numbers in code have a digit before the comma or after a point.
        years = re.findall(
            r"(?:\(|[^\d], |of |al\. )((?:19[5-9]|20[0-2])\d)(?![\d.]\d)", path.read_text(encoding="utf-8")
        )
        assert set(years) <= listed, path
        cited |= set(years)
    assert {"1978", "2008", "2013", "2022", "2024"} <= cited
