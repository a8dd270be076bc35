"""Readers of cities: surfaces of CityJSON, and footprints of buildings extruded by their heights."""
