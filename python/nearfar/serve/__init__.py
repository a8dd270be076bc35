"""HTTP server of bundles, reduced scenes, and scenes whose regions are made on demand."""

from __future__ import annotations
