"""Missing or damaged files and manifests of bundles: each is named by `open`, `verify` and the first use."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from tests.support import bundle_cases, need, valid
from tests.support.bundle_cases import content, use
from tests.support.refused import replace_value

DAMAGES: dict[str, Callable[[bytes], bytes | None]] = {
    "missing": lambda data: None,
    "shorter": lambda data: data[:-1],
    "changed": lambda data: data[:-1] + bytes([data[-1] ^ 1]),
    "empty": lambda data: b"",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("bundles") / "village"
    bundle_cases.write(path)
    return path


@pytest.fixture
def copied(folder: Path, tmp_path: Path) -> Path:
    shutil.copytree(folder, tmp_path / "copy")
    return tmp_path / "copy"


def test_the_village_has_files_of_every_kind(folder: Path) -> None:
    kinds = {name.rpartition(".")[2] for name in content(folder)}
    assert kinds == {"json", "webp", "range", "glb", "bin"}
    assert len(json.loads((folder / "manifest.json").read_text())["dynamic"]["parts"]) == 0


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_missing_or_altered_file_is_named(copied: Path, damage: str) -> None:
    used = nf.stream.open(copied)
    use(used)
    listed = sorted(name for name in content(copied) if name != "manifest.json")
    assert listed[-1] == "tileset.json"
    for name in listed if damage == "changed" else listed[::-3]:  # `open` checks that all are there and their sizes.
        opened = nf.stream.open(copied)
        data = (copied / name).read_bytes()
        altered = DAMAGES[damage](data)
        (copied / name).unlink()
        if altered is not None:
            (copied / name).write_bytes(altered)
        named = re.escape(f"{copied}/{name}: expected ")
        acts: list[Callable[[], object]] = [used.verify, opened.verify, lambda: opened.read(name)]  # noqa: B023
        if name != "tileset.json":  # The file is for other programs.
            acts.append(lambda: use(opened))  # noqa: B023
        for act in acts:
            with pytest.raises(nf.FormatError, match=named):
                act()
        if damage == "changed":
            nf.stream.open(copied)  # `open` does not read it.
        else:
            with pytest.raises(nf.FormatError, match=named):
                nf.stream.open(copied)
        (copied / name).write_bytes(data)
        opened.verify()


def test_behind_a_url_the_first_use_names_the_file(folder: Path) -> None:
    need("fsspec")
    import fsspec

    system = fsspec.filesystem("memory")
    for name, data in content(folder).items():
        system.pipe_file(f"/damaged/{name}", data)
    name = nf.stream.open("memory://damaged").files[-1]
    for altered in (None, b"", b"x"):
        system.rm_file(f"/damaged/{name}")
        if altered is not None:
            system.pipe_file(f"/damaged/{name}", altered)
        opened = nf.stream.open("memory://damaged")
        for act in (opened.verify, lambda: use(opened)):  # noqa: B023
            with pytest.raises(nf.FormatError, match=re.escape(f"memory://damaged/{name}: expected ")):
                act()
        system.pipe_file(f"/damaged/{name}", b"")


def places(node: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Paths of all values of a document; of lists the first and the last."""
    for key in node if isinstance(node, dict) else range(len(node)):
        if isinstance(node, dict) or key in (0, len(node) - 1):
            yield (*path, key)
            if isinstance(node[key], dict | list):
                yield from places(node[key], (*path, key))


HEADER = ("generator", "units", "axes", "origin")
"""Fields of all our files that describe how to read them; readers of a single version do not need them."""

WRONG: tuple[Any, ...] = (None, True, -1, 0.5, "x", [], {}, [None])


def refusal(folder: Path) -> str:
    """The message with which a bundle, or one of its uses, is refused; "" if it is usable."""
    try:
        use(nf.stream.open(folder))
    except nf.FormatError as error:
        return str(error)
    return ""


def check_values(folder: Path, values: tuple[Any, ...]) -> int:
    """Put values in all places of a manifest; returns how many were refused. Violations of the schema must be."""
    path = folder / "manifest.json"
    whole = json.loads(path.read_text())
    assert valid(whole, "bundle")
    refused, let = 0, []
    for place in places(whole):
        for value in values:
            document = replace_value(whole, value, *place)
            path.write_text(json.dumps(document))
            message = refusal(folder)
            if message:
                assert str(folder) in message
                assert "\n" not in message
                refused += 1
                continue
            # Python's True is a number in lists, as 1 is.
            is_harmless = place[0] in HEADER or (value is True and isinstance(place[-1], int))
            if not is_harmless and not valid(document, "bundle"):
                let.append((place, value))
    assert let == []
    return refused


def test_every_field_of_a_manifest_is_needed(copied: Path) -> None:
    assert check_values(copied, (...,)) > 90


@pytest.mark.slow
def test_no_manifest_that_breaks_the_schema_is_opened(copied: Path) -> None:
    assert check_values(copied, WRONG) > 750


@pytest.mark.parametrize(
    ("place", "value", "text"),
    [
        (("version",), 2, r"nearfar\.bundle version 2 was written by nearfar .*; this is nearfar .* up to version 1"),
        (("version",), 0, "expected a version of at least 1"),
        (("format",), "nearfar.reduced", r"expected format 'nearfar\.bundle'"),
        (("regions",), [], "regions"),
        (("regions", 0, "center"), ..., "'center' is missing"),
        (("regions", 0, "rings", 1, "radius"), -5.0, "radius: expected a number of at least 0"),
        (("regions", 0, "rings", 1, "radius"), 12.0, "rings: expected radii that ascend from 0"),
        (("regions", 0, "rings", 1, "radius"), ..., "'radius' is missing"),
        (("regions", 0, "rings", 1, "map", "tiles"), [-1], "tiles: expected ascending numbers below 6"),
        (("regions", 0, "rings", 0, "map", "color"), ["x"] * 6, "files: expected a file 'x'"),
        (("map", "face_size"), 10**9, "face_size: expected a whole number"),
        (("regions", 0, "range", "step"), 1e9, "step: expected ranges that are finite"),
        (("morph", "near_share"), 0.5, "near_share: expected 0.7"),
        (("files",), {}, "files"),
        (("files",), {"../secret": {"bytes": 1, "sha256": "0" * 64}}, "files: expected names below files/"),
        (("files",), {"files/a/b": {"bytes": 1, "sha256": "0" * 64}}, "files: expected names below files/"),
        (("dynamic", "geometry"), 3, "geometry: expected"),
    ],
)
def test_defects_of_a_manifest_are_explained(copied: Path, place: tuple[Any, ...], value: Any, text: str) -> None:
    path = copied / "manifest.json"
    path.write_text(json.dumps(replace_value(json.loads(path.read_text()), value, *place)))
    with pytest.raises(nf.FormatError, match=rf"{re.escape(str(path))}: .*{text}"):
        nf.stream.open(copied)


@pytest.mark.parametrize(
    "data", [b"", b"{", b"[]", b"null", b"\xff\xfe", b'{"format": NaN}', b"[" * 100_000, b'"\\ud800"']
)
def test_manifests_that_are_no_json_object_are_refused(copied: Path, data: bytes) -> None:
    (copied / "manifest.json").write_bytes(data)
    with pytest.raises(nf.FormatError, match=re.escape(f"{copied}/manifest.json: ")):
        nf.stream.open(copied)


def test_a_missing_manifest_is_named(tmp_path: Path) -> None:
    for place in (tmp_path, tmp_path / "none", tmp_path / "none" / "manifest.json"):
        with pytest.raises(FileNotFoundError, match=r"manifest\.json"):
            nf.stream.open(place)
    need("fsspec")
    with pytest.raises(FileNotFoundError, match=r"memory://nowhere/manifest\.json"):
        nf.stream.open("memory://nowhere")
