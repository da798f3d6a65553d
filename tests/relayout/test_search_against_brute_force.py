"""The search finds every arrangement that brute force finds, and no other; what it proves is so."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import count
from pathlib import Path

import pytest
from oracle import Doubtful, TooMany, Tree, arrangements
from tiny_models import errors, tiny

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.model import Extent, Layout, Measure, Region, RegionSet, Word
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.search.wishes import granted

#: Far more words than any tiny model has.
PLENTY = 100_000
#: Combinations of words and replicas that brute force takes on.
MOST = 120
#: Models are judged in chunks, so that several workers can share them.
CHUNKS = 6
#: Of those judged, so many at least are feasible, and so many infeasible.
LEAST_SHARE = 0.2
#: Of all, so many at the most stand on a knife's edge.
MOST_DOUBTFUL = 0.05


def tree(region: Region) -> Tree:
    return region.symbol, tuple(map(tree, region.children))


def tree_of(words: Mapping[str, tuple[str, ...]], path: str) -> Tree:
    """Return the arrangements that the search names by path; it tells instances apart by ``~2``, ``~3``."""
    symbol = path.rpartition("/")[2].partition("~")[0]
    return symbol, tuple(tree_of(words, f"{path}/{child}") for child in words.get(path, ()))


def judge(seed: int) -> str:
    """Compare the search with brute force; return what both say, or why brute force says nothing."""
    facade, size = tiny(seed)
    try:
        expected = arrangements(facade, size, MOST)
    except (Doubtful, TooMany) as silent:
        return type(silent).__name__
    wishes = granted(facade, size, BACKENDS, PLENTY)
    assert wishes.undecided == (), f"tiny({seed})"
    search = wishes.search
    found = [frozenset(words.items()) for words in search.arrangements(PLENTY)]
    assert len(found) == len(set(found)), f"tiny({seed}): an arrangement is found twice"
    assert {tree_of(dict(words), facade.root.symbol) for words in found} == expected, f"tiny({seed})"
    status = "found" if expected else "infeasible"
    for index in range(2):
        variation = search.variation(seed, index, PLENTY)
        assert variation.status == status, f"tiny({seed})"
        if variation.root is not None:
            layout = Layout("tiny", "m", variation.root, facade)
            assert layout.violations() == (), f"tiny({seed})"
            assert tree(variation.root) in expected, f"tiny({seed})"
    return status


def judge_some(models: int, first_seed: int) -> Counter[str]:
    """Go on until the two agree on so many models, of which both kinds are a good part."""
    told: Counter[str] = Counter()
    with single_threaded():
        for seed in count(first_seed):
            told[judge(seed)] += 1
            if told["found"] + told["infeasible"] == models:
                break
    assert min(told["found"], told["infeasible"]) >= LEAST_SHARE * models, told
    assert told["Doubtful"] <= MOST_DOUBTFUL * told.total(), told
    print(first_seed, told)
    return told


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_three_hundred_tiny_models(chunk: int) -> None:
    judge_some(300 // CHUNKS, 1_000 * chunk)


@pytest.mark.nightly
@pytest.mark.parametrize("chunk", range(40))
def test_ten_thousand_tiny_models(chunk: int) -> None:
    judge_some(10_000 // 40, 10_000 + 1_000 * chunk)


#: Values that a comparison with brute force would say little without, by kind and attribute.
WANTED = {
    "size": {"min": {"absolute", "relative", None}, "max": {"absolute", "relative", None}},
    "frequency": {"min": {"absolute", "relative", None}, "max": {"absolute", "relative", None}},
    "instances": {"min": {"absolute", "relative", None}, "max": {"absolute", "relative", None}},
    "alignment": {
        "lines": {"left", "center", "right", "top", "middle", "bottom", "two"},
        "within": {None, "given"},
        **{f"{side}-{where}": {None, "⊢" if where == "before" else "⊣", "regions"}
           for side in ("first", "second") for where in ("before", "after")},
    },
    "same-size": {
        "first": {"set", "run"},
        "second": {None, "set", "run"},
        "dimension": {"width", "height"},
        "within": {None, "given"},
        "first-before": {None, "⊢", "regions"},
        "second-after": {None, "⊣", "regions"},
    },
    "symmetry": {"pairs": {"none", "some"}},
    "lock": {
        "keep": {"place", "size", "inside", "two"},
        "anchor": {"left", "center", "right", "top", "middle", "bottom", "two"},
    },
}  # fmt: skip
WANTED["size"] |= {"distribution": {"normal", "uniform", "triangular"}, "bias": {"none", "some"}}
SETS = {"@label", "path/*", "|", "&", "-"}


def values(constraint: Constraint) -> Iterator[tuple[str, object]]:
    """Yield attributes with the kinds of values that are told apart."""
    for attribute in constraint.attributes():
        value = getattr(constraint, attribute.field_name)
        match value:
            case Measure():
                yield attribute.name, "relative" if value.relative else "absolute"
            case Word():
                yield attribute.name, "regions" if value.sets else str(value)
            case Extent():
                yield attribute.name, "run" if value.word is not None else "set"
            case (str(), *_):
                yield from ((attribute.name, own) for own in value)
                yield attribute.name, "two" if len(value) > 1 else "one"
            case tuple() | float():
                yield attribute.name, "some" if value else "none"
            case str() if attribute.name == "within":
                yield attribute.name, "given"
            case _:
                yield attribute.name, value


def written(regions: RegionSet) -> Iterator[str]:
    """Yield which signs a set is written with."""
    text = str(regions)
    signs = {"@": "@label", "/*": "path/*", "|": "|", " & ": "&", " - ": "-"}
    yield from (meaning for sign, meaning in signs.items() if sign in text)


def test_the_tiny_models_have_something_of_everything() -> None:
    """Else the comparison above would say little."""
    kinds: Counter[str] = Counter()
    soft: Counter[str] = Counter()
    seen: Counter[tuple[str, str, object]] = Counter()
    sets: Counter[str] = Counter()
    shapes = set()
    for seed in range(1000):
        facade, _ = tiny(seed)
        shapes.add(sum(region.split is not None for region in facade.regions.values()))
        kinds.update({constraint.kind for constraint in facade.constraints})
        soft.update({constraint.kind for constraint in facade.constraints if constraint.soft})
        for constraint in facade.constraints:
            assert not errors(constraint, facade), f"tiny({seed})"
            seen.update((constraint.kind, *value) for value in values(constraint))
            for own in (getattr(constraint, name, None) for name in ("of", "first", "second")):
                sets.update(written(own) if isinstance(own, RegionSet) else ())
    assert shapes == {1, 2, 3, 4}
    assert set(kinds) == {kind.kind for kind in BUILT_IN}
    assert min(kinds.values()) >= 40, kinds
    assert set(soft) == {kind.kind for kind in BUILT_IN if kind.soft is Constraint.soft}
    assert min(soft.values()) >= 10, soft
    for kind, attributes in WANTED.items():
        for name, wanted in attributes.items():
            assert wanted <= {value for k, n, value in seen if (k, n) == (kind, name)}, (kind, name)
    assert set(sets) >= SETS
    assert min(sets.values()) >= 20, sets


def test_brute_force_shares_nothing_with_the_search() -> None:
    for source in Path(__file__).parent.glob("oracle*.py"):
        text = source.read_text()
        assert "layoutkit.sizing" not in text
        assert "layoutkit_relayout" not in text
