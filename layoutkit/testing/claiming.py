"""Promises about claims: what a constraint says of itself beforehand follows from what it demands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain, islice

from layoutkit.constraints.answers import violations_of
from layoutkit.constraints.claims import EquallyLarge, InLine, Permits, Sized, claims_of, permitted
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Admits
from layoutkit.model import PlacedRegion
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import BOTH, Convex, Form, Quantity, Range, Rows, SizeRule
from layoutkit.testing.agreement import Trial
from layoutkit.testing.finding import Finding
from layoutkit.testing.sampling import Sample

#: So many layouts are looked at.
_LOOKED_AT = 150
#: Sizes are off from this share of the facade's size on, and regions overlap.
_OFF = 1e-5


def claims(trial: Trial) -> Iterator[Finding]:
    """Yield claims that a layout without violations does not keep."""
    kept = (sample for sample in trial.samples if not trial.violations(sample))
    for sample in islice(kept, _LOOKED_AT):
        view = sample.view
        for constraint in trial.subject.constraints:
            for claim in claims_of(constraint, trial.subject.facade):
                if wrong := _wrong(claim, view):
                    message = f"claims() claims what a layout without violations does not keep: {wrong}"
                    yield trial.finding("claims", message, sample)
    for constraint in trial.subject.constraints:
        admitted = {rule.path for rule in trial.word_rules if isinstance(rule, Admits)}
        for claim in claims_of(constraint, trial.subject.facade):
            if isinstance(claim, Permits) and claim.path not in admitted:
                message = (
                    f"claims() permits arrangements of {claim.path}, and word_rules() does not say which"
                )
                yield Finding("claims", message, str(trial.subject))


def _wrong(claim: object, view: LayoutView) -> str:
    """Say in what a layout does not keep a claim; empty if it does."""
    off = _OFF * max(view.layout.root.width, view.layout.root.height)
    if isinstance(claim, Sized):
        for placed in view.places(claim.path):
            size = _along(placed, view)
            if not claim.least - off <= size <= claim.most + off:
                return f"{placed.path} is {size:g}, not between {claim.least:g} and {claim.most:g}"
    elif isinstance(claim, InLine) and claim.within is None:
        return _out_of_line(claim, view, off)
    elif isinstance(claim, EquallyLarge) and claim.within is None:
        regions = [extent.regions for extent in claim.extents if extent.regions is not None]
        if len(regions) == len(claim.extents):
            paths = chain.from_iterable(view.facade.select(own) for own in regions)
            sizes = [_size(placed, claim.axis) for path in paths for placed in view.places(path)]
            if sizes and max(sizes) - min(sizes) > off:
                return f"sizes from {min(sizes):g} to {max(sizes):g} are not equal"
    return ""


def _size(placed: PlacedRegion, axis: int) -> float:
    return (placed.box.width, placed.box.height)[axis]


def _along(placed: PlacedRegion, view: LayoutView) -> float:
    from layoutkit.constraints.size import axis_of

    return _size(placed, axis_of(view.facade, placed.symbol_path))


def _out_of_line(claim: InLine, view: LayoutView, off: float) -> str:
    first, second = (
        [p for path in paths for p in view.places(path)] for paths in (claim.first, claim.second)
    )
    for one in first:
        for other in second:
            (start, end), (begin, stop) = (view.interval(p.box, claim.axis) for p in (one, other))
            if one is other or min(end, stop) - max(start, begin) <= off:
                continue
            gaps = [abs((1 - s) * (start - begin) + s * (end - stop)) for s in claim.shares]
            if max(gaps) > off:
                return f"{one.path} and {other.path} overlap, and are out of line by {max(gaps):g}"
    return ""


def parts(trial: Trial) -> Iterator[Finding]:
    """Yield layouts of which a constraint, and its parts together, do not think the same."""
    facade = trial.subject.facade
    for constraint in trial.subject.constraints:
        pieces = tuple(constraint.parts(facade).values())
        if not pieces or permitted(constraint, facade):  # permissions count together with others only
            continue
        others = (c for c in facade.constraints if c is not constraint)
        divided = replace(facade, constraints=(*others, *pieces))
        for sample in islice(trial.samples, _LOOKED_AT):
            view, other = sample.view, LayoutView(sample.view.layout, divided)
            whole = any(violations_of(constraint, view))
            if whole != any(violation for piece in pieces for violation in violations_of(piece, other)):
                verb = "finds fault with" if whole else "has no objection to"
                message = f"violations() {verb} a layout, and its parts() together think otherwise"
                yield trial.finding("claims", message, sample)


def relations(trial: Trial) -> Iterator[Finding]:
    """Yield rules that relate several sizes, where it is said that none does, or in another way."""
    for constraint in trial.subject.constraints:
        related = constraint.relations(trial.subject.facade)
        if related is None:
            continue
        nothing = not tuple(related)
        admitted = (sample for sample in trial.chance if not trial.misses_of_words(sample))
        for sample in islice(admitted, _LOOKED_AT):
            if any(rule.axis == BOTH for rule in constraint.size_rules(sample.arrangement)):
                message = (
                    "relations() is not None, and a rule relates widths to heights: counts would be wrong"
                )
                yield trial.finding("claims", message, sample)
                break
            if nothing and (rule := _relating(constraint, sample)):
                message = f"relations() says that no rule relates sizes; one does: {rule}"
                yield trial.finding("claims", message, sample)
                break


def _relating(constraint: Constraint, sample: Sample) -> SizeRule | None:
    """Return a rule on sizes that is not about one region's own size."""
    extents = _extents(sample.arrangement)
    for rule in constraint.size_rules(sample.arrangement):
        if isinstance(rule, Range) and (rule.axis, _direction(rule.form)) not in extents:
            return rule
        if isinstance(rule, Rows | Convex) and not _single(rule.quantities, extents):
            return rule
    return None


def _single(quantities: Sequence[Quantity], extents: set[tuple[int, object]]) -> bool:
    return len(quantities) == 1 and (quantities[0].axis, _direction(quantities[0].form)) in extents


def _extents(arrangement: Arrangement) -> set[tuple[int, object]]:
    return {
        (axis, _direction(frame.extent[axis])) for frame in arrangement.frames.values() for axis in (0, 1)
    }


def _direction(form: Form) -> object:
    """Return a form up to a factor."""
    first = next(iter(sorted(form.items())), (0, 1.0))[1]
    return tuple((variable, round(factor / first, 9)) for variable, factor in sorted(form.items()))
