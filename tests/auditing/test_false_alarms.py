"""Facades in order: of them the audit says nothing, and in no time."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import pytest
from audited_houses import audited

from layoutkit.model import Facade
from layoutkit.samples import list_samples
from layoutkit_formats.cmp import CmpFormat
from layoutkit_relayout.inference.stage import Infer, InferOptions

DATA = Path(__file__).parents[3] / "shared" / "data" / "cmp"
#: Seconds that an audit may take by far, on any machine.
PATIENCE = 5.0


def said(facade: Facade) -> list[str]:
    start = time.perf_counter()
    found = audited(facade)
    assert time.perf_counter() - start < PATIENCE
    return [str(diagnostic) for diagnostic in found]


@pytest.mark.parametrize("sample", list_samples(), ids=lambda sample: sample.name)
def test_our_designs(sample: object) -> None:
    from layoutkit.constraints import BUILT_IN
    from layoutkit.documents import read

    facade = read(sample.path, {kind.kind: kind for kind in BUILT_IN}).model  # type: ignore[attr-defined]
    assert isinstance(facade, Facade)
    assert said(facade) == []


@pytest.mark.skipif(not DATA.exists(), reason="the CMP facades are not here")
@pytest.mark.parametrize("freedom", ["strict", "loose"])
def test_converted_facades(freedom: str) -> None:
    for file in sorted(DATA.glob("*.xml"))[:2]:
        facade, _ = CmpFormat().read(file, None)
        (outcome,) = Infer().run(facade, InferOptions(freedom=freedom))  # type: ignore[arg-type]
        assert isinstance(outcome.document, Facade)
        assert said(outcome.document) == [], file.name


@pytest.mark.nightly
@pytest.mark.skipif(not DATA.exists(), reason="the CMP facades are not here")
def test_many_converted_facades() -> None:
    for file in sorted(DATA.glob("*.xml"))[:20]:
        facade, _ = CmpFormat().read(file, None)
        assert said(facade) == [], file.name
        (outcome,) = Infer().run(facade, InferOptions())
        assert isinstance(outcome.document, Facade)
        assert said(outcome.document) == [], file.name


def test_a_facade_without_constraints() -> None:
    from layoutkit.constraints import BUILT_IN
    from layoutkit.documents import read

    for sample in list_samples():
        facade = read(sample.path, {kind.kind: kind for kind in BUILT_IN}).model
        assert isinstance(facade, Facade)
        assert said(replace(facade, constraints=())) == []
