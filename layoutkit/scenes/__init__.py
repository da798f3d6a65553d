"""The geometry of scenes: features, the containment hierarchy, and what relates points to features."""
