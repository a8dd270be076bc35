"""Procedural scenes: deterministic, from thousands to tens of millions of triangles."""

from nearfar.datasets._city import city, street_view

__all__ = ["city", "street_view"]
