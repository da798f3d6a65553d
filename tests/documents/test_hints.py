"""What the reader proposes for a fault: the name that was meant, the form of a number, the file beside."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.diagnostics import Severity, did_you_mean, nearest
from layoutkit.documents import NAMESPACE, check
from layoutkit.documents.findings import KEPT, Findings
from layoutkit.documents.source import Source
from layoutkit.documents.spelling import meant, misspelt_namespace, near_namespace

KINDS: dict[str, type[Constraint]] = {kind.kind: kind for kind in BUILT_IN}
FACADE = """<facade xmlns="urn:layoutkit:1" name="f" units="m">
<region symbol="F" width="6" height="4" labels="Wall"/>
<constraints>
<size of="F" min="2.5" weight="1.5"/>
</constraints>
</facade>"""
LAYOUT = """<layout xmlns="urn:layoutkit:1" name="l" units="m" facade="%s">
<region symbol="F" width="6" height="4"/>
</layout>"""


def hints(was: str, becomes: str) -> list[tuple[str, str]]:
    assert FACADE.count(was) == 1
    found = check(Source("f.xml", FACADE.replace(was, becomes).encode()), KINDS)
    return [(d.code, d.hint) for d in found]


def test_an_attribute_that_is_there_already_is_not_proposed() -> None:
    assert hints('height="4"', 'heigth="x" height="4"') == [
        ("LK103", "'height' is there already: delete this one")
    ]


def test_of_two_misspelt_attributes_one_is_taken() -> None:
    assert hints('height="4"', 'heigth="4" hieght="5"') == [
        ("LK103", "did you mean 'height'?"),
        ("LK103", "'height' is there already: delete this one"),
    ]


@pytest.mark.parametrize(
    ("was", "becomes", "code"),
    [
        ('width="6"', 'width="2,5"', "LK106"),
        ('min="2.5"', 'min="2,5"', "LK105"),
        ('weight="1.5"', 'weight="2,5"', "LK105"),
    ],
)
def test_a_decimal_comma_is_to_be_a_point(was: str, becomes: str, code: str) -> None:
    assert hints(was, becomes) == [(code, "write 2.5: a point, not a comma")]


@pytest.mark.parametrize(
    ("was", "becomes"),
    [
        ('width="6"', 'width="1,234,5"'),
        ('width="6"', 'width="6,"'),
        ('width="6"', 'width="2,5 m"'),
        ('labels="Wall"', 'labels="Wall,Stone"'),
    ],
)
def test_no_point_is_proposed_where_it_would_not_help(was: str, becomes: str) -> None:
    ((_, hint),) = hints(was, becomes)
    assert "a point" not in hint


def test_a_namespace_near_that_of_loaded_constraints_is_proposed() -> None:
    element = '<x:size xmlns:x="%s" of="F"/></constraints>'
    (near,) = hints("</constraints>", element % "urn:layoutkt:1")
    assert near == ("LK113", "did you mean 'urn:layoutkit:1'?")
    (far,) = hints("</constraints>", element % "urn:acme:golden")
    assert far == ("LK113", "install or enable the plugin that <size> is of, or delete it")


def test_a_facade_that_is_not_there_is_looked_for_beside_its_place(written: Callable[..., Path]) -> None:
    (written(FACADE).parent / "sub").mkdir()
    written(FACADE, "sub/house.xml")
    for facade, hint in {
        "facde.xml": "did you mean 'facade.xml'?",
        "sub/hous.xml": "did you mean 'sub/house.xml'?",
        "gone.xml": "put the facade there, or correct the attribute facade",
        "nowhere/facade.xml": "put the facade there, or correct the attribute facade",
    }.items():
        (found,) = check(written(LAYOUT % facade, "layout.xml"), KINDS)
        assert (found.code, found.severity, found.hint) == ("LK504", Severity.WARNING, hint)


def test_a_layout_in_the_place_of_a_facade_has_a_remedy(written: Callable[..., Path]) -> None:
    (found,) = check(written(LAYOUT % "layout.xml", "layout.xml"), KINDS)
    assert found.code == "LK505"
    assert "facade.xml" in found.hint


@pytest.mark.parametrize(
    "of", ["urn:layoutkit:2", "urn:layoutkit:10", "urn:layoutkit:1.0", "URN:layoutkit:v2/"]
)
def test_other_versions_are_near_and_not_misspelt(of: str) -> None:
    assert near_namespace(of)
    assert not misspelt_namespace(of)


@given(st.integers(0, len(NAMESPACE) - 1), st.sampled_from("xyz#/"))
def test_one_sign_more_makes_a_misspelt_namespace(index: int, sign: str) -> None:
    assert misspelt_namespace(NAMESPACE[:index] + sign + NAMESPACE[index:])


@pytest.mark.parametrize("of", ["", NAMESPACE, "urn:x", "http://maven.apache.org/POM/4.0.0", "u" * 10**7])
def test_others_are_not_near(of: str) -> None:
    assert not near_namespace(of)


NAMES = st.sets(st.text("abcF/", min_size=1, max_size=8), min_size=1, max_size=90)


@given(NAMES, st.text("abcF/", min_size=1, max_size=8))
def test_what_is_proposed_is_known_and_hangs_on_no_order(known: set[str], name: str) -> None:
    found = nearest(name, sorted(known))
    assert found is None or found in known
    assert found == nearest(name, sorted(known, reverse=True))
    assert did_you_mean(name, known) == did_you_mean(name, sorted(known))
    if name in known:
        assert found == name


@given(NAMES, st.text("abcF/", min_size=1, max_size=8))
def test_what_is_surely_meant_is_known(known: set[str], name: str) -> None:
    assert meant(name, known) in {None, *known}


def test_what_is_beyond_the_limit_is_counted() -> None:
    findings = Findings()
    (fault,) = check(Source("f.xml", FACADE.replace('"6"', '"x"').encode()), KINDS)
    for _ in range(KEPT + 17):
        findings.append(fault)
    assert sum(d.count for d in findings) == KEPT + 17
