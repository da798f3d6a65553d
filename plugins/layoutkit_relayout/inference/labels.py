"""The labels that inference goes by, all in one place."""

from __future__ import annotations

from layoutkit.model import Region

#: A floor, and the columns it is made of: bays with elements, and the space between them.
FLOOR, BAY, PIER = "Floor", "Bay", "Pier"
#: Labels of space that may be stretched; of rooms for other things.
WALLS = frozenset({"Wall", PIER, "Background", "Sky", "Roof"})
ROOMS = frozenset({"Facade", "Building", FLOOR})
#: Labels of elements that look wrong when they are stretched.
HARD = frozenset({"Window", "Door", "Shop", "Blind", "Balcony", "Deco", "Pillar"})
#: Labels of what runs along a facade, at any length.
BANDS = frozenset({"Cornice", "Molding"})
#: Labels of what belongs on the ground: a floor that has it stays where it is.
GROUNDED = frozenset({"Door", "Shop"})
#: Labels of what is not the house: a floor that has it is at its edge, and stays too.
OUTSIDE = frozenset({"Background", "Sky"})


def labels_in(region: Region) -> frozenset[str]:
    """Return all labels in a region, its own among them."""
    return frozenset(region.labels).union(*(labels_in(child) for child in region.children))
