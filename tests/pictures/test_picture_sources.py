"""The choice of source occurrences."""

from __future__ import annotations

from collections import Counter

from hypothesis import given
from hypothesis import strategies as st
from pictured import composite, facade, floor, leaf

from layoutkit.model import Region
from layoutkit.pictures.sources import sources


def test_the_input_is_its_own_source() -> None:
    source = facade()
    assert all(placed == origin for placed, origin in sources(source.root, source))


@given(
    st.integers(1, 6),
    st.lists(st.sampled_from("PB"), min_size=1, max_size=9).map("".join),
)
def test_replicas_come_whole_from_one_occurrence(floors: int, word: str) -> None:
    source = facade()
    story = floor("Floor", word)
    root = composite("Facade", "rows", *[story] * floors, leaf("Base", story.width, 2))
    origins: dict[str, set[str]] = {}
    for placed, origin in sources(root, source):
        assert placed.symbol_path == origin.symbol_path
        placed_parts, origin_parts = placed.path.split("/"), origin.path.split("/")
        for depth in range(1, len(placed_parts)):
            parent = "/".join(placed_parts[:depth])
            origins.setdefault(parent, set()).add("/".join(origin_parts[:depth]))
    assert all(len(found) == 1 for found in origins.values())


def test_occurrences_are_used_in_turn() -> None:
    source = facade()
    story = floor("Floor", "BBBBB")
    root = composite("Facade", "rows", story, leaf("Base", story.width, 2))
    used = Counter(origin.path for placed, origin in sources(root, source) if "Window" in placed.path)
    assert used == {"Facade/Floor/Bay/Window": 3, "Facade/Floor/Bay.2/Window": 2}


def test_terminals_come_in_document_order() -> None:
    source = facade()
    paths = [placed.path for placed, _ in sources(source.root, source)]
    assert paths[:3] == ["Facade/Floor/Pier", "Facade/Floor/Bay/Window", "Facade/Floor/Bay/Sill"]
    assert paths[-1] == "Facade/Base"
    assert isinstance(next(sources(source.root, source))[0].region, Region)
