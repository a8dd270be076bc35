"""Parts of the sources in each language, and the parts that each uses: files, or folders with all that is in them.

Rows are in the order of the data flow, and a part uses only earlier ones. A row is a decision: a test fails for a
part without one, for a use that a row does not list, and for a listed use that does not exist.
"""

from __future__ import annotations

CORE: dict[str, set[str]] = {
    "base": set(),
    "bvh": {"base"},
    "scene": {"base", "bvh"},
    "camera": {"base"},
    "cubemap": {"base", "camera"},
    "trace": {"base", "bvh", "scene"},
    "partition": {"base", "scene"},
    "morph": {"base"},
    "bend": {"base", "morph"},
    "tessellate": {"base", "scene", "morph"},
    "render": {"base", "scene", "camera", "cubemap", "trace", "partition", "morph", "bend", "tessellate"},
    "impostor": {"base", "scene", "camera", "cubemap", "trace", "partition", "render"},
    "stereo": {"base", "scene", "camera", "trace", "render"},
    "export": {"base", "scene"},
    "exr": {"base"},
    "metrics": {"base", "camera"},
    "bounds": {"base"},
    "lens": {"base", "camera", "bounds"},
    "lod": {"base", "camera", "trace", "bounds", "lens"},
    "orthoview": {"base", "scene", "camera", "trace", "render", "lod"},
}
"""Stages of the core crate, in the order of lib.rs."""

GPU: dict[str, set[str]] = {
    "device": set(),
    "upload": {"device"},
    "draw": {"device", "upload"},
    "render": {"device", "upload", "draw"},
    "compute": {"device", "draw"},
    "splat": {"compute", "device", "draw"},
}
"""Modules of the GPU crate, in the order of lib.rs. A device stores state by type, so that it depends on none of the
modules that define it. Of other crates it uses only the core."""

SERVE: dict[str, set[str]] = {
    "clients": set(),
    "log": set(),
    "file": set(),
    "gzip": set(),
    "tls": set(),
    "demand": {"file"},
    "site": {"demand", "file", "gzip"},
    "respond": {"gzip", "site"},
    "regions": {"clients", "demand", "file", "respond", "site"},
    "webtransport": {"clients"},
    "rooms": {"clients", "respond", "webtransport"},
    "metrics": {"demand", "rooms", "site"},
    "offer": {"rooms", "tls"},
    "router": {"metrics", "offer", "gzip", "regions", "respond", "rooms", "site"},
    "record": {"router"},
    "connection": {"clients", "record", "respond", "rooms", "router"},
    "quic": {"clients", "connection", "offer", "rooms", "router", "tls", "webtransport"},
    "server": {"clients", "connection", "offer", "quic", "rooms", "router", "tls"},
}
"""Modules of the server, in the order of lib.rs; it uses no other crate of the project."""

PACKAGE: dict[str, set[str]] = {
    "_base": set(),
    "_camera": {"_base"},
    "_scene": {"_base", "_camera"},
    "_source": {"_base", "_scene"},
    "datasets": {"_base", "_scene"},
    "_cubemap": {"_base"},
    "_trace": {"_base", "_scene"},
    "_partition": {"_base", "_scene"},
    "_morph": {"_base"},
    "_bend": {"_base", "_morph"},
    "_tessellate": {"_base", "_camera", "_scene"},
    "_bounds": {"_base"},
    "_render": {"_base", "_camera", "_cubemap", "_scene"},
    "metrics": {"_base", "_camera", "_render"},
    "_impostor": {"_base", "_partition", "_scene", "_trace"},
    "_reduce": {
        "_base",
        "_bend",
        "_camera",
        "_cubemap",
        "_impostor",
        "metrics",
        "_morph",
        "_partition",
        "_render",
        "_scene",
        "_trace",
    },
    "_lens": {"_base", "_camera", "_render"},
    "hmd": {"_base", "_camera", "_lens", "_render"},
    "stereo": {"_base", "_camera", "metrics", "_render", "_scene", "hmd"},
    "gpu": {"_base", "_camera", "_cubemap", "metrics", "_morph", "_render"},
    "lod": {"_base", "_bounds", "_camera", "_lens", "metrics", "_render", "_scene", "hmd"},
    "stream": {"_base", "_camera", "_cubemap", "metrics", "_partition", "_reduce", "_render", "_scene", "_trace"},
    "orthoview": {"_base", "_camera", "_cubemap", "_reduce", "_render", "_scene", "_source", "_trace", "lod", "stream"},
    "view": {"_base", "_camera", "_cubemap", "_partition", "_reduce", "_scene", "orthoview", "stream"},
    "serve": {"_base", "_scene", "_trace", "stream", "view"},
    "cli": {
        "_base",
        "_bend",
        "_camera",
        "_impostor",
        "metrics",
        "_partition",
        "_reduce",
        "_render",
        "_scene",
        "_source",
        "_trace",
        "datasets",
        "gpu",
        "hmd",
        "lod",
        "orthoview",
        "serve",
        "stereo",
        "stream",
        "view",
    },
    "__init__": {"_render", "view"},
}
"""Stages of the Python package, and the package itself, which combines early stages with late ones."""

WEB: dict[str, set[str]] = {
    "base": set(),
    "shaders": set(),
    "control": set(),
    "bundle": {"base"},
    "decode": {"base", "bundle"},
    "show": {"base", "bundle", "control", "decode", "shaders"},
    "demand": {"base", "bundle", "control", "show"},
    "opened": {"bundle", "control", "demand", "show"},
    "xr": {"control", "show"},
    "ui": {"base", "control", "demand"},
    "rooms": {"base", "bundle", "control", "shaders", "show", "ui", "xr"},
    "peers": {"base", "bundle", "rooms"},
    "room": {"bundle", "control", "peers", "rooms", "show", "ui", "xr"},
    "collect": {"bundle", "control", "room", "rooms", "shaders", "show", "ui"},
    "widget": {"base", "bundle", "control", "show"},
    "page": {"base", "bundle", "collect", "control", "decode", "opened", "room", "show", "ui", "xr"},
    "orthoview/store": {"base"},
    "orthoview/decode": {"base", "decode", "orthoview/store"},
    "orthoview/cut": {"orthoview/store"},
    "orthoview/draw": {"decode", "orthoview/cut", "orthoview/decode", "orthoview/store", "shaders"},
    "orthoview/show": {"base", "orthoview/cut", "orthoview/decode", "orthoview/draw", "orthoview/store"},
    "orthoview": {
        "base",
        "control",
        "orthoview/cut",
        "orthoview/decode",
        "orthoview/draw",
        "orthoview/show",
        "orthoview/store",
        "show",
        "ui",
    },
}
"""Folders and single files of the page, and those of the page of trees."""

TABLES = {
    "rust/core/src": CORE,
    "rust/gpu/src": GPU,
    "rust/serve/src": SERVE,
    "python/nearfar": PACKAGE,
    "web/src": WEB,
}
