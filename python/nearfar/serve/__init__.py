"""Server of bundles, of reduced scenes, and of scenes whose regions are made on demand."""

from __future__ import annotations
