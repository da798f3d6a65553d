"""What `vary` says where it finds nothing: a conflict, told once, at a cost that is bounded."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from conflicting import RIVOLI, TWICE, any_word, helps, only, row

from layoutkit.constraints import BUILT_IN, Frequency
from layoutkit.documents import read
from layoutkit.hooks import Outcome
from layoutkit.model import Facade, Measure, RegionSet
from layoutkit.samples import sample_path
from layoutkit_relayout.explanation.explaining import explain
from layoutkit_relayout.explanation.judge import Judge
from layoutkit_relayout.explanation.kin import Kin
from layoutkit_relayout.explanation.report import diagnostics
from layoutkit_relayout.stage import EFFORT, Relayout, RelayoutOptions

KINDS = {kind.kind: kind for kind in BUILT_IN}
SEVEN = Measure(7.0)


def document(text: str, folder: Path) -> Facade:
    file = folder / "facade.xml"
    file.write_text(text, encoding="utf-8")
    facade = read(file, KINDS).model
    assert isinstance(facade, Facade)
    return facade


def outcomes(facade: Facade, **options: Any) -> list[Outcome]:
    return list(Relayout().run(facade, RelayoutOptions(**options)))


@pytest.fixture
def rivoli(tmp_path: Path) -> Facade:
    return document(RIVOLI, tmp_path)


def test_every_outcome_has_the_same_explanation(rivoli: Facade) -> None:
    found = outcomes(rivoli, count=3, width=SEVEN)
    assert [outcome.status for outcome in found] == ["infeasible"] * 3
    explanation = found[0].explanation
    assert explanation is not None
    assert all(outcome.explanation is explanation for outcome in found), "it is made once"
    assert all(outcome.diagnostics == found[0].diagnostics for outcome in found)
    conflict = only(explanation.conflicts)
    assert conflict.minimal
    assert all(helps(rivoli, (7.0, 4.0), remedy) for remedy in conflict.remedies)
    assert explanation.best_effort is not None
    assert explanation.best_effort.violations()


def test_it_is_what_explain_says(rivoli: Facade) -> None:
    (outcome,) = outcomes(rivoli, count=1, width=SEVEN)
    assert outcome.diagnostics == diagnostics(explain(rivoli, (7.0, 4.0)), rivoli)


def test_the_command_prints_it_once(tmp_path: Path, layoutkit: Any) -> None:
    document(RIVOLI, tmp_path)
    given = ("vary", tmp_path / "facade.xml", "-n", 3, "--width", 7, "--json")
    run = layoutkit(*given, "-o", tmp_path / "out")
    assert run.code == 3
    assert run.data["status"] == "infeasible"
    (diagnostic,) = run.data["diagnostics"]
    assert diagnostic["code"] == "LK203"
    assert [place["line"] for place in diagnostic["related"]] == [15, 16]
    assert "short by 0.60 m" in diagnostic["details"]
    assert diagnostic["hint"].startswith("lower the minimum of C to 1.00 m")
    assert run.err.count("LK203") == 1
    assert layoutkit(*given, "-o", tmp_path / "again").err == run.err


def test_of_several_conflicts_the_first_is_told(tmp_path: Path) -> None:
    (outcome,) = outcomes(document(TWICE, tmp_path), count=1)
    (diagnostic,) = outcome.diagnostics
    assert diagnostic.message.endswith("(1 of 1 or more conflicts)")
    assert diagnostic.hint is not None
    assert diagnostic.hint.endswith("; `layoutkit explain` at this size tells of all conflicts")


def test_without_effort_the_command_that_tells_is_named(rivoli: Facade) -> None:
    (outcome,) = outcomes(rivoli, count=1, width=SEVEN, effort=0)
    assert outcome.status == "infeasible"
    assert [(d.code, d.details) for d in outcome.diagnostics] == [("LK203", ())]
    (diagnostic,) = outcome.diagnostics
    assert "which of them are in conflict takes longer to tell" in diagnostic.message
    assert diagnostic.hint == "`layoutkit explain` at this size tells which, and what would help"
    assert outcome.explanation is not None
    assert outcome.explanation.conflicts == ()


@pytest.mark.parametrize("effort", [10, 40, 80, 120, 160, 250, 400])
def test_what_is_told_with_little_effort_is_true(effort: int, rivoli: Facade) -> None:
    (outcome,) = outcomes(rivoli, count=1, width=SEVEN, effort=effort)
    explanation = outcome.explanation
    assert explanation is not None
    whole = only(explain(rivoli, (7.0, 4.0)).conflicts)
    for conflict in explanation.conflicts:
        subjects = [member.subject for member in conflict.members]
        for member in conflict.members:
            if member.needed:
                assert any(member.subject == other.subject for other in whole.members), subjects
        assert all(helps(rivoli, (7.0, 4.0), remedy) for remedy in conflict.remedies)
        if not conflict.minimal:
            assert outcome.diagnostics[0].details[-1].startswith("not proved that all of them are needed")


def test_some_effort_is_not_enough_for_remedies(rivoli: Facade) -> None:
    """Between no conflict and all of it: the conflict, and the command that tells what would help."""
    told = [outcomes(rivoli, count=1, width=SEVEN, effort=effort)[0] for effort in range(0, 500, 20)]
    hints = [outcome.diagnostics[0].hint or "" for outcome in told]
    assert any(hint.endswith("`layoutkit explain` at this size tells what would help") for hint in hints)
    assert hints[-1] == outcomes(rivoli, count=1, width=SEVEN)[0].diagnostics[0].hint


def test_a_limit_comes_with_the_layout_that_comes_nearest() -> None:
    """Ten to twenty of each of four letters: what it takes to tell is more than one word."""
    counts = [Frequency(of=RegionSet(s), within="R", min=Measure(10.0), max=Measure(20.0)) for s in "abcd"]
    facade = row("abcd" * 15, dict.fromkeys("abcd", 1.0), [*any_word("R", "abcd"), *counts])
    (outcome,) = outcomes(facade, count=1, width=Measure(24.5), node_limit=1)
    assert outcome.status == "limit"
    (diagnostic,) = outcome.diagnostics
    assert diagnostic.code == "LK601"
    assert "within 1 word tried, and it is not proved that there is none" in diagnostic.message
    assert diagnostic.hint is not None
    assert diagnostic.hint.endswith("tells which layout comes nearest")
    assert outcome.explanation is not None
    assert (outcome.explanation.conflicts, outcome.explanation.complete) == ((), False)
    assert outcome.explanation.best_effort is not None


@pytest.mark.parametrize("name", ["plain", "palace", "townhouse", "garden"])
def test_the_effort_bounds_the_searches(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    facade = read(sample_path(name), KINDS).model
    assert isinstance(facade, Facade)
    made = 0
    search = Kin.search

    def counted(self: Kin, *arguments: Any) -> Any:
        nonlocal made
        made += 1
        return search(self, *arguments)

    monkeypatch.setattr(Kin, "search", counted)
    (outcome,) = outcomes(facade, count=1, width=Measure(0.2, True))
    assert outcome.status == "infeasible"
    # Each costs at least as much as there are regions; the sizes asked for cost no search each.
    assert made <= EFFORT / sum(map(len, facade.places.values())) + 4


def test_once_effort_is_spent_nothing_is_searched(rivoli: Facade) -> None:
    judge = Judge(rivoli, (7.0, 4.0), effort=0)
    assert judge.ask(judge.units).status == "limit"
    assert not judge.plain(judge.units)
    assert judge.at((8.0, 4.0)).ask(judge.units[:1]).status in {"found", "limit"}
    assert judge.searched == 0
