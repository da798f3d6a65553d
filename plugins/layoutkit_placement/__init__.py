"""Placement by example: one pose propagated, or shape placements learned from several (Guerrero et al.)."""
