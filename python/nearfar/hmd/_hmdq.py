"""Reads and writes headset geometry in the format of hmdq and its viewer hmdv (github.com/risa2000/hmdq, version 5)."""

from __future__ import annotations

import math
from datetime import datetime
from pathlib import Path
from typing import Any

from nearfar._base import formats
from nearfar._base.errors import FormatError
from nearfar._base.version import __version__
from nearfar._camera.camera import Fov
from nearfar.hmd._eye import Eye, total_fov
from nearfar.hmd._file import Reader, finite

RUNTIMES = ("openvr", "oculus", "oculus_max")
"""Runtimes whose geometry a file may contain; oculus_max is Oculus with its maximum instead of its default view."""
SIDES = {"left": "Left", "right": "Right"}
"""hmdq's names of the eyes."""
TANGENTS = ("tan_left", "tan_right", "tan_bottom", "tan_top")
"""Keys of the tangents of a field of view."""
HMDQ_VERSION, OUTPUT_VERSION = "2.2.1", 5
"""Version of hmdq whose format is written, and version of that format; hmdv converts files of older versions."""
HEADSET = 1
"""OpenVR's device class of headsets."""
NAMES = (
    ("Prop_ManufacturerName_String", "Prop_ModelNumber_String"),
    ("Prop_Manufacturer_String", "Prop_ProductName_String"),
)
"""Keys of manufacturer and model, of OpenVR and of Oculus."""
REFRESH = ("Prop_DisplayFrequency_Float", "Prop_DisplayRefreshRate_Float")
"""Keys of the refresh rate in hertz."""


def is_hmdq(content: dict[str, Any]) -> bool:
    """Return whether a document has hmdq's version in its section `misc`."""
    misc = content.get("misc")
    return isinstance(misc, dict) and ("hmdq_ver" in misc or "hmdv_ver" in misc)


def fields(content: dict[str, Any], where: str, runtime: str | None) -> dict[str, Any]:
    """Return a headset's fields by name from the data of a runtime; None means the first one with valid geometry."""
    geometries = {name: reader for name in RUNTIMES if (reader := _geometry(content, where, name)) is not None}
    if not geometries:
        raise FormatError(f"{where}: geometry: expected valid geometry in openvr or oculus, got none")
    if runtime is not None and runtime not in geometries:
        raise FormatError(f"{where}: expected geometry from {runtime}, found {', '.join(geometries)}")
    runtime = runtime or next(iter(geometries))
    read = geometries[runtime]
    # File names may contain bytes that are not text, which Python stores as lone surrogates.
    file = Path(where.encode("utf-8", "replace").decode("utf-8"))
    name, refresh = _device(content, runtime)
    misc = content["misc"]
    version = misc.get("hmdq_ver", misc.get("hmdv_ver"))
    return {side: _eye(read, key) for side, key in SIDES.items()} | {
        "name": name or file.stem,
        "render_size": read.pair("rec_rts"),
        "refresh_hz": refresh,
        "hidden_area_percent": _hidden(read),
        "sources": (f"{file.name}: {runtime} by hmdq {version}, {misc.get('time', 'at no known time')}",),
    }


def write(path: Path, fields: dict[str, Any]) -> None:
    """Write the geometry of a headset and the angles that hmdv shows."""
    left, right = fields["left"], fields["right"]
    eyes, total = {"Left": left, "Right": right}, total_fov(left, right)
    canted = any(eye.orientation != (0.0, 0.0, 0.0, 1.0) for eye in eyes.values())
    geometry = {
        "rec_rts": fields["render_size"],
        "raw_eye": {name: _tangents(eye.fov) for name, eye in eyes.items()},
        "eye2head": {name: eye.matrix.tolist() for name, eye in eyes.items()},
        "view_geom": {
            "left_rot": left.rotation_deg,
            "right_rot": right.rotation_deg,
            "ipd": sum((a - b) ** 2 for a, b in zip(left.position, right.position, strict=True)) ** 0.5,
        },
        # hmdv expects angles in the eyes' axes for both eyes or for neither.
        "fov_eye": {name: _angles(Eye(eye.fov, eye.position)) for name, eye in eyes.items()} if canted else None,
        "fov_head": {name: _angles(eye) for name, eye in eyes.items()},
        "fov_tot": {
            "fov_hor": total.horizontal_deg,
            "fov_ver": total.vertical_deg,
            "fov_diag": total.diagonal_deg,
            "overlap": total.overlap_deg,
        },
        "ham_mesh": {"Left": None, "Right": None},
    }
    properties: dict[str, Any] = {"Prop_DeviceClass_Int32": HEADSET, NAMES[0][1]: fields["name"]}
    if fields["refresh_hz"] is not None:
        properties[REFRESH[0]] = fields["refresh_hz"]
    misc = {
        "time": datetime.now().strftime("%Y-%m-%d %H:%M:%S"),
        "hmdq_ver": HMDQ_VERSION,
        "log_ver": OUTPUT_VERSION,
        "os_ver": "n/a",
        "generator": f"nearfar {__version__}",
    }
    runtime = {"rt_path": "n/a", "rt_ver": "n/a", "devices": [[0, HEADSET]], "properties": {"0": properties}}
    formats.write_json(path, {"misc": misc, "openvr": runtime | {"geometry": geometry}})


def _geometry(content: dict[str, Any], where: str, runtime: str) -> Reader | None:
    """Return a reader of a runtime's geometry; None if it is missing or has an error."""
    if runtime == "openvr":
        # Before hmdq 1.3.4, files had only OpenVR's data, at the top level.
        keys = ["geometry"] if "geometry" in content else ["openvr", "geometry"]
    else:
        keys = ["oculus", "geometry", "default_fov" if runtime == "oculus" else "max_fov"]
    node: Any = content
    for key in keys:
        node = node.get(key) if isinstance(node, dict) else None
    if not isinstance(node, dict) or "error@" in node:
        return None
    return Reader(node, where, ".".join(keys))


def _eye(read: Reader, key: str) -> Eye:
    fov = read.object_at("raw_eye").object_at(key).fov(TANGENTS)
    if "eye2head" in read.content:
        matrices = read.object_at("eye2head")
        rows = matrices.rows(key)
        return matrices.convert(lambda: Eye.from_matrix(fov, rows))
    # Raw data of LibOVR, without the computed matrix.
    return read.object_at("render_desc").object_at(key).object_at("hmd2eye_pose").eye(fov)


def _device(content: dict[str, Any], runtime: str) -> tuple[str, float | None]:
    """Return name and refresh rate in hertz from a runtime's properties; "" and None if they are missing."""
    section = content.get(runtime.removesuffix("_max"))
    listed = (section if isinstance(section, dict) else content).get("properties")
    devices = list(listed.values()) if isinstance(listed, dict) else []
    for device in (device for device in devices if isinstance(device, dict)):
        if device.get("Prop_DeviceClass_Int32", HEADSET) != HEADSET:
            continue
        for keys in NAMES:
            words = [device[key] for key in keys if isinstance(device.get(key), str)]
            # A rate of 0 means unknown.
            rates = [rate for key in REFRESH if (rate := finite(device.get(key))) is not None and rate > 0.0]
            if words:
                return " ".join(words), rates[0] if rates else None
    return "", None


def _hidden(read: Reader) -> float | None:
    """Return the percentage of a view that the hidden-area mesh covers, the mean of both eyes; None without meshes."""
    meshes = read.content.get("ham_mesh")
    listed = meshes.values() if isinstance(meshes, dict) else []
    areas = [finite(mesh.get("ham_area")) for mesh in listed if isinstance(mesh, dict)]
    percentages = [area for area in areas if area is not None]
    return 100.0 * sum(percentages) / len(percentages) if percentages else None


def _tangents(fov: Fov) -> dict[str, float]:
    aspect = (fov.right - fov.left) / (fov.up - fov.down)
    return dict(zip(TANGENTS, fov._sides, strict=True)) | {"aspect": aspect}


def _angles(eye: Eye) -> dict[str, Any]:
    left, right, down, up = eye.angles_deg
    sides = {"deg_left": left, "deg_right": right, "deg_bottom": down, "deg_top": up}
    return {"fov_pts": _points(eye)} | sides | {"deg_hor": right - left, "deg_ver": up - down}


def _points(eye: Eye) -> list[list[float]]:
    """Return eight points of a view's edge at depth 1: each corner, then a middle (below, right, above, left)."""
    # For each edge the tangent of its angle, and z: −1 ahead of the eye, 1 behind it.
    left, right, down, up = (
        (math.sin(angle) / abs(math.cos(angle)), -math.copysign(1.0, math.cos(angle)))
        for angle in map(math.radians, eye.angles_deg)
    )
    middles = [[0.0, *down], [right[0], 0.0, right[1]], [0.0, *up], [left[0], 0.0, left[1]]]
    corners = [(corner / abs(corner[2])).tolist() for corner in eye.corners]
    return [point for pair in zip(corners, middles, strict=True) for point in pair]
