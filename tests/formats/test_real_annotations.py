"""Real annotations: agreement, few terminals, floors in line."""

from __future__ import annotations

import pytest
from annotated import DATA, check_exact, composites, shown
from PIL import Image

from layoutkit.model import place
from layoutkit_formats.boxes import in_painting_order, painted
from layoutkit_formats.cmp import CmpFormat, boxes_of

CMP = DATA / "cmp"

pytestmark = pytest.mark.skipif(not CMP.is_dir(), reason="the CMP facades are not beside the project")

#: Plain grids, several buildings, neighbours, pillars, a zero-size box, a staggered stair.
HANDFUL = ("b0012", "b0033", "b0055", "b0246", "b0086", "b0284", "b0318", "b0323")


@pytest.mark.parametrize("name", HANDFUL)
def test_real_facades_agree(name: str) -> None:
    file = CMP / f"cmp_{name}.xml"
    facade, remarks = CmpFormat().read(file, None)
    check_exact(facade)
    with Image.open(file.with_suffix(".jpg")) as picture:
        width, height = picture.size
    boxes = boxes_of(file, width, height, [])
    truth = painted(in_painting_order(boxes), width, height)
    assert (shown(facade, truth.shape) == truth).mean() > 0.95
    terminals = sum(placed.region.terminal for placed in place(facade.root))
    assert terminals < 4.5 * file.read_text().count("<object>")
    assert all(d.code.startswith("LK3") for d in remarks)
    if name == "b0284":
        assert "LK305" in {d.code for d in remarks}


def test_floors_in_line_share_their_strips() -> None:
    facade, _ = CmpFormat().read(CMP / "cmp_b0039.xml", None)
    floors = composites(facade, "Floor")
    words = [floor.word for floor in floors]
    assert max(words.count(word) for word in words) == 3
    shared = max(words, key=words.count)
    assert shared.count("Bay") == 5
    widths = {tuple(c.width for c in floor.children) for floor in floors if floor.word == shared}
    assert len(widths) == 1
