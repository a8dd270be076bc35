"""Documents of saved reduced scenes: plausibility checks, and names of folders."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from tests.support.reduce_cases import CENTER, R1, R2, street


@pytest.mark.parametrize("count", [-1, 2**31, 2**70, 1.5, "a", True, ["a", "a"], [1]])
def test_implausible_numbers_of_objects_are_refused(count: Any, tmp_path: Path) -> None:
    nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=8).save(tmp_path / "light")
    document = json.loads((tmp_path / "light" / "reduced.json").read_text(encoding="utf-8"))
    (tmp_path / "light" / "reduced.json").write_text(json.dumps(document | {"object_names": count}))
    with pytest.raises(nf.FormatError, match=r"reduced\.json: damaged: object_names: expected"):
        nf.ReducedScene.load(tmp_path / "light")


def test_many_nameless_objects_take_no_memory(tmp_path: Path) -> None:
    nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=8).save(tmp_path / "light")
    document = json.loads((tmp_path / "light" / "reduced.json").read_text(encoding="utf-8"))
    (tmp_path / "light" / "reduced.json").write_text(json.dumps(document | {"object_names": 2_000_000_000}))
    with pytest.raises(nf.FormatError, match="it has 2000000000 objects, such as 'object_0'"):
        nf.ReducedScene.load(tmp_path / "light")


def test_a_folder_may_be_named_by_its_document(tmp_path: Path) -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=8)
    reduced.save(tmp_path / "light")
    assert nf.ReducedScene.load(tmp_path / "light" / "reduced.json").r2 == reduced.r2


@pytest.mark.parametrize(
    ("what", "key"), [("accessors", "bufferView"), ("accessors", "count"), ("nodes", "mesh"), ("nodes", "standing")]
)
def test_errors_about_negative_numbers_name_the_file(what: str, key: str, tmp_path: Path) -> None:
    from nearfar._base import glb

    nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=8).save(tmp_path / "light")
    near = tmp_path / "light" / "near.glb"
    data = near.read_bytes()
    document, end = glb.header(data)
    entries = [entry.get("extras", {}) if key == "standing" else entry for entry in document[what]]
    next(entry for entry in entries if key in entry)[key] = -1
    near.write_bytes(glb._file(json.dumps(document), data[end:]))
    with pytest.raises(nf.FormatError, match=r"near\.glb: damaged"):
        nf.ReducedScene.load(tmp_path / "light")
