"""The models exported by other programs, with each one's settings."""

from __future__ import annotations

from tests.support.exporters import FLAT, GREY, PAINTED, Case

_BITS = ("-vp", "16", "-vt", "16", "-vn", "16")
_FINE = "16 bits"
_DIGITS = ("-vpf", *_BITS)
_DRACO = {"quantizationBits": {"POSITION": 20, "NORMAL": 16, "TEX_COORD": 18, "COLOR": 10, "GENERIC": 12}}
_EDGES, _ROWS = ["draco", {"method": 1, **_DRACO}], ["draco", {"method": 0, **_DRACO}]
_QUANTIZE = ["quantize", {"quantizePosition": 16, "quantizeNormal": 16, "quantizeTexcoord": 16}]
_ORDER, _MESHOPT, _FILTERS = ["reorder", {}], ["meshopt", {"method": "quantize"}], ["meshopt", {"method": "filter"}]
_WEBP = ["webp", {"lossless": True, "effort": 0, "slots": "baseColor"}]
_JOIN = [["dedup", {}], ["flatten", {}], ["join", {}], ["weld", {}], ["prune", {}]]
_Z = {"up": "z"}
_TURNED = {"up": "-z"}
"""Blender treats the scans' y axis as horizontal, and rotates their z axis to y."""

CASES: dict[str, list[Case]] = {
    "gltfpack": [
        Case("Duck", "-noq", "duck-1.glb", ("-noq",)),
        Case("Duck", _FINE, "duck-2.glb", _BITS),
        Case("Duck", f"-c, {_FINE}", "duck-3.glb", ("-c", *_BITS)),
        Case("Duck", f"-cz, {_FINE}", "duck-4.glb", ("-cz", *_BITS)),
        Case("Duck", f"-cc -ce khr, {_FINE}", "duck-5.glb", ("-cc", "-ce", "khr", *_BITS)),
        Case("Duck", f"-c -vpn -vi, {_FINE}", "duck-6.glb", ("-c", "-vpn", "-vi", *_BITS)),
        Case("ducks", f"-cc -mi, {_FINE}", "ducks.glb", ("-cc", "-mi", *_BITS)),
        Case("FlightHelmet", "-noq", "helmet-1.gltf", ("-noq",)),
        Case("FlightHelmet", f"-cc, {_FINE}", "helmet-2.glb", ("-cc", *_BITS)),
        Case("garage", f"-c -cf, {_FINE}", "garage-1.glb", ("-c", "-cf", *_BITS)),
        Case("garage", f"-cc -kn -km, {_FINE}", "garage-2.glb", ("-cc", "-kn", "-km", *_BITS)),
        Case("armadillo", f"-cc, {_FINE}", "armadillo.glb", ("-cc", *_BITS)),
        Case("Manhattan", "-noq", "manhattan-1.glb", ("-noq",)),
        Case("Manhattan", "-c -noq", "manhattan-2.glb", ("-c", "-noq")),
        Case("Tokyo", f"-vpf, {_FINE}", "tokyo.glb", _DIGITS),
    ],
    "glTF-Transform": [
        Case("Duck", "quantize to 16 bits", "duck-1.glb", [_QUANTIZE]),
        Case("Duck", "draco, edgebreaker", "duck-2.glb", [_EDGES]),
        Case("Duck", "draco, sequential", "duck-3.gltf", [_ROWS]),
        Case("Duck", "meshopt", "duck-4.glb", [_ORDER, _MESHOPT]),
        Case("Duck", "lossless WebP", "duck-5.glb", [_WEBP]),
        Case("Duck", "unweld", "duck-6.glb", [["unweld", {}]]),
        Case("ducks", "instance", "ducks.glb", [["instance", {"min": 2}]]),
        Case("FlightHelmet", "meshopt with filters", "helmet-1.glb", [_ORDER, _QUANTIZE, _FILTERS]),
        Case("FlightHelmet", "draco, edgebreaker", "helmet-2.glb", [_EDGES]),
        Case("FlightHelmet", "lossless WebP", "helmet-3.glb", [_WEBP]),
        Case("garage", "draco, edgebreaker", "garage-1.glb", [_EDGES]),
        Case("garage", "meshopt with filters", "garage-2.gltf", [_ORDER, _QUANTIZE, _FILTERS]),
        Case("garage", "flatten, join, weld", "garage-3.glb", _JOIN),
        Case("Manhattan", "quantize to 16 bits", "manhattan-1.glb", [_QUANTIZE]),
        Case("Manhattan", "flatten, join, weld", "manhattan-2.glb", _JOIN),
        Case("Tokyo", "meshopt", "tokyo.glb", [_MESHOPT]),
    ],
    "Blender": [
        Case("Duck", "GLB", "duck.glb"),
        Case("Duck", "glTF", "duck.gltf"),
        Case("Duck", "OBJ", "duck.obj", compared=GREY),
        Case("Duck", "PLY", "duck.ply", compared=FLAT, load=_Z),
        Case("FlightHelmet", "GLB", "helmet.glb"),
        Case("FlightHelmet", "OBJ", "helmet.obj", {"path_mode": "STRIP"}),
        Case("FlightHelmet", "STL", "helmet.stl", compared=FLAT, load=_Z),
        Case("garage", "GLB", "garage.glb"),
        Case("garage", "OBJ", "garage.obj", compared=GREY),
        Case("armadillo", "glTF", "armadillo.gltf"),
        Case("bunny", "GLB", "bunny.glb", load=_TURNED),
        Case("bunny", "PLY", "bunny.ply", compared=FLAT),
        Case("dragon", "GLB", "dragon.glb", load=_TURNED),
        Case("dragon", "STL", "dragon.stl", compared=FLAT),
        Case("Manhattan", "GLB", "manhattan.glb"),
    ],
    "Assimp": [
        Case("Duck", "GLB", "duck.glb", "glb2"),
        Case("Duck", "glTF", "duck.gltf", "gltf2"),
        Case("Duck", "OBJ", "duck.obj", "obj", GREY),
        Case("FlightHelmet", "glTF", "helmet.gltf", "gltf2"),
        Case("FlightHelmet", "OBJ", "helmet.obj", "obj"),
        Case("FlightHelmet", "binary PLY", "helmet.ply", "plyb", GREY),
        Case("garage", "GLB", "garage.glb", "glb2"),
        Case("garage", "OBJ", "garage.obj", "obj", GREY),
        Case("garage", "STL", "garage.stl", "stl", FLAT),
        Case("armadillo", "PLY", "armadillo.ply", "ply", GREY),
        Case("bunny", "GLB", "bunny.glb", "glb2", GREY),
        Case("dragon", "binary STL", "dragon.stl", "stlb", FLAT),
        Case("Manhattan", "GLB", "manhattan.glb", "glb2", GREY),
        Case("Tokyo", "OBJ", "tokyo.obj", "obj", FLAT),
        Case("Tokyo", "binary PLY", "tokyo.ply", "plyb", GREY),
    ],
    "trimesh": [
        Case("Duck", "GLB", "duck.glb"),
        Case("Duck", "OBJ", "duck/duck.obj", compared=PAINTED),
        Case("FlightHelmet", "GLB", "helmet.glb"),
        Case("FlightHelmet", "OBJ", "helmet/helmet.obj", compared=PAINTED),
        Case("garage", "glTF", "garage/garage.gltf"),
        Case("garage", "STL", "garage.stl", compared=FLAT),
        Case("armadillo", "OBJ", "armadillo/armadillo.obj"),
        Case("armadillo", "GLB", "armadillo.glb"),
        Case("bunny", "PLY", "bunny.ply"),
        Case("dragon", "OFF", "dragon.off"),
        Case("dragon", "GLB", "dragon.glb"),
        Case("Manhattan", "GLB", "manhattan.glb"),
        Case("Manhattan", "OBJ", "manhattan/manhattan.obj"),
        Case("Tokyo", "GLB", "tokyo.glb"),
    ],
}
"""Models whose pictures are compared with the plain files'."""

DEFAULTS = [
    Case("Duck", "-c", "duck.glb", ("-c",)),
    Case("FlightHelmet", "-c", "helmet.glb", ("-c",)),
    Case("armadillo", "-cc", "armadillo.glb", ("-cc",)),
    Case("Manhattan", "-cc -vpf", "manhattan.glb", ("-cc", "-vpf")),
    Case("Tokyo", "-cc", "tokyo.glb", ("-cc",)),
]
"""Models that gltfpack quantises so coarsely that the picture changes: glTF-Transform reads them, too."""
