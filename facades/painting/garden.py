"""What the terminals of the garden look like."""

from __future__ import annotations

from collections.abc import Mapping

from facades.painting.domes import (
    bastion,
    corner_tower,
    gallery,
    gate,
    kiosk,
    mausoleum,
    mosque,
    postern,
    spout,
    terrace_lawn,
    wall_pavilion,
)
from facades.painting.paving import bridge, crossing, path, stretch, terrace, wall
from facades.painting.planting import cypresses, hedge, orange, planter, rose_bed, star_bed
from facades.painting.walls import Painter
from facades.painting.waterworks import canal, channel, inflow, meeting, river, tank


def garden() -> Mapping[str, Painter]:
    """Return the painter of each terminal."""
    along, across = path(upright=False), channel(upright=False)
    return {
        "Reach": river,
        "Bastion": bastion,
        "Mosque": mosque(facing_east=True),
        "Jawab": mosque(facing_east=False),
        "Court": terrace,
        "Lawn": terrace_lawn,
        "Kiosk": kiosk,
        "Mausoleum": mausoleum,
        "Wall": wall,
        "Stretch": planter(stretch),
        "Hem": hedge,
        "Rim": hedge,
        "Star": star_bed,
        "Roses": rose_bed,
        "Orange": orange,
        "Cypress": cypresses,
        "Path": path(upright=True),
        "Channel": channel(upright=True),
        "Canal": canal(upright=True),
        "Walk/Broad": along,
        "Walk/Slim": along,
        "Walk/Path": crossing,
        "Walk/Channel": bridge(upright=False),
        "Walk/Canal": bridge(upright=False),
        "Rill/Wall": spout,
        "Rill/Broad": across,
        "Rill/Slim": across,
        "Rill/Path": bridge(upright=True),
        "Rill/Channel": meeting,
        "Rill/Canal": inflow(upright=True),
        "Cross/Wall": wall_pavilion,
        "Cross/Broad": canal(upright=False),
        "Cross/Slim": canal(upright=False),
        "Cross/Path": bridge(upright=True),
        "Cross/Channel": inflow(upright=False),
        "Cross/Canal": tank,
        "Corner": corner_tower,
        "Gallery": gallery,
        "Postern": postern,
        "Gate": gate,
    }
