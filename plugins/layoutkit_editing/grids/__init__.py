"""Grids: like elements, grids among them, grids alike, grids within grids."""
