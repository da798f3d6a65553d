"""Spatial optimisation (Dang et al. 2014, section 5): sizes near those of the sources, grids kept."""
