"""Policies that every stage keeps: argument checks, errors, files and formats, cache, progress, random numbers."""
