"""What regions are, by their labels, or by their symbols where they have none."""

from __future__ import annotations

from layoutkit.model import Region

#: Labels of places in the hierarchy. With another label beside them, they do not say what is shown there.
ROLES = frozenset({"Facade", "Building", "Floor", "Bay", "Pier"})
#: What is stretched, cut and covered: the ground that elements stand on, never an element.
GROUND = frozenset({"Wall", "Pier", "Background", "Sky", "Roof", "Space", "Facade", "Building", "Floor"})
#: How much people mean to edit what has a label, from 0 to 1; of what is not named here, `UNKNOWN`.
WORTH = {
    "Window": 1.0,
    "Door": 0.95,
    "Shop": 0.85,
    "Balcony": 0.75,
    "Bay": 0.5,
    "Pillar": 0.6,
    "Deco": 0.5,
    "Blind": 0.5,
    "Sill": 0.5,
    "Base": 0.25,
    "Cornice": 0.25,
    "Molding": 0.25,
}
UNKNOWN = 0.7
#: How much so of a composite without a label, against the worthiest of what is inside.
FRAMED = 0.8


def name_of(region: Region) -> str:
    """Return what a region is: its labels, or its symbol without a number; nothing for other composites."""
    shown = sorted(set(region.labels) - ROLES) or sorted(region.labels)
    if shown or not region.terminal:
        return " ".join(shown)
    return region.symbol.rstrip("0123456789_") or region.symbol


def worth_of(name: str) -> float:
    """Return how much people mean to edit what goes by a name; 0 for what is no element."""
    labels = set(name.split())
    if not labels or labels & GROUND:
        return 0.0
    return max(WORTH.get(label, UNKNOWN) for label in labels)
