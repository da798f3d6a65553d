"""What users write: sizes, seeds, names of results; and how far a run says it is."""

from __future__ import annotations

import contextlib
import io
import os
import sys
import time
from pathlib import Path

import pytest
import typer
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.batch import Finished
from layoutkit.cli import meter as metering
from layoutkit.cli.batch import Sizes, names_of
from layoutkit.cli.batching import MOST_SEEDS, Seeds, _Outcome
from layoutkit.cli.meter import Bar, Lines, lasting, meter
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.model import Measure

NUMBERS = st.integers(0, 10**6)
RANGES = st.tuples(NUMBERS, st.integers(0, 50)).map(lambda pair: (pair[0], pair[0] + pair[1]))
MEASURES = st.builds(
    Measure, st.floats(1e-6, 1e6, allow_nan=False, allow_infinity=False), relative=st.booleans()
)


@given(st.lists(NUMBERS, min_size=1, max_size=20))
def test_seeds_are_read_in_their_order_and_once(numbers: list[int]) -> None:
    assert Seeds.parse(", ".join(map(str, numbers))).numbers == tuple(dict.fromkeys(numbers))


@given(st.lists(RANGES, min_size=1, max_size=5))
def test_ranges_of_seeds_have_both_ends(ranges: list[tuple[int, int]]) -> None:
    text = ",".join(f"{first}-{last}" for first, last in ranges)
    expected = dict.fromkeys(n for first, last in ranges for n in range(first, last + 1))
    assert Seeds.parse(text).numbers == tuple(expected)


@given(st.text(alphabet="0123456789-,. x٣", max_size=8))
def test_seeds_are_read_or_refused(text: str) -> None:
    with contextlib.suppress(ValueError):
        found = Seeds.parse(text)
        assert found.numbers
        assert all(number >= 0 for number in found.numbers)


@pytest.mark.parametrize("text", ["", "1,", "-1", "3-1", "1-2-3", "x", "1.5", f"0-{MOST_SEEDS}", "0-9" * 30])
def test_what_is_no_seed_is_told(text: str) -> None:
    with pytest.raises(ValueError, match=r"no seed|ends before|more than"):
        Seeds.parse(text)


@given(st.lists(MEASURES, min_size=1, max_size=10))
def test_sizes_are_read_in_their_order_and_once(measures: list[Measure]) -> None:
    assert Sizes.parse(",".join(map(str, measures))).measures == tuple(dict.fromkeys(measures))


@pytest.mark.parametrize("text", ["", "1,", "0", "-3", "nan", "inf", "3;4", "%", "1,x"])
def test_what_is_no_size_is_told(text: str) -> None:
    with pytest.raises(typer.BadParameter, match="no size"):
        Sizes.parse(text)


@given(st.lists(st.sampled_from(["a", "A", "a-2", "b", "facade"]), max_size=8))
def test_no_two_facades_have_a_name(stems: list[str]) -> None:
    names = list(names_of([Path("/drawn", f"{number}", f"{stem}.xml") for number, stem in enumerate(stems)]))
    assert len({name.casefold() for name in names}) == len(stems)
    assert all("/" not in name and name for name in names)


def test_names_that_are_no_text_give_folders_that_are() -> None:
    files = [Path(os.fsdecode(name)) for name in (b"a\xff.xml", b"a\xfe.xml", b"a_.xml")]
    assert list(names_of(files)) == ["a_", "a_-2", "a_-3"]
    assert list(names_of([Path("...xml"), Path("....xml")])) == ["_", "_-2"]


def test_a_remark_that_stands_for_many_is_told_whichever_comes_first() -> None:
    outcome, session = _Outcome(), Session()
    for message, count in (("and 4 more", 4), ("one", 1), ("two", 1), ("and 3 more", 3)):
        remark = Diagnostic("LK303", message, severity=Severity.WARNING, count=count)
        outcome.add(Finished(message, "done", diagnostics=(remark,)))
    outcome.tell(session)
    told = ["and 4 more", "one", "and 4 more of this kind"]
    assert [d.message for d in session.diagnostics] == told


def test_facades_of_samples_have_the_names_of_their_folders() -> None:
    files = [Path("plain/facade.xml"), Path("palace/facade.xml"), Path("a/house.xml"), Path("b/house.xml")]
    assert list(names_of(files)) == ["plain", "palace", "house", "house-2"]


def test_a_line_says_how_long_it_will_take() -> None:
    shown = Lines("tasks")
    assert shown.line(5.0) == "0 of 0 tasks done"
    shown.begin(100, 20)
    assert shown.line(5.0) == "20 of 100 tasks done"
    for failed in (False, False, True, False):
        shown.advance(failed)
    assert shown.line(40.0) == "23 of 100 tasks done, 1 failed, about 13 min left"
    assert [lasting(seconds) for seconds in (3.2, 150.0, 7300.0)] == ["3 s", "2 min", "2.0 h"]


def test_there_is_a_sign_of_life_while_nothing_is_done(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    with Lines("tasks", pause=0.01) as shown:
        shown.begin(7, 0)
        deadline = time.monotonic() + 10
        while sys.stderr.getvalue().count("\n") < 2 and time.monotonic() < deadline:
            time.sleep(0.01)
    assert "0 of 7 tasks done\n" in sys.stderr.getvalue()


def test_a_terminal_gets_a_bar(monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setattr(sys, "stderr", Terminal())
    monkeypatch.setenv("TERM", "xterm")
    with meter("tasks") as shown:
        assert isinstance(shown, Bar)
        shown.begin(4, 1)
        shown.advance(False)
        shown.advance(True)
        shown._progress.refresh()
        assert "2/4" not in sys.stderr.getvalue()
        assert "3/4" in sys.stderr.getvalue()
        assert "1 failed" in sys.stderr.getvalue()
    assert (shown.done, shown.failed) == (2, 1)
    assert metering.PAUSE <= 30
