"""Variations: the same for the same seed, checked, and with an honest status where there is none."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest
from grown import grown
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints import BUILT_IN, Frequency, Size
from layoutkit.constraints.generators import framed, sequences
from layoutkit.documents import layout_bytes, read
from layoutkit.hooks.specs import Outcome
from layoutkit.model import Facade, Layout, Measure, Region, RegionSet, place
from layoutkit.samples import sample_path
from layoutkit_relayout.inference.stage import Infer, InferOptions
from layoutkit_relayout.stage import Relayout, RelayoutOptions
from layoutkit_relayout.words import groups
from layoutkit_relayout.words.machine import build

KINDS = {kind.kind: kind for kind in BUILT_IN}
SHARES = st.sampled_from([0.6, 0.8, 1.0, 1.2, 1.7])


def share(value: float) -> Measure:
    return Measure(value, relative=True)


def made(facade: Facade, **options: object) -> list[Outcome]:
    return list(Relayout().run(facade, RelayoutOptions(**options)))  # type: ignore[arg-type]


def documents(outcomes: Sequence[Outcome]) -> list[bytes]:
    assert all(isinstance(o.document, Layout) for o in outcomes)
    return [layout_bytes(replace(o.document, facade_file="f.xml")) for o in outcomes]  # type: ignore[type-var]


@pytest.fixture(scope="module")
def palace() -> Facade:
    document = read(sample_path("palace"), KINDS).model
    assert isinstance(document, Facade)
    (outcome,) = Infer().run(document, InferOptions())
    assert isinstance(outcome.document, Facade)
    return outcome.document


def test_the_same_seed_gives_the_same_bytes(palace: Facade) -> None:
    first = documents(made(palace, count=4, seed=5, width=share(1.3)))
    assert documents(made(palace, count=4, seed=5, width=share(1.3))) == first
    assert len(set(first)) == 4


def test_other_seeds_give_others(palace: Facade) -> None:
    roots = [o.document.root for seed in (1, 2, 3) for o in made(palace, count=2, seed=seed)]  # type: ignore[union-attr]
    assert len(set(roots)) == 6


def test_a_variation_is_the_same_alone_and_in_a_batch(palace: Facade) -> None:
    batch = documents(made(palace, count=5, seed=3, width=share(1.3)))
    for index in (4, 2, 0):
        assert documents(made(palace, count=1, first=index, seed=3, width=share(1.3))) == [batch[index]]


def test_neither_hash_order_nor_process_shows(tmp_path: Path) -> None:
    """Two processes, whose sets and dicts of strings are in other orders, write the same bytes."""
    command = ["vary", str(sample_path("townhouse")), "-n", "3", "--width", "130%", "-o"]
    source = f"import sys; from layoutkit.cli.app import main; sys.exit(main([*{command!r}, sys.argv[1]]))"
    digests = []
    for number in ("1", "2"):
        folder = tmp_path / number
        environment = {**os.environ, "PYTHONHASHSEED": number}
        subprocess.run(
            [sys.executable, "-c", source, folder], env=environment, check=True, capture_output=True
        )
        digests.append({p.name: p.read_bytes() for p in sorted(folder.iterdir()) if p.suffix == ".xml"})
    assert digests[0] == digests[1]
    assert len(digests[0]) >= 3


@settings(max_examples=60)
@given(st.integers(0, 10**6), SHARES, SHARES, st.integers(0, 99))
def test_whatever_is_found_is_right(number: int, width: float, height: float, seed: int) -> None:
    facade = grown(number)
    for outcome in made(facade, count=2, width=share(width), height=share(height), seed=seed, node_limit=60):
        codes = {d.code for d in outcome.diagnostics}
        if outcome.status == "found":
            layout = outcome.document
            assert isinstance(layout, Layout)
            assert codes == set()
            assert layout.violations() == ()
            assert layout.root.width == pytest.approx(width * facade.root.width, rel=1e-12)
            assert layout.root.height == pytest.approx(height * facade.root.height, rel=1e-12)
        else:
            assert outcome.document is None
            assert codes == {"infeasible": {"LK203"}, "limit": {"LK601"}}[outcome.status]


@given(st.integers(0, 10**6))
def test_what_the_input_itself_keeps_is_never_infeasible(number: int) -> None:
    facade = grown(number)
    if not Layout("input", "m", facade.root, facade).violations():
        (outcome,) = made(facade, count=1, node_limit=60)
        assert outcome.status != "infeasible"


def close(one: Region, other: Region, tolerance: float) -> bool:
    tolerance *= max(one.width, one.height)
    pairs = list(zip(place(one), place(other), strict=True))
    return all(
        a.path == b.path and all(abs(p - q) <= tolerance for p, q in zip(a.box, b.box, strict=True))
        for a, b in pairs
    )


@given(st.integers(0, 10**6), st.sampled_from(["fixed", "undrawn"]))
def test_without_freedom_the_input_comes_back(number: int, way: str) -> None:
    bare = replace(grown(number), constraints=())
    sizes = [
        Size(of=RegionSet(path), min=share(1.0), max=share(1.0))
        if way == "fixed"
        else Size(of=RegionSet(path), deviation=share(0.0))
        for path in bare.regions
        if "/" in path
    ]
    (outcome,) = made(replace(bare, constraints=tuple(sizes)), count=1, seed=number)
    assert outcome.status == "found"
    assert isinstance(outcome.document, Layout)
    # Bounds hold to rounding; what the objective asks for, to what the solver's accuracy makes of it.
    assert close(outcome.document.root, bare.root, 1e-9 if way == "fixed" else 2e-6)


def row(symbols: str, sizes: dict[str, float], height: float = 3.0) -> Region:
    children = tuple(Region(s, sizes[s], height) for s in symbols)
    return Region("R", sum(c.width for c in children), height, "columns", children)


def free(letters: str, within: str = "R") -> list[object]:
    every = {letter: list(letters) for letter in letters}
    return list(sequences([within], framed(list(letters), every, list(letters)), "any word"))


def test_infeasible_is_said_and_what_to_do() -> None:
    root = row("ab", {"a": 1.0, "b": 1.0})
    one = Measure(1.0)
    exact = [Size(of=RegionSet(path), min=one, max=one) for path in ("R/a", "R/b")]
    facade = Facade("f", "m", root, constraints=(*free("ab"), *exact))  # type: ignore[arg-type]
    (outcome,) = made(facade, count=1, width=Measure(3.5))
    assert (outcome.status, outcome.document) == ("infeasible", None)
    (diagnostic,) = outcome.diagnostics
    assert diagnostic.code == "LK203"
    assert "3.5 × 3 m" in diagnostic.message
    assert diagnostic.hint
    assert made(facade, count=1, width=Measure(4.0))[0].status == "found"


def floors() -> Facade:
    """Two floors whose words are free: two words to choose."""
    upper, lower = (replace(row("ab", {"a": 1.0, "b": 1.2}), symbol=symbol) for symbol in "FG")
    root = Region("R", 2.2, 6.0, "rows", (upper, lower))
    return Facade("f", "m", root, constraints=(*free("ab", "R/F"), *free("ab", "R/G")))  # type: ignore[arg-type]


def test_a_limit_is_no_proof() -> None:
    """Each floor takes a word: one word is too few."""
    (outcome,) = made(floors(), count=1, node_limit=1)
    assert (outcome.status, outcome.document) == ("limit", None)
    (diagnostic,) = outcome.diagnostics
    assert diagnostic.code == "LK601"
    assert "1 word tried" in diagnostic.message
    assert made(floors(), count=1, node_limit=2)[0].status == "found"


def counted(least: float, most: float) -> Facade:
    """A row of four symbols in any order, each of which is counted."""
    root = row("abcd" * 15, dict.fromkeys("abcd", 1.0))
    counts = [Frequency(of=RegionSet(s), within="R", min=Measure(least), max=Measure(most)) for s in "abcd"]
    return Facade("f", "m", root, constraints=(*free("abcd"), *counts))  # type: ignore[arg-type]


def test_more_counts_than_tables_have_room_for() -> None:
    """Ten to twenty of each of four: all counts together have a hundred thousand states."""
    for outcome in made(counted(10, 20), count=3):
        assert outcome.status == "found"
        assert isinstance(outcome.document, Layout)
        assert outcome.document.violations() == ()


def test_sequences_too_many_to_search_are_said_to_be(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(groups, "build", partial(build, most_states=2))
    outcomes = made(counted(10, 20), count=2)
    assert [(o.status, o.document, [d.code for d in o.diagnostics]) for o in outcomes] == [
        ("limit", None, ["LK601"])
    ] * 2
    assert "more than 2 states" in outcomes[0].diagnostics[0].message


def test_words_however_rare_are_found_and_nothing_is_proved_wrongly() -> None:
    """Sixteen of the one rare symbol are the only word that fits; among all it weighs 1e-27."""
    root = row("a" * 50 + "b", {"a": 61.0, "b": 61.0})
    sizes = [
        Size(of=RegionSet("R/a"), min=Measure(61.0), max=Measure(61.0)),
        Size(of=RegionSet("R/b"), min=Measure(61.0), max=Measure(64.0)),
    ]
    facade = Facade("f", "m", root, constraints=(*free("ab"), *sizes))  # type: ignore[arg-type]
    (found,) = made(facade, count=1, width=Measure(1024.0))
    assert isinstance(found.document, Layout)
    assert found.document.root.word == ("b",) * 16
    (none,) = made(facade, count=1, width=Measure(1025.0))
    assert none.status == "infeasible"
