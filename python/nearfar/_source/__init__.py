"""Worlds that scenes are taken from, box by box."""
