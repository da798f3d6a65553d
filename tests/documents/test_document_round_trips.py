"""Reading what was written gives the model, and writing what was read gives the bytes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from layoutkit.constraints import (
    BUILT_IN,
    Alignment,
    Constraint,
    Frequency,
    Instances,
    Lock,
    SameArrangement,
    SameSize,
    Sequence,
    Size,
    Symmetry,
)
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.documents import check, facade_bytes, layout_bytes, read, save, schema
from layoutkit.model import Extent, Facade, Layout, Measure, Picture, Region, RegionSet, Split, Word

KINDS = {kind.kind: kind for kind in BUILT_IN}
SCHEMA = etree.XMLSchema(etree.fromstring(schema(KINDS)))

#: What XML can hold: no control characters, no halves of surrogate pairs.
TEXT = st.text(
    st.characters(codec="utf-8", exclude_categories=["Cc", "Cs"], exclude_characters="\ufffe\uffff")
)
WORDS = st.text(st.sampled_from("abZ_é木1"), min_size=1, max_size=4).filter(lambda s: not s[0].isdigit())
SIZES = st.floats(1e-3, 1e6, allow_nan=False)


@st.composite
def regions(draw: st.DrawFn, symbol: str, size: Mapping[str, float], depth: int) -> Region:
    """A region of that size; its children tile it as exactly as floats can."""
    width, height = size["width"], size["height"]
    labels = tuple(draw(st.lists(WORDS, max_size=2, unique=True)))
    split: Split | None = draw(st.sampled_from(("columns", "rows", None))) if depth else None
    if split is None:
        return Region(symbol, width, height, labels=labels, fill=draw(st.sampled_from(("stretch", "repeat"))))
    along = "width" if split == "columns" else "height"
    shares = draw(st.lists(st.integers(1, 9), min_size=1, max_size=3))
    symbols = draw(st.lists(WORDS, min_size=len(shares), max_size=len(shares), unique=True))
    kinds = [
        draw(regions(name, {**size, along: size[along] * share / sum(shares) / 2}, depth - 1))
        for name, share in zip(symbols, shares, strict=True)
    ]
    # Every kind twice: half as large, and replicated.
    return Region(symbol, width, height, split, tuple(draw(st.permutations(kinds * 2))), labels)


@st.composite
def roots(draw: st.DrawFn) -> Region:
    size = {"width": draw(SIZES), "height": draw(SIZES)}
    return draw(regions(draw(WORDS), size, 3))


PICTURES = st.none() | st.builds(
    lambda file, x, y, w, h: Picture(file, (x, y, x + w, y + h)),
    TEXT,
    *[st.floats(0, 1e4)] * 2,
    *[st.floats(1e-3, 1e4)] * 2,
)
COMMENTS = st.lists(TEXT.map(lambda t: " ".join(t.split())).filter(bool), max_size=2).map("\n".join)
WEIGHTS, LIKELY = st.none() | st.floats(1e-9, 1e9), st.floats(1e-9, 1e9)
#: A range that holds every size in use.
ENDS = {"min": st.just(Measure(0.0)), "max": st.just(Measure(1e9))}
MEASURES = st.builds(Measure, st.integers(0, 10**6).map(lambda n: n / 1000), st.booleans())


def constraints_of(facade: Facade) -> st.SearchStrategy[Constraint]:
    """Constraints of every kind that speak of the facade's own regions."""
    paths = st.sampled_from(list(facade.regions))
    names = st.sampled_from([*facade.regions, *(f"@{label}" for label in sorted(facade.labels))])
    sets = st.recursive(
        names.map(RegionSet),
        lambda inner: st.builds(RegionSet, st.just(""), st.sampled_from("|&-"), inner, inner),
        max_leaves=3,
    )
    lines, width = st.just(("left", "right")), st.just("width")
    within = st.none() | paths
    extents = sets.map(Extent)
    keep, anchor = (
        st.sampled_from([("place",), ("size", "place")]),
        st.sampled_from([("top",), ("right", "top")]),
    )
    some: list[st.SearchStrategy[Constraint]] = [
        st.builds(Size, of=sets, centre=MEASURES, deviation=MEASURES, comment=COMMENTS, weight=WEIGHTS),
        st.builds(Size, of=sets, distribution=st.just("uniform"), **ENDS),
        st.builds(Size, of=sets, bias=st.floats(-1, 1), distribution=st.just("triangular"), **ENDS),
        st.builds(Lock, of=sets, keep=keep, anchor=anchor, comment=COMMENTS, weight=WEIGHTS),
        st.builds(Alignment, first=sets, second=sets, lines=lines, within=within, comment=COMMENTS),
        st.builds(SameSize, first=extents, second=st.none() | extents, dimension=width, comment=COMMENTS),
    ]
    for path, region in facade.regions.items():
        if "/" in path:
            some += [st.builds(Instances, of=st.just(RegionSet(path)), min=MEASURES, weight=WEIGHTS)]
        if not region.terminal:
            child = RegionSet(f"{path}/{region.word[0]}")
            inside = st.sampled_from(region.word).map(RegionSet)
            maximum = st.none() | MEASURES
            some += [
                st.builds(Frequency, of=inside, within=st.just(path), max=maximum, comment=COMMENTS),
                st.builds(
                    Sequence,
                    within=_of_type(Sequence, "within", path),
                    word=words(region.word),
                    weight=LIKELY,
                ),
                st.builds(Symmetry, of=st.just((path,)), pairs=pairs(region.word), weight=WEIGHTS),
                st.builds(Lock, of=st.just(RegionSet(path)), keep=st.just(("inside",))),
                st.builds(
                    Alignment,
                    first=st.just(child),
                    second=sets,
                    lines=lines,
                    first_before=contexts("⊢", region.word),
                    first_after=contexts("⊣", region.word),
                ),
                st.builds(
                    SameSize,
                    first=extents,
                    second=st.just(Extent(child)),
                    dimension=width,
                    second_before=contexts("⊢", region.word),
                    second_after=contexts("⊣", region.word),
                ),
                st.builds(SameArrangement, of=st.just((path, path))),
            ]
    return st.one_of(some)


def words(symbols: tuple[str, ...]) -> st.SearchStrategy[Word]:
    some = st.lists(st.sampled_from(symbols), min_size=1, max_size=3).map(RegionSet.union)
    return st.builds(Word, st.lists(some, min_size=1, max_size=3).map(tuple), st.booleans(), st.booleans())


@st.composite
def contexts(draw: st.DrawFn, end: str, symbols: tuple[str, ...]) -> Word | None:
    """What may stand beside a region: symbols, its parent's end, both, or anything."""
    sets = tuple(draw(st.lists(st.sampled_from(symbols).map(RegionSet), max_size=2)))
    at_end = draw(st.booleans())
    return Word(sets, at_end and end == "⊢", at_end and end == "⊣") if sets or at_end else None


@st.composite
def pairs(draw: st.DrawFn, symbols: tuple[str, ...]) -> tuple[tuple[str, str], ...]:
    """Some symbols in pairs, none twice."""
    mixed = draw(st.permutations(sorted(set(symbols))))
    found = list(zip(mixed[::2], mixed[1::2], strict=False))
    return tuple(found[: draw(st.integers(0, len(found)))])


def _of_type(kind: type[Constraint], name: str, text: str) -> st.SearchStrategy[object]:
    return st.just(next(a for a in kind.attributes() if a.name == name).type.parse(text))


@st.composite
def facades(draw: st.DrawFn) -> Facade:
    facade = Facade(draw(TEXT), draw(st.sampled_from(("m", "px"))), draw(roots()), draw(PICTURES))
    return replace(facade, constraints=tuple(draw(st.lists(constraints_of(facade), max_size=4))))


def _read(data: bytes) -> Facade | Layout:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "document.xml"
        save(path, data)
        return read(path, KINDS).model


@given(facades())
def test_facades(facade: Facade) -> None:
    data = facade_bytes(facade)
    again = _read(data)
    assert again == facade
    assert isinstance(again, Facade)
    assert [c.comment for c in again.constraints] == [_as_kept(c.comment) for c in facade.constraints]
    assert facade_bytes(again) == data
    assert SCHEMA.validate(etree.fromstring(data)), SCHEMA.error_log


def _as_kept(comment: str) -> str:
    """Two hyphens would end an XML comment: a space parts them."""
    while "--" in comment:
        comment = comment.replace("--", "- -")
    return comment


@given(
    st.builds(
        Layout,
        TEXT,
        st.just("px"),
        roots(),
        seed=st.none() | st.integers(0, 2**128 - 1),
        index=st.none() | st.integers(0, 99),
        picture=PICTURES,
    )
)
def test_layouts(layout: Layout) -> None:
    data = layout_bytes(layout)
    again = _read(data)
    assert again == layout
    assert isinstance(again, Layout)
    assert layout_bytes(again) == data
    assert SCHEMA.validate(etree.fromstring(data)), SCHEMA.error_log


def test_replicas_share_one_region_and_instances_do_not(tmp_path: Path) -> None:
    one, other = Region("A", 1.0, 2.0), Region("A", 3.0, 2.0)
    layout = Layout("l", "m", Region("F", 9.0, 2.0, "columns", (one, one, other, other, one)))
    data = layout_bytes(layout)
    assert [line.split()[0] for line in data.decode().splitlines()[3:-2]] == [
        "<region",
        "<again",
        "<region",
        "<again",
        "<region",
    ]
    save(tmp_path / "l.xml", data)
    found = read(tmp_path / "l.xml", KINDS).model
    assert found == layout
    children = found.root.children
    assert children[0] is children[1]
    assert children[2] is children[3]


def test_a_layout_knows_its_facade(tmp_path: Path) -> None:
    facade = Facade("f", "m", Region("F", 1.0, 1.0))
    layout = Layout("l", "m", Region("F", 2.0, 1.0), facade, "sub/f.xml", 7, 0)
    save(tmp_path / "l.xml", layout_bytes(layout))
    alone = read(tmp_path / "l.xml", KINDS)
    assert isinstance(alone.model, Layout)
    assert alone.model.facade is None
    assert [(d.code, d.severity) for d in alone.diagnostics] == [("LK504", Severity.WARNING)]
    (tmp_path / "sub").mkdir()
    save(tmp_path / "sub" / "f.xml", facade_bytes(facade))
    assert read(tmp_path / "l.xml", KINDS).model == layout
    assert read(tmp_path / "l.xml", KINDS).diagnostics == ()


def test_faults_of_the_facade_are_the_layouts(tmp_path: Path) -> None:
    save(tmp_path / "l.xml", layout_bytes(Layout("l", "m", Region("F", 2.0, 1.0), facade_file="f.xml")))
    save(tmp_path / "f.xml", b'<facade xmlns="urn:layoutkit:1" name="f" units="m"/>')
    with pytest.raises(Faulty) as raised:
        read(tmp_path / "l.xml", KINDS)
    assert [(d.code, d.place and Path(d.place.file).name) for d in raised.value.diagnostics] == [
        ("LK107", "f.xml")
    ]


@pytest.mark.parametrize(("name", "code"), [("l.xml", "LK505"), ("x.xml", "LK002"), ("y" * 300, "LK001")])
def test_what_is_no_facade(name: str, code: str, tmp_path: Path) -> None:
    save(tmp_path / "l.xml", layout_bytes(Layout("l", "m", Region("F", 2.0, 1.0), facade_file=name)))
    save(tmp_path / "x.xml", b"x")
    assert [d.code for d in check(tmp_path / "l.xml", KINDS)] == [code]


def test_comments_above_constraints() -> None:
    text = """<facade xmlns="urn:layoutkit:1" name="f" units="m"><region symbol="F" width="1" height="1"/>
    <constraints> <!-- behind the tag: still above -->
      <size of="F" min="1"/> <!-- behind an element: not the next one's -->
      <size of="F" min="2"/>
      <!-- a heading -->

      <!-- two
           lines -->
      <!-- and one -->
      <size of="F" min="3"/>
      <!-- parted -->

      <size of="F" min="4"/>
      <!-- last -->
    </constraints></facade>"""
    facade = _read(text.encode())
    assert isinstance(facade, Facade)
    comments = [constraint.comment for constraint in facade.constraints]
    assert comments == ["behind the tag: still above", "", "two\nlines\nand one", ""]


def test_unwritable_characters() -> None:
    with pytest.raises(Faulty, match="LK009"):
        facade_bytes(Facade("bell \a", "m", Region("F", 1.0, 1.0)))
    size = Size(of=RegionSet("F"), comment="half a pair \ud800")
    with pytest.raises(Faulty, match="LK009"):
        facade_bytes(Facade("f", "m", Region("F", 1.0, 1.0), constraints=(size,)))


def test_a_child_that_does_not_reach_across_cannot_be_written() -> None:
    with pytest.raises(ValueError, match="does not reach across"):
        facade_bytes(Facade("f", "m", Region("F", 1.0, 1.0, "columns", (Region("A", 1.0, 0.5),))))
