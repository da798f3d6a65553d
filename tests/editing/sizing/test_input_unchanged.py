"""A facade as it is has its own sizes: no alignment, no likeness of its grids moves anything."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from editing.random_facades import labelled_lattices, states
from hypothesis import given

from layoutkit.constraints import BUILT_IN
from layoutkit.documents import read
from layoutkit.model import Facade
from layoutkit_editing.original import Original
from layoutkit_editing.sizing.solving import Sized, sized
from layoutkit_editing.state import State
from layoutkit_editing.tree import Tree
from layoutkit_formats.cmp import CmpFormat

ROOT = Path(__file__).parents[3]
CMP = ROOT.parent / "shared" / "data" / "cmp"


def unchanged(state: State) -> None:
    found = sized(state)

    assert isinstance(found, Sized)
    assert found.distortion < 1e-9
    assert np.abs(found.spans - state.original.spans).max() <= state.original.tolerance
    assert found.ids == tuple(range(len(state.original.places)))


def gridded(facade: Facade) -> State:
    original = Original(facade)
    return State(original, Tree.of(original), labelled_lattices(original))


@given(states())
def test_random_facades(state: State) -> None:
    unchanged(state)


@pytest.mark.parametrize("file", sorted((ROOT / "facades").glob("*/facade.xml")), ids=lambda f: f.parent.name)
def test_our_designs(file: Path) -> None:
    document = read(file, {kind.kind: kind for kind in BUILT_IN}).model
    assert isinstance(document, Facade)

    unchanged(gridded(document))


@pytest.mark.skipif(not CMP.is_dir(), reason="the CMP facades are not beside the project")
@pytest.mark.parametrize("name", ["b0012", "b0033", "b0055", "b0246", "b0323"])
def test_converted_annotations(name: str) -> None:
    facade, _ = CmpFormat().read(CMP / f"cmp_{name}.xml", None)

    unchanged(gridded(facade))
