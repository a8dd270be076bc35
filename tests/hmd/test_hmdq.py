"""Tests of hmdq files: documents in its format, from OpenVR and from LibOVR, of new and old versions."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf


def single(value: float) -> float:
    """Round to float32, like the numbers of OpenVR and LibOVR in hmdq."""
    return float(np.float32(value))


def raw(left: float, right: float, bottom: float, top: float) -> dict[str, float]:
    aspect = (right - left) / (top - bottom)
    values = {"tan_left": left, "tan_right": right, "tan_bottom": bottom, "tan_top": top, "aspect": aspect}
    return {key: single(value) for key, value in values.items()}


def turn(degrees: float, x: float) -> list[list[float]]:
    """Return the matrix of an eye rotated about the vertical, to the left by positive angles."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[single(v) for v in row] for row in ([c, 0, s, x], [0, 1, 0, 0], [-s, 0, c, 0])]


def openvr_geometry() -> dict[str, Any]:
    """Return a made-up headset, canted by eight degrees."""
    mesh = {"ham_area": 0.125, "verts_raw": [[0, 0], [0.5, 0], [0, 0.5]], "verts_opt": [[0, 0], [0.5, 0], [0, 0.5]]}
    return {
        "rec_rts": [1600, 1500],
        "raw_eye": {"Left": raw(-1.5, 1.1, -1.2, 1.3), "Right": raw(-1.1, 1.5, -1.2, 1.3)},
        "eye2head": {"Left": turn(8.0, -0.032), "Right": turn(-8.0, 0.032)},
        "ham_mesh": {"Left": mesh, "Right": mesh | {"ham_area": 0.135}},
    }


def oculus_view(width: int) -> dict[str, Any]:
    def eye(x: float) -> dict[str, Any]:
        pose = {"orientation": [0.0, 0.0, 0.0, 1.0], "position": [x, 0.0, 0.0]}
        return {"distorted_viewport": [[0, 0], [900, 1000]], "pixels_per_tan": [800.0, 800.0], "hmd2eye_pose": pose}

    return {
        "rec_rts": [width, 1234],
        "raw_eye": {"Left": raw(-1.0, 0.8, -1.1, 0.9), "Right": raw(-0.8, 1.0, -1.1, 0.9)},
        "render_desc": {"Left": eye(-0.03), "Right": eye(0.03)},
        "ham_mesh": {"Left": None, "Right": None},
    }


def document() -> dict[str, Any]:
    headset = {
        "Prop_DeviceClass_Int32": 1,
        "Prop_ManufacturerName_String": "Nobody",
        "Prop_ModelNumber_String": "Canted",
        "Prop_DisplayFrequency_Float": 110.0,
    }
    base = {"Prop_DeviceClass_Int32": 4, "Prop_ModelNumber_String": "Lighthouse"}
    return {
        "misc": {"time": "2024-05-06 07:08:09", "hmdq_ver": "2.2.1", "log_ver": 5, "os_ver": "10.0.1"},
        "openvr": {
            "rt_path": "C:\\runtime",
            "rt_ver": "1.2.3",
            "devices": [[0, 4], [1, 1]],
            "properties": {"0": base, "1": headset},
            "geometry": openvr_geometry(),
        },
        "oculus": {
            "rt_ver": "1.0",
            "devices": {"HMD": 1, "trackers": 0, "ctrl_types": 0},
            "properties": {
                "HMD": {
                    "Prop_Manufacturer_String": "Nobody",
                    "Prop_ProductName_String": "Flat",
                    "Prop_DisplayRefreshRate_Float": 80.0,
                }
            },
            "geometry": {"default_fov": oculus_view(1000), "max_fov": oculus_view(1100)},
        },
        "checksum": "00",
    }


def load(tmp_path: Path, content: Any, **options: Any) -> nf.Hmd:
    path = tmp_path / "dump.json"
    path.write_text(json.dumps(content), encoding="utf-8")
    return nf.Hmd.load(path, **options)


def test_openvr_is_read(tmp_path: Path) -> None:
    hmd = load(tmp_path, document())
    assert (hmd.name, hmd.refresh_hz, hmd.render_size) == ("Nobody Canted", 110.0, (1600, 1500))
    assert hmd.hidden_area_percent is not None
    assert math.isclose(hmd.hidden_area_percent, 13.0)
    assert hmd.left.fov == nf.Fov(single(-1.5), single(1.1), single(-1.2), single(1.3))
    assert hmd.right.position == (single(0.032), 0.0, 0.0)
    # The left eye is turned to the left: float32 sines are off by 2⁻²⁵.
    assert math.isclose(hmd.left.rotation_deg, -8.0, abs_tol=1e-5)
    assert math.isclose(hmd.right.rotation_deg, 8.0, abs_tol=1e-5)
    left, right = math.degrees(math.atan(1.5)) + 8.0, math.degrees(math.atan(1.1)) - 8.0
    assert math.isclose(hmd.total_fov.horizontal_deg, 2 * left, abs_tol=1e-5)
    assert math.isclose(hmd.total_fov.overlap_deg, 2 * right, abs_tol=1e-5)
    assert "hmdq 2.2.1" in hmd.sources[0]


def test_oculus_is_read(tmp_path: Path) -> None:
    hmd = load(tmp_path, document(), runtime="oculus")
    assert (hmd.name, hmd.refresh_hz, hmd.render_size) == ("Nobody Flat", 80.0, (1000, 1234))
    assert hmd.left.position == (-0.03, 0.0, 0.0)
    assert hmd.hidden_area_percent is None
    assert load(tmp_path, document(), runtime="oculus_max").render_size == (1100, 1234)
    alone = document()
    del alone["openvr"]
    assert load(tmp_path, alone).name == "Nobody Flat"


def test_old_versions_are_read(tmp_path: Path) -> None:
    """Before version 1.3.4 all data were OpenVR's, at the top level."""
    new = document()
    openvr = new["openvr"]
    old = {"misc": {"time": "2019-08-30T20:51:12", "hmdq_ver": "1.2.2", "openvr_ver": "1.7.12"}}
    old |= {"devices": openvr["devices"], "properties": openvr["properties"], "geometry": openvr["geometry"]}
    one, other = load(tmp_path, old), load(tmp_path, new)
    assert (one.name, one.left, one.right, one.refresh_hz) == (other.name, other.left, other.right, other.refresh_hz)


def test_a_dump_without_properties_is_named_after_its_file(tmp_path: Path) -> None:
    content = document()
    del content["openvr"]["properties"]
    hmd = load(tmp_path, content)
    assert (hmd.name, hmd.refresh_hz) == ("dump", None)


@pytest.mark.parametrize("rate", [0, 0.0, -1, math.nan, math.inf, True, "fast", None, 10**400])
def test_an_invalid_refresh_rate_is_unknown(tmp_path: Path, rate: Any) -> None:
    content = document()
    content["openvr"]["properties"]["1"]["Prop_DisplayFrequency_Float"] = rate
    assert load(tmp_path, content).refresh_hz is None


@pytest.mark.parametrize("area", [True, None, math.nan, "0.1"])
def test_areas_that_are_not_numbers_are_unknown(tmp_path: Path, area: Any) -> None:
    content = document()
    content["openvr"]["geometry"]["ham_mesh"]["Left"]["ham_area"] = area
    assert load(tmp_path, content).hidden_area_percent == 13.5


def test_file_names_that_are_not_unicode_are_read() -> None:
    content = document()
    del content["openvr"]["properties"]
    hmd = nf.Hmd._from_json(json.dumps(content).encode(), "one\udcff.json")
    assert hmd.name == "one?"
    assert hmd.sources[0].startswith("one?.json: openvr")


def test_written_files_contain_the_values_of_hmdv(tmp_path: Path) -> None:
    """The values listed for the Valve Index in the geometry database that its mesh does not affect."""
    path = tmp_path / "index.json"
    nf.hmd.INDEX.save(path, format="hmdq")
    written = json.loads(path.read_text(encoding="utf-8"))
    geometry = written["openvr"]["geometry"]
    left = geometry["fov_head"]["Left"]
    shown = [left[key] for key in ("deg_bottom", "deg_top", "deg_ver")]
    np.testing.assert_allclose(shown, [-54.52, 54.63, 109.15], rtol=0, atol=0.0051)
    np.testing.assert_allclose(geometry["fov_eye"]["Left"]["deg_ver"], 109.36, rtol=0, atol=0.0051)
    assert round(geometry["view_geom"]["left_rot"], 1) == -5.0
    assert round(geometry["view_geom"]["ipd"] * 1e3, 1) == 58.0
    np.testing.assert_allclose(geometry["eye2head"]["Left"][0], [0.996195, 0, 0.087156, -0.029], atol=1e-6)
    # Points of the edge are at depth 1 and agree with the angles.
    points = np.array(left["fov_pts"])
    assert points.shape == (8, 3)
    np.testing.assert_allclose(points[:, 2], -1.0, atol=1e-12)
    angles = np.degrees(np.arctan(points[[7, 3], 0])), np.degrees(np.arctan(points[[1, 5], 1]))
    np.testing.assert_allclose(angles[0], [left["deg_left"], left["deg_right"]], atol=1e-9)
    np.testing.assert_allclose(angles[1], [left["deg_bottom"], left["deg_top"]], atol=1e-9)
    for key in ("time", "hmdq_ver", "log_ver", "os_ver"):
        assert key in written["misc"]
    # Files of parallel views have no angles in the eyes' axes.
    nf.hmd.VIVE.save(path, format="hmdq")
    assert json.loads(path.read_text(encoding="utf-8"))["openvr"]["geometry"]["fov_eye"] is None


@pytest.mark.parametrize(
    ("keys", "value", "words"),
    [
        (("raw_eye", "Left", "tan_top"), None, "openvr.geometry.raw_eye.Left.tan_top: expected a number, got null"),
        (("raw_eye", "Left", "tan_top"), -2.0, "openvr.geometry.raw_eye.Left: .*expected down < up"),
        (("raw_eye", "Right"), [], "openvr.geometry.raw_eye.Right: expected an object"),
        (("eye2head", "Left"), [[1, 0, 0, 0]], r"openvr.geometry.eye2head: .*expected shape \(3, 4\)"),
        (("eye2head", "Left"), "up", "openvr.geometry.eye2head.Left: expected rows of numbers"),
        (("rec_rts",), [5], "openvr.geometry.rec_rts: expected 2 numbers"),
        (("rec_rts",), [0, 5], r"render_size\[0\]: expected"),
    ],
)
def test_damaged_dumps_name_the_key(tmp_path: Path, keys: tuple[str, ...], value: Any, words: str) -> None:
    content = document()
    node = content["openvr"]["geometry"]
    for key in keys[:-1]:
        node = node[key]
    node[keys[-1]] = value
    with pytest.raises(nf.FormatError, match=rf"dump\.json: .*{words}"):
        load(tmp_path, content)


def test_failed_and_missing_runtimes_are_reported(tmp_path: Path) -> None:
    content = document()
    content["openvr"] = {"error@": "no headset"}
    assert load(tmp_path, content).name == "Nobody Flat"
    with pytest.raises(nf.FormatError, match="expected geometry from openvr, found oculus, oculus_max"):
        load(tmp_path, content, runtime="openvr")
    # hmdq's mark for tangents that LibOVR reported as zero.
    content["oculus"]["geometry"]["default_fov"]["error@"] = "Geometry data are invalid"
    assert load(tmp_path, content).render_size == (1100, 1234)
    del content["oculus"]
    with pytest.raises(nf.FormatError, match=r"geometry: expected valid geometry in openvr or oculus"):
        load(tmp_path, content)
