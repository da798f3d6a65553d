"""Several conflicts at once, searches that end at their limits, and what stays the same from run to run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from conflicting import TWICE, any_word, changed, helps, row

from layoutkit.constraints import BUILT_IN, Frequency, Size
from layoutkit.documents import read
from layoutkit.model import Facade, Layout, Measure, RegionSet
from layoutkit.model.conflict import Remedy
from layoutkit_relayout.explanation import explaining
from layoutkit_relayout.explanation.explaining import explain
from layoutkit_relayout.explanation.judge import Judge
from layoutkit_relayout.explanation.report import diagnostics
from layoutkit_relayout.explanation.stage import Explain, ExplainOptions
from layoutkit_relayout.words import machine

KINDS = {kind.kind: kind for kind in BUILT_IN}


@pytest.fixture
def twice(tmp_path: Path) -> Facade:
    (tmp_path / "twice.xml").write_text(TWICE, encoding="utf-8")
    facade = read(tmp_path / "twice.xml", KINDS).model
    assert isinstance(facade, Facade)
    return facade


def test_each_conflict_is_told(twice: Facade) -> None:
    explanation = explain(twice, (4.0, 4.0))
    assert explanation.complete
    members = [
        [member.subject for member in conflict.members if not member.by_default]
        for conflict in explanation.conflicts
    ]
    assert sorted(members) == [
        ["size of Facade/Top", "size of Facade/Base"],
        ["size of Facade/Top/L", "size of Facade/Top/R"],
    ]
    messages = [d.message for d in diagnostics(explanation, twice)]
    assert [m.partition("(")[2] for m in messages] == ["1 of 2 conflicts)", "2 of 2 conflicts)"]


def test_each_remedy_helps_beside_what_the_other_conflict_can_spare(twice: Facade) -> None:
    conflicts = explain(twice, (4.0, 4.0)).conflicts
    for one, other in (conflicts, conflicts[::-1]):
        (spared,) = other.members[other.spared].constraints
        assert isinstance(spared, Size)
        for remedy in one.remedies:
            facade = changed(twice, remedy)
            free = replace(spared, min=None, max=None)
            constraints = tuple(free if c is spared else c for c in facade.constraints)
            assert helps(replace(facade, constraints=constraints), (4.0, 4.0), Remedy("", None)), remedy.text
        assert len([remedy for remedy in one.remedies if remedy.amount is not None]) >= 2


def test_changes_of_degree_help_together(twice: Facade) -> None:
    first, second = explain(twice, (4.0, 4.0)).conflicts
    for one in (r for r in first.remedies if r.amount is not None):
        for other in (r for r in second.remedies if r.amount is not None):
            assert helps(changed(twice, one), (4.0, 4.0), other), (one.text, other.text)


def test_the_best_effort_breaks_one_member_of_each(twice: Facade) -> None:
    effort = explain(twice, (4.0, 4.0)).best_effort
    assert effort is not None
    broken = {v.path for v in effort.violations()}
    assert len(broken) == 2
    assert broken & {"Facade/Top", "Facade/Base"}
    assert broken & {"Facade/Top/L", "Facade/Top/R"}


def test_no_more_conflicts_than_anyone_reads(monkeypatch: pytest.MonkeyPatch, twice: Facade) -> None:
    monkeypatch.setattr(explaining, "MOST_CONFLICTS", 1)
    explanation = explain(twice, (4.0, 4.0))
    assert (len(explanation.conflicts), explanation.complete) == (1, False)
    assert explanation.best_effort is not None
    (told,) = diagnostics(explanation, twice)
    assert told.message.endswith("(1 of 1 or more conflicts)")


def test_the_same_question_has_the_same_answer(twice: Facade) -> None:
    first, second = (explain(twice, (4.0, 4.0), seed=3) for _ in range(2))
    assert diagnostics(first, twice) == diagnostics(second, twice)
    assert first.best_effort is not None
    assert second.best_effort is not None
    assert first.best_effort.root == second.best_effort.root


def test_suspects_are_where_the_conflict_is_looked_for(twice: Facade) -> None:
    across = [c for c in twice.constraints if isinstance(c, Size) and str(c.of).startswith("Facade/Top/")]
    units = Judge(twice, (4.0, 4.0)).units
    words = [c for unit in units if unit.region for c in unit.constraints]
    explanation = explain(twice, (4.0, 4.0), suspects=[*across, *words])
    assert [m.constraints for m in explanation.conflicts[0].members if not m.by_default] == [
        (constraint,) for constraint in across
    ]
    # Suspects that can hold together are no help, and do no harm.
    assert explain(twice, (4.0, 4.0), suspects=across[:1]).conflicts


def test_a_limit_is_no_proof() -> None:
    """Ten to twenty of each of four letters: what it takes to tell is more than one word."""
    counts = [Frequency(of=RegionSet(s), within="R", min=Measure(10.0), max=Measure(20.0)) for s in "abcd"]
    facade = row("abcd" * 15, dict.fromkeys("abcd", 1.0), [*any_word("R", "abcd"), *counts])
    (outcome,) = Explain().run(facade, ExplainOptions(width=Measure(40.5), node_limit=1))
    if outcome.status == "limit":
        assert [d.code for d in outcome.diagnostics] == ["LK601"]
        assert outcome.explanation is not None
        assert outcome.explanation.conflicts == ()
    else:
        assert isinstance(outcome.document, Layout)


def test_more_states_than_machines_may_have(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the search cannot even begin, the best effort leaves out what is too much for it."""
    facade = row("abc", dict.fromkeys("abc", 1.0), any_word("R", "abc"))
    monkeypatch.setattr(machine, "MOST_STATES", 0)
    monkeypatch.setattr(machine.build, "__defaults__", (0,))
    (outcome,) = Explain().run(facade, ExplainOptions(width=Measure(7.0)))
    assert outcome.status == "limit"
    assert [d.code for d in outcome.diagnostics] == ["LK601"]


def test_a_witness_where_there_is_a_layout(twice: Facade) -> None:
    free = replace(twice, constraints=())
    (outcome,) = Explain().run(free, ExplainOptions())
    assert outcome.status == "found"
    assert isinstance(outcome.document, Layout)
    assert outcome.document.violations() == ()
    assert outcome.explanation is None
