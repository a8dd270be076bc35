"""Encodes textures as separate files, to which GLB files refer."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
from numpy.typing import NDArray


def encode_texture(texels: NDArray[np.uint8], quality: int | None) -> bytes:
    """Encode a texture (H, W, 4), sRGB with alpha, as WebP; `quality` 0 to 100, or None for lossless."""
    from PIL import Image

    opaque = bool((texels[..., 3] == 255).all())
    settings: dict[str, Any] = {"lossless": True, "exact": True} if quality is None else {"quality": quality}
    file = io.BytesIO()
    Image.fromarray(texels[..., :3] if opaque else texels).save(file, "webp", method=4, **settings)
    return file.getvalue()
