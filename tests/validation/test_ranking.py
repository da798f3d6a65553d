"""What is told first, and what is told once."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.diagnostics.ranking import ranked
from layoutkit.documents import check
from layoutkit.documents.kinds import Kinds
from tests.validation.conftest import HOUSE, Written


def at(code: str, line: int, message: str = "it is wrong", **more: object) -> Diagnostic:
    found = Diagnostic(code, message, Place("house.xml", line, 1))
    return replace(found, **more)  # type: ignore[arg-type]


def told(*diagnostics: Diagnostic) -> list[str]:
    return [f"{d.code} {d.place.line}" for d in ranked(diagnostics) if d.place]


def test_errors_come_before_warnings_and_these_before_notes() -> None:
    note, warning = at("LK102", 1, severity=Severity.NOTE), at("LK102", 2, severity=Severity.WARNING)
    assert told(note, warning, at("LK102", 3)) == ["LK102 3", "LK102 2", "LK102 1"]


def test_causes_come_before_what_may_follow_from_them() -> None:
    given_order = [
        at("LK502", 1),
        at("LK203", 2),
        at("LK201", 3),
        at("LK212", 4),
        at("LK103", 5),
        at("LK101", 6),
        at("LK407", 7),
    ]
    assert told(*given_order) == ["LK407 7", "LK101 6", "LK212 4", "LK103 5", "LK201 3", "LK203 2", "LK502 1"]


def test_within_these_the_order_of_the_document_is_kept() -> None:
    assert told(at("LK103", 2), at("LK212", 5), at("LK105", 9)) == ["LK103 2", "LK212 5", "LK105 9"]


def test_the_same_fault_in_many_places_is_told_once_with_all_places() -> None:
    (found,) = ranked(at("LK102", line, "there is no constraint kind 'foo'") for line in range(1, 31))
    assert [place.line for place in found.related] == list(range(1, 31))
    assert found.details == ("the same at 2:1, 3:1, 4:1, 5:1, 6:1, 7:1, 8:1, 9:1, 10:1, 11:1 and 19 more",)


def test_faults_of_two_files_are_told_apart() -> None:
    other = replace(at("LK102", 1), place=Place("other.xml", 1, 1))
    assert len(ranked([at("LK102", 1), other])) == 2


def test_a_symbol_renamed_in_one_place_is_one_fault(kinds: Kinds, written: Written) -> None:
    text = HOUSE.replace('symbol="Bay"', 'symbol="Window"').replace(
        "</constraints>",
        '<size of="Facade/Bay/Opening" min="1"/>\n<sequence within="Facade" word="Pier Bay Pier"/>\n'
        '<same-size first="Facade/Bay" second="Facade/Pier" dimension="width"/></constraints>',
    )
    found = check(written("house.xml", text), kinds)
    assert len(found) == 4
    (one,) = ranked(found)
    assert one.message == "size names the region 'Facade/Bay', which is not there"
    assert [place.line for place in one.related] == [13, 15, 16, 14]


def test_names_that_have_nothing_to_do_with_each_other_stay_apart(kinds: Kinds, written: Written) -> None:
    text = HOUSE.replace("Facade/Pier", "Facade/Peer").replace("Facade/Bay", "@Bay")
    assert len(ranked(check(written("house.xml", text), kinds))) == 2


def test_a_constraint_that_replicas_break_alike_is_told_once_with_the_amount() -> None:
    broken = [
        Diagnostic(
            "LK502",
            f"Facade/Bay.{number}: the width 2 is above 1",
            Place("out.xml", 4, 5),
            details=("size of Facade/Bay", f"off by {1 if number < 4 else 2}"),
        )
        for number in range(1, 6)
    ]
    first, second = ranked(broken)
    assert first.details[1:] == ("off by 1", "the same of Facade/Bay.2, Facade/Bay.3")
    assert second.details[1:] == ("off by 2", "the same of Facade/Bay.5")
    assert first.related == ()


def test_a_name_used_twice_in_one_constraint_is_told_once() -> None:
    word = at("LK201", 4, "sequence names the direct subregion of Facade 'X', which is not there")
    path = at("LK201", 4, "sequence names the region 'Facade/X', which is not there")
    assert ranked([word, path]) == (word,)


CODES = st.sampled_from(["LK102", "LK103", "LK201", "LK212", "LK407", "LK502", "XY1"])
NAMES = st.sampled_from(["it is wrong", "size names the region 'F/A', which is not there", "F/A: too wide"])
DIAGNOSTICS = st.builds(
    Diagnostic,
    code=CODES,
    message=NAMES,
    place=st.none() | st.builds(Place, st.sampled_from(["a.xml", "b.xml"]), st.integers(1, 9), st.just(1)),
    severity=st.sampled_from(Severity),
)


@given(st.lists(DIAGNOSTICS))
def test_no_place_and_no_code_is_lost_and_ranking_twice_changes_nothing(found: list[Diagnostic]) -> None:
    once = ranked(found)
    assert {d.code for d in once} == {d.code for d in found}
    places = {place for d in once for place in (d.place, *d.related) if place}
    assert places == {d.place for d in found if d.place}
    assert ranked(once) == once
    assert len(once) <= len(set(found))
