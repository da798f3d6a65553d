"""Layouts of any length are checked in little memory, and as thoroughly as small ones."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from unittest import mock

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.diagnostics import Diagnostic
from layoutkit.documents import Source, check, findings, parsing, read, regions
from layoutkit.documents import source as sources
from layoutkit.documents.document import open_document

Kinds = Mapping[str, type[Constraint]]
KINDS = {kind.kind: kind for kind in BUILT_IN}
HEAD = '<layout xmlns="urn:layoutkit:1" name="l" units="m">'
PIECES = (
    '<region symbol="A" width="1"/>',
    '<region symbol="B" width="2" labels="Window Bay"/>',
    '<region symbol="C" width="1.5" split="rows"><region symbol="A" height="1"/></region>',
    '<region symbol="D" width="1" split="rows"><region symbol="A" height="0.25"/>',
    '<again symbol="A"/>',
    '<again symbol="C"/>',
    "</region>",
    '<again symbol="none"><region symbol="A"/></again>',
    '<region symbol="E" width="1"><again symbol="A"/></region>',
    '<region symbol="G" width="1" split="columns"/>',
    '<region symbol="A" width="-1"/>',
    '<region symbol="A" height="1"/>',
    "<regoin symbol='A' width='1'/>",
    "<unknown><region/></unknown>",
    "text",
    "<!-- comment -->",
    "<![CDATA[x]]>",
    "\n",
)


def shown(found: list[Diagnostic]) -> list[str]:
    return [str(d) for d in found]


@given(st.lists(st.sampled_from(PIECES), max_size=25), st.integers(1, 50))
def test_neither_chunks_nor_what_is_kept_make_a_difference(pieces: list[str], chunk: int) -> None:
    root = '<region symbol="F" width="4" height="1" split="columns">'
    source = Source("x.xml", f"{HEAD}{root}{''.join(pieces)}</region></layout>".encode())
    found = check(source, KINDS)
    with mock.patch.object(sources, "CHUNK", chunk):
        assert shown(check(source, KINDS)) == shown(found)
    if found and found[0].code not in ("LK002",):
        assert shown(list(open_document(source, KINDS).diagnostics)) == shown(found)


def rows(number: int) -> str:
    """A layout of rows that are written out, though they are alike."""
    children = '<region symbol="A" width="1"/><again symbol="A"/>'
    row = f'<region symbol="R" height="1" split="columns">{children}</region>'
    return (
        f'{HEAD}<region symbol="F" width="2" height="{number}" split="rows">{row * number}</region></layout>'
    )


def test_like_regions_are_one_object(written: Callable[..., Path], kinds: Kinds) -> None:
    root = read(written(rows(50)), kinds).model.root
    assert len({id(child) for child in root.children}) == 1
    assert len({id(child) for row in root.children for child in row.children}) == 1


def test_of_many_faults_of_a_kind_the_first_are_told_and_the_others_counted(
    kinds: Kinds, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(findings, "KEPT", 3)
    text = rows(50).replace("<again", "\n<again").replace('<again symbol="A"/>', '<again symbol="B"/>')
    found = check(Source("x.xml", text.encode()), kinds)
    assert [(d.code, d.place and d.place.line) for d in found] == [("LK211", n) for n in range(2, 6)]
    assert (
        found[-1].message == "and 47 more of this kind, from here on: no earlier sibling has the symbol 'B'"
    )


def test_long_values_do_not_make_long_messages(kinds: Kinds) -> None:
    text = rows(1).replace('symbol="A" width="1"', f'symbol="A" width="{"x" * 100_000}"')
    (found,) = check(Source("x.xml", text.encode()), kinds)
    assert found.code == "LK106"
    assert len(found.message) < 3000
    assert " … " in found.message


def test_what_has_no_end_is_refused(kinds: Kinds, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parsing, "TOKEN_LIMIT", 1000)
    monkeypatch.setattr(sources, "CHUNK", 100)
    for long in (
        "<!--" + "c" * 2000 + "-->",
        '<region symbol="' + "A" * 2000 + '"/>',
        "<?pi " + "p" * 2000 + "?>",
    ):
        found = check(Source("x.xml", f"{HEAD}{long}</layout>".encode()), kinds)
        assert [d.code for d in found] == ["LK007"]
    fine = rows(1).replace("<again", "<!--" + "c" * 700 + "--><again")
    assert check(Source("x.xml", fine.encode()), kinds) == []


def test_replicas_beyond_what_is_written(kinds: Kinds, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(regions, "REPLICA_LIMIT", 10)
    row = '<region symbol="R" height="1" split="columns"><region symbol="A" width="1"/></region>'
    for repeated, codes in (
        (row * 30, []),
        (row * 25 + '<again symbol="R"/>' * 5, []),
        (row + '<again symbol="R"/>' * 29, ["LK006"]),
    ):
        text = f'{HEAD}<region symbol="F" width="1" height="30" split="rows">{repeated}</region></layout>'
        assert [d.code for d in check(Source("x.xml", text.encode()), kinds)] == codes


_CHILDREN = '<region symbol="A" width="1"/><region symbol="B" width="1"/>'
FACADE = f"""<facade xmlns="urn:layoutkit:1" name="f" units="m">
<region symbol="F" width="2" height="2" split="rows">
<region symbol="R" height="1" split="columns">{_CHILDREN}</region>
<region symbol="S" height="1" split="columns">{_CHILDREN}</region>
</region></facade>"""
LAYOUT = """<layout xmlns="urn:layoutkit:1" name="l" units="m" facade="facade.xml">
<region symbol="F" width="2" height="3" split="rows">
<region symbol="R" height="1" split="columns">
<region symbol="A" width="1"/>
<region symbol="X" width="1"/>
</region>
<again symbol="R"/>
<region symbol="R" height="1" split="columns">
<region symbol="A" width="2"/>
</region>
</region></layout>"""


def test_what_is_inside_a_replica_is_where_it_was_written(written: Callable[..., Path], kinds: Kinds) -> None:
    written(FACADE)
    found = check(written(LAYOUT, "layout.xml"), kinds)
    told = {d.message.partition(":")[0]: d.place.line for d in found if d.place}
    assert told["F/R/X"] == told["F/R.2/X"] == 5
    assert told["F"] == 2
    assert {8, 9} & set(told.values())


PROGRAM = """
import resource, sys
from layoutkit.constraints import BUILT_IN
from layoutkit.documents import check
found = check(sys.argv[1], {kind.kind: kind for kind in BUILT_IN})
assert len(found) <= 1001, len(found)
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024)
"""


@pytest.mark.parametrize("text", ["", "faulty", "foreign"])
def test_memory_does_not_grow_with_the_document(text: str, tmp_path: Path) -> None:
    memory = []
    for number in (10, 40_000):
        path = tmp_path / f"{number}.xml"
        whole = rows(number)
        if text == "faulty":
            whole = whole.replace('<again symbol="A"/>', '<again symbol="Nothing"/>')
        elif text == "foreign":
            whole = whole.replace("layout", "something")
        path.write_text(whole)
        done = subprocess.run(
            [sys.executable, "-c", PROGRAM, path], capture_output=True, text=True, check=True
        )
        memory.append(int(done.stdout))
    assert memory[1] < memory[0] + 12
