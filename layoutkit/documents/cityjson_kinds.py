"""What bodies, surfaces and openings are in CityJSON, by their labels and by what they stand on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from layoutkit.model.world import Body, World

BUILDING, PART, INSTALLATION = "Building", "BuildingPart", "BuildingInstallation"

#: Of bodies without any of the words below that neither have openings nor stand on a building.
OTHER = "GenericCityObject"


def _words(*lines: str) -> frozenset[str]:
    return frozenset(" ".join(lines).split())


#: Labels, in lower case, by the type that bodies with them have; the first type that fits counts.
BODY_WORDS: Mapping[str, frozenset[str]] = {
    "SolitaryVegetationObject": _words(
        "tree trunk crown hedge bush shrub plant flower flowers grass vine conifer palm"
    ),
    INSTALLATION: _words(
        "chimney dormer balcony porch stairs steps ramp antenna canopy awning railing parapet"
    ),
    BUILDING: _words(
        "building house tower garage shed barn hall church villa block skyscraper hut cabin greenhouse",
        "pavilion annex annexe wing core podium apartment apartments office school store factory",
    ),
    "CityFurniture": _words(
        "bench table chair armchair sofa couch bed desk cupboard cabinet shelf wardrobe dresser counter",
        "fridge refrigerator stove oven cooker sink toilet bath bathtub shower washbasin lamp fountain",
        "statue fence bin bollard furniture planter television tv rug stool island",
    ),
}

#: Labels of ground, in lower case, that make it a road; all other ground is land use.
ROAD_WORDS = _words("street road lane path way alley avenue drive sidewalk pavement crossing")

#: Labels of a body's surfaces, in lower case, by what those are; others are walls.
SURFACE_WORDS: Mapping[str, frozenset[str]] = {
    "RoofSurface": _words("top roof"),
    "GroundSurface": _words("base"),
}

#: Labels of openings, in lower case, by what those are; others belong to the surface that they lie on.
OPENING_WORDS: Mapping[str, frozenset[str]] = {
    "Window": frozenset(["window", "shop", "shopwindow", "skylight", "rooflight", "glazing", "pane"]),
    "Door": frozenset(["door", "gate", "entrance", "frontdoor", "garagedoor", "doorway", "portal"]),
}


@dataclass(frozen=True, slots=True)
class Kind:
    """What a body is.

    Attributes
    ----------
    type
        A type of city objects.
    parent
        The name of the building, or part of one, that it belongs to; empty: to none.
    """

    type: str
    parent: str = ""


def kinds(world: World) -> dict[str, Kind]:
    """Return what each body is, by name.

    A body is what its labels say. Without such a label, it is a building if it has openings and stands on
    the ground, on a building or on nothing, and an installation if it stands on a building. A building that
    stands on another is a part of that.
    """
    found: dict[str, Kind] = {}
    for body in world.bodies:
        found[body.name] = _kind(body, found)
    return found


def ground_type(labels: Sequence[str]) -> str:
    """Return what a polygon of the ground is."""
    return "Road" if ROAD_WORDS & _said(labels) else "LandUse"


def surface_type(labels: Sequence[str]) -> str:
    """Return what a surface of a building is."""
    return _first(SURFACE_WORDS, labels) or "WallSurface"


def opening_type(labels: Sequence[str]) -> str:
    """Return what an opening is; empty: it belongs to its surface."""
    return _first(OPENING_WORDS, labels)


def _kind(body: Body, found: Mapping[str, Kind]) -> Kind:
    below = found.get(body.parent)
    carrier = "" if below is None else body.parent if below.type in (BUILDING, PART) else below.parent
    said = _first(BODY_WORDS, body.labels)
    if not said and body.openings and (below is None or carrier):
        said = BUILDING
    if said == BUILDING and carrier:
        return Kind(PART, found[carrier].parent or carrier)
    if said not in ("", INSTALLATION):
        return Kind(said)
    return Kind(INSTALLATION, carrier) if carrier else Kind(OTHER)


def _first(table: Mapping[str, frozenset[str]], labels: Sequence[str]) -> str:
    return next((name for name, own in table.items() if own & _said(labels)), "")


def _said(labels: Sequence[str]) -> set[str]:
    return {label.lower() for label in labels}
