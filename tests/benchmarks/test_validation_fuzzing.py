"""Documents damaged at random are checked: each gives diagnostics or nothing, soon, and in little memory."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from benchmarks import fuzzing
from benchmarks.large import SHAPES, write_layout
from benchmarks.mutations import MUTATIONS, mutated, spans
from layoutkit.constraints import BUILT_IN
from layoutkit.diagnostics import Diagnostic, Place
from layoutkit.documents import check
from layoutkit.hooks.host import Host

ROOT = Path(__file__).resolve().parents[2]
KINDS = {kind.kind: kind for kind in BUILT_IN}


@pytest.fixture(scope="module")
def host() -> Host:
    return Host.load()


def failures(numbers: range, host: Host, most: int, semantics: bool = False) -> list[str]:
    trials = (fuzzing.trial(0, number, host, semantics, most) for number in numbers)
    return [f"{t.index} of {t.origin}: {t.failure}" for t in trials if t.failure]


def test_a_thousand_small_documents(host: Host) -> None:
    assert failures(range(1000), host, most=6000) == []


def test_some_of_all_documents(host: Host) -> None:
    assert failures(range(150), host, most=10**9) == []


@pytest.mark.nightly
def test_a_hundred_thousand_documents() -> None:
    command = [sys.executable, "-m", "benchmarks.fuzzing"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


@pytest.mark.nightly
def test_with_semantics(host: Host) -> None:
    assert failures(range(10**6, 10**6 + 2000), host, most=10**9, semantics=True) == []


def test_a_number_makes_a_document_again() -> None:
    one, other = (fuzzing.document(3, 14)[1].data for _ in range(2))
    assert one == other != fuzzing.document(3, 15)[1].data


def test_each_mutation_changes_something() -> None:
    source = fuzzing.originals()["plain/facade"].data
    assert source is not None
    for mutation in MUTATIONS:
        generator = np.random.default_rng(0)
        assert any(mutation(source, generator) != source for _ in range(5))
        mutation(b"", generator)
        mutation(b"\xff\xfe<", generator)
    assert len({mutated(source, np.random.default_rng(seed)) for seed in range(50)}) == 50


def test_elements_are_found_by_their_tags() -> None:
    tokens = ["<a>", "x", "<b/>", "<!-- -->", "<c>", "</c>", "</a>", "</d>"]
    assert sorted((s.start, s.end) for s in spans(tokens)) == [(0, 7), (2, 3), (4, 6)]


@pytest.mark.parametrize(
    "found",
    [
        Diagnostic("LK407", "the constraint kind 'size' failed", Place("x")),
        Diagnostic("LK999", "no such code", Place("x")),
        Diagnostic("LK102", "without a place"),
        Diagnostic("LK102", "", Place("x")),
    ],
)
def test_what_should_not_be_said_is_noticed(found: Diagnostic) -> None:
    assert fuzzing.fault_of([found])


@pytest.mark.parametrize("error", [RecursionError, MemoryError, fuzzing.TooLong])
def test_what_is_raised_is_noticed(
    error: type[BaseException], host: Host, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*arguments: object) -> list[Diagnostic]:
        raise error

    monkeypatch.setattr(fuzzing, "check", fail)
    assert fuzzing.trial(0, 0, host).failure


@pytest.mark.parametrize("shape", SHAPES)
def test_large_layouts_are_sound(shape: str, tmp_path: Path) -> None:
    from lxml import etree

    path = tmp_path / "large.xml"
    write_layout(path, shape, 100_000)
    assert check(path, KINDS) == []
    assert etree.XMLSchema(file=ROOT / "schemas/layoutkit.xsd").validate(etree.parse(path))
    assert path.stat().st_size >= 100_000
