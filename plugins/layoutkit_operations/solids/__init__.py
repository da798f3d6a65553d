"""Solids: prisms with caps and roofs, Booleans, and the planar surfaces found on them."""
