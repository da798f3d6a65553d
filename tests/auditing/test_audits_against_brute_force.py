"""What the audit calls impossible is so; what it says cannot matter does not: by brute force."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from itertools import count

import pytest
from oracle import Doubtful, TooMany, Tree, arrangements
from tiny_models import errors, tiny

from layoutkit.constraints import Constraint, SameSize
from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.model import Facade
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.auditing.stage import Audit, AuditOptions

#: Combinations of words and replicas that brute force takes on.
MOST = 120
#: Models are judged in chunks, so that several workers can share them.
CHUNKS, MODELS = 2, 30


def placed(facade: Facade) -> Facade:
    """Return the facade with a line of its own for each constraint, by which diagnostics name it."""
    own = tuple(replace(c, place=Place("tiny.xml", n)) for n, c in enumerate(facade.constraints, 1))
    return replace(facade, constraints=own)


def audited(facade: Facade) -> tuple[Diagnostic, ...]:
    (outcome,) = Audit().run(facade, AuditOptions())
    return outcome.diagnostics


def paths(tree: Tree, above: str = "") -> Iterator[str]:
    """Yield the symbol path of every region in a layout."""
    path = f"{above}{tree[0]}"
    yield path
    for child in tree[1]:
        yield from paths(child, f"{path}/")


def without(facade: Facade, diagnostic: Diagnostic) -> Facade | None:
    """Return the facade without what is said to ask nothing; None if others then mean something else."""
    left: list[Constraint] = []
    for constraint in facade.constraints:
        if constraint.place != diagnostic.place:
            left.append(constraint)
        elif isinstance(constraint, SameSize) and diagnostic.code == "LK230":
            left += one_side(constraint, "of second" if " of first" in diagnostic.message else "of first")
    fewer = replace(facade, constraints=tuple(left))
    same = spoken(fewer.constraints) == spoken(facade.constraints)
    return fewer if same and not any(errors(constraint, fewer) for constraint in left) else None


def one_side(constraint: SameSize, side: str) -> list[Constraint]:
    """Return what an equality asks of one of its extents alone."""
    alone = replace(constraint, second=None, second_before=None, second_after=None)
    if side == "of first":
        return [alone]
    if constraint.second is None:
        return []
    before, after = constraint.second_before, constraint.second_after
    return [replace(alone, first=constraint.second, first_before=before, first_after=after)]


def spoken(constraints: tuple[Constraint, ...]) -> set[str]:
    """Return which regions have arrangements, sizes or instances stated: others have them by default."""
    told = ("within", "of")
    return {
        f"{type(c).__name__} {getattr(c, name)}"
        for c in constraints
        if c.kind in ("size", "instances", "sequence", "replication", "repetition", "two-shuffle", "reuse")
        for name in told
        if hasattr(c, name)
    }


def judge(seed: int) -> Counter[str]:
    """Compare what the audit says of a model with brute force; return what was compared."""
    facade, size = tiny(seed)
    facade, own = placed(facade), (facade.root.width, facade.root.height)
    told = audited(facade)
    assert audited(facade) == told, f"tiny({seed}): two audits differ"
    if not told:
        return Counter()
    try:
        return _compared(seed, facade, {size, own}, told)
    except (Doubtful, TooMany):
        return Counter()


def _compared(
    seed: int, facade: Facade, sizes: set[tuple[float, float]], told: tuple[Diagnostic, ...]
) -> Counter[str]:
    own = (facade.root.width, facade.root.height)
    found = {size: arrangements(facade, size, MOST) for size in sorted(sizes)}
    present = {path for trees in found.values() for tree in trees for path in paths(tree)}
    seen: Counter[str] = Counter()
    for diagnostic in told:
        about = f"tiny({seed}): {diagnostic}"
        if diagnostic.severity is Severity.ERROR:
            assert not any(found.values()), about
        elif diagnostic.code in ("LK224", "LK225", "LK226"):
            assert diagnostic.message.rpartition("; ")[2].split(" is in no")[0] not in present, about
        elif diagnostic.code == "LK227":
            assert not found[own], about
        elif diagnostic.code == "LK228":
            names, _, parent = diagnostic.message.partition(" that ")[0].partition(" stand")
            parent = diagnostic.message.partition(" that ")[2].removesuffix(" can have")
            for name in names.replace(" and ", ", ").split(", "):
                assert f"{parent}/{name}" not in present, about
        elif diagnostic.place is not None and (fewer := without(facade, diagnostic)):
            for size, trees in found.items():
                assert arrangements(fewer, size, MOST) == trees, about
        else:
            continue
        seen[f"{diagnostic.code} {diagnostic.severity}"] += 1
    return seen


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_what_the_audit_says_is_so(chunk: int) -> None:
    seen: Counter[str] = Counter()
    with single_threaded():
        for seed in range(chunk * 1000, chunk * 1000 + MODELS):
            seen += judge(seed)
    assert len(seen) >= 4, seen


@pytest.mark.nightly
def test_what_the_audit_says_of_many_models_is_so() -> None:
    seen: Counter[str] = Counter()
    with single_threaded():
        for seed in count(100_000):
            seen += judge(seed)
            if seen.total() >= 500:
                break
    print(seen)
    assert len(seen) >= 8, "all that the audit says was compared"
