"""Our own designs: valid, kept by their own input, and drawn from their documents."""

from __future__ import annotations

import numpy as np
import pytest

from facades.painting.canvas import paint
from layoutkit.constraints import BUILT_IN, Size
from layoutkit.documents import check, read
from layoutkit.model import Facade, Layout
from layoutkit.pictures import Photo, render_png
from layoutkit.samples import Sample, list_samples

KINDS = {kind.kind: kind for kind in BUILT_IN}


def design(sample: Sample) -> Facade:
    model = read(sample.path, KINDS).model
    assert isinstance(model, Facade)
    return model


pytestmark = pytest.mark.parametrize("sample", list_samples(), ids=lambda s: s.name)


def test_documents_are_faultless(sample: Sample) -> None:
    assert check(sample.path, KINDS) == []
    assert design(sample).name == sample.name


def test_the_input_keeps_its_own_constraints(sample: Sample) -> None:
    source = design(sample)
    assert Layout(sample.name, source.units, source.root, source).violations() == ()


def test_every_region_has_one_size_constraint(sample: Sample) -> None:
    """Without one, a variation could shrink it to nothing; with two, the initial sizes would compete."""
    source = design(sample)
    sized = [path for c in source.constraints if isinstance(c, Size) for path in source.select(c.of)]
    assert sorted(sized) == sorted(path for path in source.regions if path != source.root.symbol)


def test_the_picture_is_the_one_that_the_script_draws(sample: Sample) -> None:
    source = design(sample)
    photo = Photo.open(source, sample.path.parent)
    drawn = np.asarray(paint(source)).astype(int)
    # Versions of Pillow may differ by a pixel along slanted edges.
    assert np.abs(drawn - np.asarray(photo.image)).mean() < 1.0
    assert np.array_equal(np.asarray(render_png(source, photo)), np.asarray(photo.image))
