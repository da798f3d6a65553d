"""Constraints added to a user's document: theirs stays, byte by byte."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import BUILT_IN, Constraint, Size
from layoutkit.diagnostics import Faulty
from layoutkit.documents import read, with_constraints
from layoutkit.model import Facade, Measure, RegionSet

Kinds = Mapping[str, type[Constraint]]
KINDS = {kind.kind: kind for kind in BUILT_IN}
ADDED = (
    Size(of=RegionSet("F"), max=Measure(2.0, relative=True), comment="no wider\nthan twice"),
    Size(of=RegionSet("@Wänd"), min=Measure(0.5)),
)
HEAD = '<facade xmlns="urn:layoutkit:1" name="a>b" units=\'m\'>'
REGION = '<region symbol="F" labels="Wänd" width="1" height="1"/>'


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            f"{HEAD}\n  {REGION}\n\n  <constraints>\n    <!-- mine -->\n    <size of='F'/>\n"
            "  </constraints>\n</facade>",
            f"{HEAD}\n  {REGION}\n\n  <constraints>\n    <!-- mine -->\n    <size of='F'/>\n"
            '    <!-- no wider -->\n    <!-- than twice -->\n    <size of="F" max="200%"/>\n'
            '    <size of="@Wänd" min="0.5"/>\n  </constraints>\n</facade>',
        ),
        (
            f"{HEAD}\n\t{REGION} <!-- end -->\n</facade>\n<!-- bye -->\n",
            f"{HEAD}\n\t{REGION} <!-- end -->\n\n\t<constraints>\n"
            '\t\t<!-- no wider -->\n\t\t<!-- than twice -->\n\t\t<size of="F" max="200%"/>\n'
            '\t\t<size of="@Wänd" min="0.5"/>\n\t</constraints>\n'
            "</facade>\n<!-- bye -->\n",
        ),
        (
            f"{HEAD}\r\n {REGION}\r\n <constraints />\r\n</facade>",
            f"{HEAD}\r\n {REGION}\r\n <constraints>\r\n   <!-- no wider -->\r\n   <!-- than twice -->\r\n"
            '   <size of="F" max="200%"/>\r\n   <size of="@Wänd" min="0.5"/>\r\n </constraints>\r\n</facade>',
        ),
        (
            f"{HEAD}{REGION}<constraints><size of='F'/></constraints></facade>",
            f"{HEAD}{REGION}<constraints><size of='F'/>\n  <!-- no wider -->\n  <!-- than twice -->\n"
            '  <size of="F" max="200%"/>\n  <size of="@Wänd" min="0.5"/>\n</constraints></facade>',
        ),
    ],
    ids=["after the last", "without constraints", "empty constraints", "on one line"],
)
def test_where_constraints_go(before: str, after: str) -> None:
    assert with_constraints(before.encode(), ADDED).decode() == after


def test_a_users_last_comment_is_no_reason_for_what_is_added(written: Callable[..., Path]) -> None:
    source = f"{HEAD}{REGION}<constraints>\n<size of='F'/>\n<!-- mine -->\n</constraints></facade>"
    facade = read(written(with_constraints(source.encode(), ADDED)), KINDS).model
    assert isinstance(facade, Facade)
    assert [c.comment for c in facade.constraints] == ["", "no wider\nthan twice", ""]


@pytest.mark.parametrize(
    "codec", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "iso-8859-1", "ascii"]
)
@pytest.mark.parametrize("prefix", ["", "k:"])
@pytest.mark.parametrize("own", ["", "<constraints/>", "<constraints><size of='F'/></constraints>"])
def test_encodings_and_prefixes(codec: str, prefix: str, own: str, written: Callable[..., Path]) -> None:
    declared = {"utf-8-sig": "utf-8", "utf-16-le": "utf-16", "utf-16-be": "utf-16"}.get(codec, codec)
    body = f"{HEAD}\n{REGION}\n{own}\n</facade>".replace("xmlns=", "xmlns:k=" if prefix else "xmlns=")
    body = body.replace("</", "\0").replace("<", f"<{prefix}").replace("\0", f"</{prefix}")
    source = f'<?xml version="1.0" encoding="{declared}"?>\n{body}'.encode(codec, "xmlcharrefreplace")
    result = with_constraints(source, ADDED)
    facade = read(written(result), KINDS).model
    assert isinstance(facade, Facade)
    assert facade.constraints[-2:] == ADDED
    assert facade.constraints[-2].comment == ADDED[0].comment
    assert len(facade.constraints) == 2 + ("of" in own)
    _assert_kept(source, result, slash=own == "<constraints/>")


def _assert_kept(source: bytes, result: bytes, *, slash: bool) -> None:
    """What was inserted is one piece (besides the slash of an empty element)."""
    if not slash:
        start = next((i for i, (a, b) in enumerate(zip(source, result, strict=False)) if a != b), len(source))
        assert result.endswith(source[start:])


@given(
    st.lists(
        st.sampled_from([" ", "\n", "\t", "<!-- c -->", "<?pi x?>", "<size of='F'/>", "<!---->"]), max_size=6
    )
)
def test_whatever_stands_in_the_element(parts: list[str]) -> None:
    source = f"{HEAD}{REGION}<constraints>{''.join(parts)}</constraints></facade>".encode()
    result = with_constraints(source, ADDED)
    _assert_kept(source, result, slash=False)
    assert with_constraints(source, ()) == source
    twice = with_constraints(with_constraints(source, ADDED[:1]), ADDED[1:])
    assert result.split() == twice.split()


def test_broken_sources() -> None:
    with pytest.raises(Faulty, match="LK002"):
        with_constraints(b"<facade>", ADDED)
