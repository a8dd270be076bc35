"""Readers of cities: CityJSON by its surfaces, and outlines of buildings with heights, extruded."""
