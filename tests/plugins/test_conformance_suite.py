"""The conformance suite catches each promise that is broken, and finds no fault with what keeps them all."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import bad_declarations as odd
import bad_kinds as bad
import pytest

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.testing import HOUSES, PROMISES, Conformance, ConstraintSuite, conforms

#: For each kind that breaks a promise: which, what is told, and what documents say of it, if that matters.
BROKEN: dict[type[Constraint], tuple[str, str] | tuple[str, str, str]] = {
    bad.RowsTooTight: ("rows", "size_rules() refuses sizes"),
    bad.RowsTooLoose: ("rows", "admit a layout that violations() finds fault with"),
    bad.NoRows: ("rows", "admit a layout that violations() finds fault with"),
    bad.PrunesNothing: ("rows", "admit a layout that violations() finds fault with"),
    bad.PrunesAll: ("prunings", "word_rules() refuses an arrangement (Admits of"),
    bad.PrunesLongWords: ("prunings", "word_rules() refuses an arrangement (Admits of"),
    bad.AsksAheadOfWords: ("beginnings", "as long as the words of"),
    bad.CountsForEver: ("rules", "more than 3,000 states"),
    bad.StatesAreLists: ("rules", "states that cannot be hashed"),
    bad.NoOrigin: ("rules", "has None as its origin: pass self"),
    bad.WordsWithoutOrigin: ("rules", "its origin is not the constraints that it comes from"),
    bad.RowsOfNoNumbers: ("rules", "RowsOfNoNumbers gives rows of what is no number"),
    bad.WrongShape: ("rules", "WrongShape gives rows over 1 quantities"),
    bad.NotConvex: ("rows", "an excess that is not convex by cvxpy's rules"),
    bad.Raises: ("rules", "raises KeyError: 'lost'"),
    bad.ClaimsTooMuch: ("claims", "not between 0 and 1"),
    bad.PermitsWithoutRule: ("claims", "word_rules() does not say which"),
    bad.PartsOfLess: ("claims", "its parts() together think otherwise"),
    bad.RelatesAfterAll: ("claims", "relations() says that no rule relates sizes"),
    bad.RelatesBothAxes: ("claims", "counts would be wrong"),
    bad.OrderOfASet: ("determinism", "where texts have other hashes"),
    bad.NumberOfTheProcess: ("determinism", "another process answers differently"),
    bad.DrawsAnew: ("determinism", "asked twice, it answers differently"),
    bad.CountsItsCalls: ("determinism", "asked twice, it answers differently"),
    bad.DrawsGlobally: ("state", "numpy's global generator"),
    bad.RemembersPaths: ("state", "it remembers something outside the facade"),
    bad.RemembersOnItself: ("state", "asked about another facade"),
    bad.ChangesTheFacade: ("state", "it changes what it is given"),
    bad.ChangesTheWords: ("state", "it changes what it is given"),
    odd.NoPlace: ("messages", "has no place"),
    odd.NoHint: ("messages", "has no hint"),
    odd.TakesAnyName: ("messages", "is no region, symbol or label"),
    odd.AmountIsNoNumber: ("messages", "whose amount is no number"),
    odd.AmountIsNegative: ("messages", "and no number above 0"),
    odd.NamesSymbolPaths: ("messages", "a path that is none of the layout"),
    odd.NotReadBack: ("declaration", "reads that as something else"),
    odd.ChokesOnTexts: ("declaration", "no ValueError: KeyError"),
    odd.NotHashable: ("declaration", "cannot be hashed", 'names="a b"'),
    odd.NotPickled: ("declaration", "cannot be pickled", 'handle="a"'),
    odd.PatternRefusesItsText: ("declaration", "which its own pattern refuses"),
    odd.NoHelp: ("declaration", "has no help"),
    odd.Loose: ("declaration", "is no frozen dataclass"),
}


def element(kind: type[Constraint], more: str = "") -> str:
    return f'<{kind.qualified_name()} of="@Window | @Door | @Wall" {more}/>'


@pytest.mark.parametrize("kind", BROKEN, ids=lambda kind: kind.__name__)
def test_a_promise_that_is_broken_is_found(kind: type[Constraint]) -> None:
    promise, told, *more = BROKEN[kind]
    findings = conforms(kind, [element(kind, *more)], promises=[promise])
    assert any(told in finding.message for finding in findings), "\n".join(map(str, findings))
    assert all(f.promise == promise and "\n" not in f.message for f in findings)


class TestGood(ConstraintSuite):
    kind = bad.Good
    elements = [element(bad.Good), '<bad:good of="@Shop" weight="2"/>']


def test_every_promise_is_broken_by_one_of_these_kinds() -> None:
    assert {promise for promise, *_ in BROKEN.values()} == set(PROMISES)


def test_a_class_has_a_test_for_each_promise() -> None:
    tests = {name for name in vars(ConstraintSuite) if name.startswith("test_")}
    assert tests == {f"test_{promise}" for promise in PROMISES}


def test_a_class_of_tests_fails_with_the_findings() -> None:
    class Lax(ConstraintSuite):
        kind = bad.NoRows
        elements = [element(bad.NoRows)]

    with pytest.raises(AssertionError, match=r"rows: word_rules\(\) and size_rules\(\) admit a layout"):
        Lax().test_rows()
    Lax().test_prunings()


#: Constraints of each built-in kind, for the facades of the suite.
ELEMENTS = {
    "size": ['<size of="@Window" min="1" max="120%"/>'],
    "sequence": [
        '<sequence within="Facade" word="|- {Pier Window}"/>'
        '<sequence within="Facade" word="{Pier Window} {Pier Door}"/>'
        '<sequence within="Facade" word="{Door Pier} {Window} -|"/>'
    ],
    "replication": ['<replication within="Facade"/>'],
    "repetition": ['<repetition within="Facade" pattern="Pier (Window | Door)+[Pier] Pier"/>'],
    "two-shuffle": ['<two-shuffle within="Facade" of="Pier Window"/>'],
    "reversal": [
        '<sequence within="Facade" word="|- Pier Window Pier Door Shop -|"/><reversal within="Facade"/>'
    ],
    "reuse": [
        '<sequence within="Facade/Floor" word="|- Pier Bay Pier Bay Pier -|"/>'
        '<reuse within="Facade/Ground" like="Facade/Floor" symbols="Bay:Shop"/>'
    ],
    "frequency": [
        '<frequency of="@Window" within="Facade" min="1" max="2"/>',
        '<frequency of="@Wall" within="Facade" max="120%"/>',
    ],
    "instances": ['<instances of="@Window" min="1" max="2"/>'],
    "alignment": ['<alignment first="@Window" second="@Door" lines="left"/>'],
    "same-size": ['<same-size first="@Window" second="@Door" dimension="width"/>'],
    "symmetry": ['<symmetry of="Facade"/>'],
    "same-arrangement": ['<same-arrangement of="Facade/Floor Facade/Floor"/>'],
    "lock": ['<lock of="@Window" keep="size place"/>', '<lock of="Facade" keep="inside" weight="1"/>'],
}


@pytest.mark.parametrize("kind", BUILT_IN, ids=lambda kind: kind.kind)
def test_the_built_in_kinds_keep_their_promises(kind: type[Constraint]) -> None:
    tried = Conformance(kind, tuple(ELEMENTS[kind.kind]))
    assert tried.trials
    assert [str(f) for promise in PROMISES for f in tried.findings(promise)] == []


def test_without_anything_to_try_it_with_nothing_is_promised() -> None:
    (finding,) = conforms(bad.Good)
    assert "give elements or documents" in finding.message


def test_an_element_that_fits_no_facade_is_told_with_the_reasons() -> None:
    (finding,) = conforms(bad.Good, ['<bad:good of="@Windw"/>'])
    assert finding.message.startswith("this element can be used in none of the facades")
    assert "did you mean 'Window'?" in "".join(finding.details)


def test_documents_of_ones_own_are_tried(tmp_path: Path) -> None:
    from layoutkit.testing.houses import document

    text = document("mine", HOUSES["row"], element(bad.NoRows), {"bad": "urn:test:bad"})
    file = tmp_path / "mine.xml"
    file.write_text(text)
    for given in (text, file):
        assert {f.promise for f in conforms(bad.NoRows, documents=[given])} == {"rows"}
    (finding,) = conforms(bad.NoRows, documents=["<facade/>"])
    assert finding.message == "the document document 1 has faults"


def test_the_suite_is_imported_without_pytest() -> None:
    program = "import sys, layoutkit.testing; print('pytest' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


def test_the_seed_decides_what_is_tried() -> None:
    one, same, other = (
        [sample.root for sample in Conformance(bad.Good, (element(bad.Good),), seed=seed).trials[0].chance]
        for seed in (1, 1, 2)
    )
    assert one == same
    assert one != other
