"""What adapters there are, and which one is used."""

from __future__ import annotations

from dataclasses import dataclass

from nearfar._render import backend as backends


@dataclass(frozen=True)
class Adapter:
    """A graphics adapter behind one interface; a card that has two drivers is listed twice."""

    name: str
    """As its driver calls it."""
    backend: str
    """Interface that it is reached by: "vulkan", "metal", "dx12" or "gl"."""
    kind: str
    """What executes its work: "discrete", "integrated", "virtual", "unknown", or "software" for the processor."""
    driver: str
    """Driver and version."""
    usable: bool
    """Whether it has all that is needed."""
    refused: str
    """What it lacks; empty where it is usable."""
    largest_binding: int
    """Bytes that a kernel reads at a time; larger scenes and images are drawn in parts."""
    largest_image: int
    """Pixels across that a picture may have; larger ones are drawn in parts."""

    @property
    def label(self) -> str:
        """Name and back end, as errors say it."""
        return f"{self.name} ({self.backend})"

    @property
    def note(self) -> str:
        """Why `backend="auto"` does not take it; empty where it may."""
        if not self.usable:
            return f"it can't be used: {self.refused}"
        if self.kind == "software":
            return "it is the processor itself: 'auto' takes it only where nearfar.gpu.measure found it faster"
        return ""


def adapters() -> list[Adapter]:
    """List every adapter found, in the order in which they are taken.

    Returns
    -------
    list of Adapter
        Empty where there is none; `DeviceError` of `backend="gpu"` says what to install then.
    """
    return [
        Adapter(name, backend, kind, driver, not refused, refused, largest_binding, largest_image)
        for name, backend, kind, driver, refused, largest_binding, largest_image in backends.adapters()
    ]


def selected() -> Adapter:
    """Return the adapter that `backend="gpu"` takes, opened to see that it works.

    Raises
    ------
    DeviceError
        Where no adapter can be used; says what was found and what to install.
    """
    label = backends.opened().label
    return next(adapter for adapter in adapters() if adapter.label == label)


def select(adapter: str | None) -> None:
    """Choose the adapter that "gpu" and "auto" take from now on, in this process.

    Parameters
    ----------
    adapter
        Its back end, such as "vulkan", or a part of its name, in any case. None for the one that the environment
        variable NEARFAR_ADAPTER names in the same way, or else the best one.

    Raises
    ------
    TypeError, ValueError
        For anything but a name.
    DeviceError
        Where no usable adapter has the name; says which there are. What was selected before stays.
    """
    if adapter is not None:
        if not isinstance(adapter, str):
            raise TypeError(f"adapter: expected a back end or a part of a name, got {type(adapter).__name__}")
        if not adapter.strip():
            raise ValueError("adapter: expected a back end or a part of a name, got nothing; None selects the best one")
        adapter = adapter.strip()
        backends.opened(adapter)
    backends.select(adapter)


def stats() -> dict[str, int]:
    """Count what was made on the selected adapter since it was opened.

    Returns
    -------
    dict
        "allocations" of buffers and textures and their "allocated_bytes", which do not grow from frame to frame of one
        size; "uploaded_bytes", which grow by what changes; "triangles" in draw calls, after culling.

    Raises
    ------
    DeviceError
        Where no adapter can be used.
    """
    names = ("allocations", "allocated_bytes", "uploaded_bytes", "triangles")
    return dict(zip(names, backends.opened().counters(), strict=True))
