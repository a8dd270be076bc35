"""The version, by itself so that every module can state it in files."""

__version__ = "0.1.0"
