"""Symmetry: arrangements that read the same from both ends, in symbols and in sizes."""

from __future__ import annotations

from dataclasses import replace

import pytest
from houses import broken, house, with_rows

from layoutkit.constraints import Constraint, Instances, Sequence, Symmetry
from layoutkit.constraints.word_rules import Mirrored
from layoutkit.model import Facade, Region, RegionSet, Violation, Word
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import Range

SIZES = {"A": 1.0, "B": 2.0, "C": 0.5, "D": 3.0, "E": 2.0}
#: The example of Bao, Schwarz and Wonka 2013, section 5.1: B and E mirror each other.
PAIRED = Symmetry(of=("R",), pairs=(("B", "E"),))
FREE = Sequence(within=("R",), word=Word.parse("⊢ {A B C D E}"))
ANY = [FREE, Sequence(within=("R",), word=Word.parse("{A B C D E} {A B C D E}"))]
ANY.append(Sequence(within=("R",), word=Word.parse("{A B C D E} ⊣")))


def row(word: str, **sizes: float) -> Region:
    children = tuple(Region(s, {**SIZES, **sizes}[s], 1.0) for s in word)
    return Region("R", sum(c.width for c in children), 1.0, "columns", children)


def facade(*constraints: Constraint, word: str = "ABCDCEA") -> Facade:
    return Facade("f", "m", row(word), constraints=constraints)


def faulted(constraint: Constraint, root: Region, *others: Constraint) -> list[Violation]:
    found = broken(facade(constraint, *ANY, *others), root)
    return [v for v in found if v.constraint is constraint]


@pytest.mark.parametrize("word", ["ABCDCEA", "ABCECBEA"[:3] + "CEA", "BDE", "D", "AA", "EDB", "BE"])
def test_words_that_mirror_themselves(word: str) -> None:
    assert faulted(PAIRED, row(word)) == []


@pytest.mark.parametrize(
    ("word", "amount"),
    [("ABCDCBA", 1), ("BDB", 1), ("ABC", 2), ("B", 1), ("AB", 1), ("BAAE", 0), ("BACE", 1)],
)
def test_words_that_do_not(word: str, amount: int) -> None:
    """The amount is how many pairs of places do not mirror each other."""
    found = faulted(PAIRED, row(word))
    assert [(v.path, v.amount) for v in found] == [("R", float(amount))] * bool(amount)
    assert all(f"{' '.join(word)!r} does not mirror itself" in v.message for v in found)


def test_partners_of_different_sizes() -> None:
    (found,) = faulted(PAIRED, row("ABCDCEA", E=2.25))
    assert (found.path, found.amount) == ("R", 0.25)
    assert found.message == "B and E mirror each other, of sizes 2 and 2.25"
    assert faulted(PAIRED, row("ABCDCEA", D=9.0)) == [], "the middle mirrors itself, whatever its size"


def test_instances_of_one_symbol_mirror_each_other_in_size() -> None:
    """Without replicas, the sizes of one symbol are not the same by themselves."""
    constraint = Symmetry(of=("R",))
    varied = Instances(of=RegionSet("R/A"))
    one, other = Region("A", 1.0, 1.0), Region("A", 1.5, 1.0)
    wall = Region("C", 0.5, 1.0)
    root = Region("R", 6.0, 1.0, "columns", (one, wall, other, wall, other, wall, one))
    assert faulted(constraint, root, varied) == []
    root = replace(root, children=(one, wall, one, wall, other, wall, other))
    assert [v.amount for v in faulted(constraint, root, varied)] == [0.5, 0.5]


def test_each_region_by_itself() -> None:
    constraint = Symmetry(of=("H/F", "H/G"))
    given = house(constraint, Sequence(within=("H/F", "H/G"), word=Word.parse("⊢ P {P B} B P ⊣")))
    from houses import floor

    cornice = Region("C", 6.0, 0.5, labels=("Cornice",))
    root = with_rows(
        given, cornice, floor("F", "PBBP"), floor("F", "PPBP", widths={"P": 4 / 3}), floor("G", "PBBP")
    )
    found = [v for v in broken(given, root) if v.constraint is constraint]
    assert [v.path for v in found] == ["H/F.2"]


def test_the_word_rule_names_every_partner() -> None:
    assert list(Symmetry.word_rules([PAIRED], facade(PAIRED))) == [
        Mirrored(
            "R",
            {a: (b,) for a, b in {"A": "A", "B": "E", "C": "C", "D": "D", "E": "B"}.items()},
            (PAIRED,),
            equal=True,
        )
    ]


def test_partners_are_equally_large_once_for_each_pair() -> None:
    given = facade(PAIRED, word="BAECBAE")
    arrangement = Arrangement(given, {"R": tuple("BAECBAE")})
    (rule,) = PAIRED.size_rules(arrangement)
    assert isinstance(rule, Range)
    assert (rule.axis, rule.least, rule.most, rule.origin) == (0, 0.0, 0.0, PAIRED)
    sizes = [arrangement.extent(f"R/{symbol}", 0) for symbol in "BE"]
    ((one, factor),), ((other, _),) = (form.items() for form in sizes)
    assert factor == 1.0
    assert sorted(rule.form.items()) in (
        sorted({one: 1.0, other: -1.0}.items()),
        sorted({one: -1.0, other: 1.0}.items()),
    )


def test_a_region_that_no_word_reaches_is_not_asked() -> None:
    assert list(PAIRED.size_rules(Arrangement(facade(PAIRED), {}))) == []
