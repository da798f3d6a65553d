"""Placement by example, measured on real scenes by the protocol of Guerrero et al. 2015, section 5."""
