"""``layoutkit constraints``: the kinds that there are, built in or a plugin's, and each in full."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.documents import check

GOLDEN = """
    from dataclasses import dataclass
    from layoutkit.constraints import Constraint
    from layoutkit.constraints.attributes import REGIONS, WEIGHT, attribute
    from layoutkit.constraints.namespace import Namespace
    from layoutkit.hooks import hookimpl
    from layoutkit.model import RegionSet

    @dataclass(frozen=True, kw_only=True)
    class Ratio(Constraint):
        kind = "ratio"
        namespace = Namespace("golden", "urn:golden:1")
        summary = "Heights are widths times a ratio: of all regions. No other is."
        of: RegionSet = attribute(REGIONS, "The regions.")
        ratio: float = attribute(WEIGHT, "Height over width.", 1.618)
        def violations(self, view): return iter(())

    @hookimpl
    def layoutkit_constraints(): return [Ratio]
"""


def test_all_are_listed_each_with_a_sentence(layoutkit: Any, install: Any) -> None:
    install("shiny", GOLDEN)
    lines = layoutkit("constraints").out.splitlines()
    assert [line.split()[0] for line in lines] == [*(kind.kind for kind in BUILT_IN), "golden:ratio"]
    assert lines[-1].endswith("  Heights are widths times a ratio (acme-plugin 1.2)")


def test_one_is_told_in_full(layoutkit: Any, install: Any) -> None:
    install("shiny", GOLDEN)
    lines = layoutkit("constraints", "golden:ratio").out.splitlines()
    assert lines[0] == "golden:ratio, of the plugin 'shiny' of acme-plugin 1.2"
    assert "  of      The regions." in lines
    assert "          weight; 1.618 if left out" in lines
    assert lines[-1] == '  <golden:ratio xmlns:golden="urn:golden:1" of="@Window"/>'


def test_as_json(layoutkit: Any, install: Any) -> None:
    install("shiny", GOLDEN)
    data = layoutkit("constraints", "--json").data
    assert data["diagnostics"] == []
    (golden,) = (one for one in data["constraints"] if one["plugin"] == "shiny")
    assert (golden["package"], golden["version"]) == ("acme-plugin", "1.2")
    ratio = {a["name"]: a for a in golden["attributes"]}["ratio"]
    assert (ratio["type"], ratio["default"], ratio["required"]) == ("weight", "1.618", False)


def test_an_unknown_kind_is_told_the_nearest(layoutkit: Any, install: Any) -> None:
    install("shiny", GOLDEN)
    for name, hint in (("siez", "did you mean 'size'?"), ("ratio", "did you mean 'golden:ratio'?")):
        run = layoutkit("constraints", name)
        assert (run.code, hint in run.err) == (2, True)


def test_the_help_says_that_plugins_kinds_are_among_them(layoutkit: Any) -> None:
    assert "those of plugins among them" in " ".join(layoutkit("constraints", "--help").out.split())


@pytest.mark.parametrize("kind", BUILT_IN, ids=lambda kind: kind.kind)
def test_the_example_is_one_that_can_be_read(kind: type[Constraint], tmp_path: Path, layoutkit: Any) -> None:
    (data,) = layoutkit("constraints", kind.kind, "--json").data["constraints"]
    file = tmp_path / "facade.xml"
    file.write_text(
        '<facade xmlns="urn:layoutkit:1" name="f" units="m">'
        '<region symbol="Other" width="1" height="1"/>'
        f"<constraints>{data['example']}</constraints></facade>"
    )
    # Its regions are those of another facade: that is all there is to say against it.
    assert {d.code for d in check(file, {k.kind: k for k in BUILT_IN})} == {"LK201"}
