"""Layout documents are held against their facade: each broken rule is an error at the region's place."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import pytest

from layoutkit.constraints import Constraint
from layoutkit.diagnostics import Diagnostic
from layoutkit.documents import check, layout_bytes, read
from layoutkit.model import Layout

Kinds = Mapping[str, type[Constraint]]

FACADE = """<facade xmlns="urn:layoutkit:1" name="f" units="m">
<region symbol="F" width="6" height="2" split="columns">
  <region symbol="A" width="1" labels="Wall"/>
  <region symbol="B" width="2" split="rows"><region symbol="C" height="2" labels="Window"/></region>
  <again symbol="A"/>
  <again symbol="B"/>
</region>
<constraints>
<sequence within="F" word="⊢ A B A"/>
<sequence within="F" word="A B A B"/>
<sequence within="F" word="A B ⊣"/>
<size of="F/A" min="0.5" max="1.5"/>
<frequency of="@Window" within="F" max="3"/>
</constraints>
</facade>"""

BAY = '<region symbol="B" width="2" split="rows"><region symbol="C" height="2" labels="Window"/></region>'


def layout(children: str, width: float = 6, attributes: str = "", units: str = "m") -> str:
    """A layout whose root is in line 2 and whose children begin in line 3."""
    return (
        f'<layout xmlns="urn:layoutkit:1" name="l" units="{units}" facade="facade.xml">\n'
        f'<region symbol="F" width="{width}" height="2" split="columns"{attributes}>\n'
        f"{children}</region></layout>"
    )


def found(text: str, kinds: Kinds, written: Callable[..., Path], facade: str = FACADE) -> list[Diagnostic]:
    written(facade)
    return check(written(text, "layout.xml"), kinds)


def shown(diagnostics: list[Diagnostic]) -> list[str]:
    return [
        f"{d.code} {d.place.line}:{d.place.column} {d.message.split(':')[0]}" for d in diagnostics if d.place
    ]


WIDE = '<region symbol="A" width="2" labels="Wall"/>'
WALL = '<region symbol="A" width="1" labels="Wall"/>'
AGAIN = '<again symbol="A"/><again symbol="B"/>'


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (layout(f"{WALL}\n{BAY}\n{AGAIN}"), []),
        (layout(f"{WALL}\n{BAY}\n{AGAIN}\n{AGAIN}", 9), []),
        (layout(f"{WALL}\n{BAY}", 3), ["LK502 2:1 F"]),
        (layout(f"{WALL}\n{BAY}\n{AGAIN}\n{AGAIN}\n{AGAIN}", 12), ["LK502 2:1 F"]),
        (layout(f"{WALL}\n{BAY}\n{AGAIN}", attributes=' labels="Odd"'), ["LK501 2:1 F"]),
        (layout(f"{WALL}\n{BAY}\n{AGAIN}", units="px"), ["LK503 1:1 the layout is in px, its facade in m"]),
        (
            layout(
                f'{WALL}\n{BAY}\n<region symbol="A" width="1.25" labels="Wall"/>\n<again symbol="B"/>', 6.25
            ),
            ["LK501 5:1 F/A.2"],
        ),
        (
            layout(
                f"{WIDE}\n{BAY}\n{AGAIN}",
                8,
            ),
            ["LK502 3:1 F/A", "LK502 5:1 F/A.2"],
        ),
        (
            layout(
                f"{WALL}\n{BAY}\n{WALL}\n"
                '<region symbol="B" width="2" split="rows"><region symbol="D" height="2"/></region>'
            ),
            ["LK501 6:43 F/B.2/D"],
        ),
    ],
    ids=[
        "kept",
        "longer",
        "no sequence",
        "too many",
        "labels",
        "units",
        "no replica",
        "too wide",
        "unknown region",
    ],
)
def test_each_broken_rule_is_reported_at_its_region(
    text: str, expected: list[str], kinds: Kinds, written: Callable[..., Path]
) -> None:
    diagnostics = found(text, kinds, written)
    assert [line for line in shown(diagnostics) if line in expected] == expected
    assert bool(diagnostics) == bool(expected)


def test_the_amount_and_the_constraint_are_named(kinds: Kinds, written: Callable[..., Path]) -> None:
    text = layout(f"{WIDE}\n{BAY}\n{AGAIN}", 8)
    first = found(text, kinds, written)[0]
    constraint, amount = first.details
    assert constraint.startswith('size of="F/A" min="0.5" max="1.5"')
    assert constraint.endswith("facade.xml:12:1)")
    assert amount == "off by 0.5"


def test_replicas_are_placed_at_the_again_and_their_inside_at_the_original(
    kinds: Kinds, written: Callable[..., Path]
) -> None:
    windows = FACADE.replace("</constraints>", '<size of="F/B/C" min="3"/></constraints>')
    text = layout(f"{WALL}\n{BAY}\n{WALL}\n<again symbol='B'/>")
    diagnostics = found(text, kinds, written, windows)
    assert [line for line in shown(diagnostics) if line.startswith("LK502")] == [
        "LK502 4:43 F/B/C",
        "LK502 4:43 F/B.2/C",
    ]


def test_a_layout_without_its_facade_is_valid_by_itself(kinds: Kinds, written: Callable[..., Path]) -> None:
    path = written(layout(f"{WALL}\n{BAY}\n{AGAIN}"), "layout.xml")
    assert [d.code for d in check(path, kinds)] == ["LK504"]
    alone = read(path, kinds).model
    assert isinstance(alone, Layout)
    assert alone.facade is None
    path.write_bytes(layout_bytes(Layout(alone.name, alone.units, alone.root)))
    assert check(path, kinds) == []


def test_a_plugin_that_fails_to_check_is_reported(kinds: Kinds, written: Callable[..., Path]) -> None:
    @dataclass(frozen=True, kw_only=True)
    class Broken(Constraint):
        kind: ClassVar[str] = "broken"
        summary: ClassVar[str] = "It fails."

        def violations(self, view: object):  # type: ignore[no-untyped-def]
            raise ZeroDivisionError

    facade = FACADE.replace("</constraints>", "<broken/></constraints>")
    text = layout(f"{WALL}\n{BAY}\n{AGAIN}")
    assert [d.code for d in found(text, {**kinds, "broken": Broken}, written, facade)] == ["LK407"]
