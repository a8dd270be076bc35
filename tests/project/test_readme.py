"""Tests that the README is right: its example runs, its commands exist, its pictures exist."""

from __future__ import annotations

import re
import warnings
from pathlib import Path

import pytest
from PIL import Image

CHECKOUT = Path(__file__).resolve().parents[2]
README = CHECKOUT / "README.md"


def example() -> str:
    found = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    return str(found[0])


def test_the_example_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    code = example()
    for size, smaller in (("blocks=6", "blocks=2"), ("face_size=512", "face_size=64"), ("(640, 400)", "(64, 40)")):
        assert size in code
        code = code.replace(size, smaller)
    monkeypatch.chdir(tmp_path)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        exec(code, {})
    assert re.search(r"[\d,]+ triangles", capsys.readouterr().out)
    for name in ("truth", "impostors", "continuous"):
        with Image.open(tmp_path / f"{name}.png") as picture:
            assert picture.size == (64, 40)


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
