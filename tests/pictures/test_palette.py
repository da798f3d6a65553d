"""Colours of labels."""

from __future__ import annotations

from pictured import leaf

from layoutkit.pictures.palette import PALETTE, PLAIN, colour_of


def test_well_known_labels_come_first() -> None:
    assert colour_of(leaf("A", 1, 1, labels="Mine Window")) == PALETTE["window"]
    assert colour_of(leaf("A", 1, 1, labels="WALL")) == colour_of(leaf("B", 1, 1, labels="facade"))


def test_other_labels_have_fixed_colours_of_their_own() -> None:
    assert colour_of(leaf("A", 1, 1, labels="Gargoyle")) == (94, 186, 175)
    others = {colour_of(leaf("A", 1, 1, labels=f"Kind{i}")) for i in range(50)}
    assert len(others) > 45


def test_regions_without_labels_are_plain() -> None:
    assert colour_of(leaf("A", 1, 1)) == PLAIN
