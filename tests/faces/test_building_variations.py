"""Buildings laid out by the search: every face of its size, and what holds across faces kept there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from walls import design

from layoutkit.constraints import Alignment, Constraint, Frequency, SameSize, Sequence, Size
from layoutkit.constraints.dressing import dressed
from layoutkit.documents import layout_bytes
from layoutkit.hooks import Outcome
from layoutkit.model import Block, Box, Extent, Footprint, Layout, Mass, Measure, RegionSet, Word, place
from layoutkit.samples import find_sample
from layoutkit_relayout.stage import Relayout, RelayoutOptions

S, W = RegionSet.parse, Word.parse
FREE: tuple[Constraint, ...] = (
    *(Sequence(within=("H",), word=W(word)) for word in ("⊢ F", "F F", "F G ⊣")),
    *(Sequence(within=("H/F",), word=W(word)) for word in ("⊢ P W", "P W P", "W P ⊣")),
    *(Sequence(within=("H/G",), word=W(word)) for word in ("⊢ P {W D}", "P {W D} P", "{W D} P ⊣")),
    Size(of=S("@Floor"), min=Measure(0.85, True), max=Measure(1.2, True)),
    Size(of=S("@Pier"), min=Measure(0.6, True), max=Measure(1.6, True)),
    Size(of=S("@Bay"), min=Measure(0.8, True), max=Measure(1.2, True)),
)
#: A house with a lower wing, and a tower that begins on top of it.
MASS = Mass(
    (
        Block(name="House", width=12.0, depth=8.0, height=9.5),
        Block(name="Wing", x=12.0, width=7.0, depth=8.0, height=6.5),
        Footprint(name="Tower", points=((2, 2), (7, 2), (7, 6), (2, 6)), height=6.5, base=9.5),
    )
)


def outcomes(*rules: Constraint, mass: Mass = MASS, **options: Any) -> Iterator[Outcome]:
    return Relayout().run(dressed(design(*FREE, *rules), mass), RelayoutOptions(**options))


def layouts(*rules: Constraint, **options: Any) -> list[Layout]:
    found = [outcome.document for outcome in outcomes(*rules, **options)]
    assert all(isinstance(layout, Layout) for layout in found)
    return found  # type: ignore[return-value]  # as just asserted


def spans(layout: Layout, symbol: str) -> set[tuple[float, float]]:
    """Foot and top of all regions of a symbol, on all faces."""
    found = (p.box for p in place(layout.root) if p.region.symbol == symbol)
    return {(round(box.y0, 6), round(box.y1, 6)) for box in found}


def test_every_face_has_the_size_that_the_mass_gives_it() -> None:
    for layout in layouts(count=3):
        faces = [p.box for p in place(layout.root) if p.path.count("/") == 1]
        assert [tuple(box) for box in faces] == [pytest.approx(tuple(box)) for box in MASS.boxes]
        assert layout.violations() == ()


def test_one_door_is_one_in_the_whole_building() -> None:
    one = Frequency(of=S("@Door"), within="H", min=Measure(1.0), max=Measure(1.0), scope="building")
    found = layouts(one, count=4)
    doors = [[p.path for p in place(layout.root) if p.region.symbol == "Door"] for layout in found]
    assert [len(paths) for paths in doors] == [1] * 4


def test_one_door_on_each_face_is_one_for_each() -> None:
    one = Frequency(of=S("@Door"), within="H", min=Measure(1.0), max=Measure(1.0))
    (layout,) = layouts(one, count=1)
    doors = [p.path.split("/")[1] for p in place(layout.root) if p.region.symbol == "Door"]
    assert sorted(doors) == sorted(face.name for face in MASS.faces)


def test_storeys_are_level_all_round_and_above_one_another() -> None:
    level = Alignment(first=S("@Floor"), second=S("@Floor"), lines=("top", "bottom"), scope="building")
    alike = SameSize(first=Extent(S("H/F")), dimension="height", scope="building")
    (layout,) = layouts(level, alike, count=1)
    feet = sorted({*spans(layout, "F"), *spans(layout, "G")})
    for one in feet:
        assert not [other for other in feet if other != one and one[0] < other[0] < one[1] - 1e-6]
    assert len({round(top - foot, 5) for foot, top in spans(layout, "F")}) == 1


def test_what_faces_have_no_room_for_is_proved() -> None:
    many = Frequency(of=S("@Door"), within="H", min=Measure(100.0), scope="building")
    assert [outcome.status for outcome in outcomes(many, count=1)] == ["infeasible"]
    low = Mass((Block(width=8.5, depth=6.0, height=4.0),))
    assert [outcome.status for outcome in outcomes(mass=low, count=1)] == ["infeasible"]


def test_a_variation_is_the_same_whichever_others_are_made() -> None:
    many, (one,) = layouts(count=3, seed=5), layouts(count=1, first=2, seed=5)
    assert layout_bytes(many[2]) == layout_bytes(one)
    assert layout_bytes(many[0]) != layout_bytes(many[1])


def test_the_sample_is_put_on_its_mass(tmp_path: Path, layoutkit: Callable[..., Any]) -> None:
    sample = find_sample("block")
    run = layoutkit("vary", sample.path, "--mass", sample.mass, "-n", 2, "-o", tmp_path / "out", "--json")
    assert (run.code, run.data["status"]) == (0, "found")
    for variation in run.data["variations"]:
        assert layoutkit("validate", variation["layout"]).code == 0
        assert layoutkit("render", variation["layout"], "-o", tmp_path / "building.glb").code == 0
    regions = layoutkit("inspect", variation["layout"], "--json").data["regions"]
    assert sum(region["symbol"] == "Door" for region in regions) == 1
    boxes = {region["path"]: Box(*region["box"]) for region in regions}
    assert boxes["Building/Wing_South"].height == pytest.approx(11.4)
    assert (tmp_path / "out" / "sheet.png").is_file()
