"""List and selection of graphics adapters."""

from __future__ import annotations

from dataclasses import dataclass

from nearfar._base import check
from nearfar._render import backend as backends


@dataclass(frozen=True)
class Adapter:
    """A graphics adapter with one graphics interface; a card with two drivers is listed twice."""

    name: str
    """Name reported by its driver."""
    backend: str
    """Graphics interface: "vulkan", "metal", "dx12" or "gl"."""
    kind: str
    """Kind of hardware: "discrete", "integrated", "virtual", "unknown", or "software" for the processor itself."""
    driver: str
    """Driver and version."""
    usable: bool
    """Whether it has all features that nearfar needs."""
    refused: str
    """Reason why it cannot be used, such as missing features; empty if it is usable."""
    largest_binding: int
    """Maximum number of bytes that a kernel reads at a time; larger scenes and images are drawn in parts."""
    largest_image: int
    """Maximum width and height of a picture in pixels; larger ones are drawn in parts."""

    @property
    def label(self) -> str:
        """Name and interface, as in error messages."""
        return f"{self.name} ({self.backend})"

    @property
    def note(self) -> str:
        """Reason why `backend="auto"` does not use the adapter; empty if it may."""
        if not self.usable:
            return f"it can't be used: {self.refused}"
        if self.kind == "software":
            return "it is a software adapter: 'auto' uses it only if nearfar.gpu.measure found it faster"
        return ""


def adapters() -> list[Adapter]:
    """List all adapters, best first; the first usable one is the default.

    Without any, `backend="gpu"` raises `DeviceError`, which names software to install.
    """
    return [
        Adapter(name, backend, kind, driver, not refused, refused, largest_binding, largest_image)
        for name, backend, kind, driver, refused, largest_binding, largest_image in backends.adapters()
    ]


def selected() -> Adapter:
    """Open the adapter that `backend="gpu"` uses, and return its description.

    DeviceError if no adapter can be used; the message lists those found and names software to install.
    """
    label = backends.open_device().label
    return next(adapter for adapter in adapters() if adapter.label == label)


def select(adapter: str | None) -> None:
    """Select the adapter that "gpu" and "auto" use in this process from now on.

    `adapter` is its interface, such as "vulkan", or a part of its name, in upper or lower case. None selects the
    adapter that the environment variable NEARFAR_ADAPTER names in the same way, or else the best one. TypeError and
    ValueError for anything but a name or None. DeviceError if no usable adapter has the name, with a message that lists
    all adapters; the previous selection stays.
    """
    if adapter is not None:
        if not check.text("adapter", adapter).strip():
            raise ValueError("adapter: expected an interface or a part of a name, got ''; None selects the best one")
        adapter = adapter.strip()
        backends.open_device(adapter)
    backends.select(adapter)


def stats() -> dict[str, int | float]:
    """Return counters of the selected adapter since it was opened; DeviceError if no adapter can be used.

    The counters are "allocations" of buffers and textures and their "allocated_bytes", which do not grow between frames
    of one size; "uploaded_bytes", which grow by the changed data; and "triangles" in draw calls, after culling.
    Adapters with timestamp queries also have "raster_seconds" and "resolve_seconds", the GPU time of
    rasterisation and of shading, for frames whose pixels were read back.
    """
    names = ("allocations", "allocated_bytes", "uploaded_bytes", "triangles")
    device = backends.open_device()
    counted: dict[str, int | float] = dict(zip(names, device.counters(), strict=True))
    seconds = device.pass_seconds()
    return counted if seconds is None else counted | {"raster_seconds": seconds[0], "resolve_seconds": seconds[1]}
