"""Constraints and amounts in the user's names, short enough for a line of a diagnostic."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from layoutkit.constraints import Constraint, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.attributes import Attribute
from layoutkit.constraints.defaults import InputWord
from layoutkit.constraints.size import input_size
from layoutkit.model import Facade, Measure, Region, Word, place
from layoutkit.model.conflict import Amount
from layoutkit.model.measure import format_number
from layoutkit_relayout.explanation.bounds import COUNTS, End, end_of, ends_of
from layoutkit_relayout.explanation.units import Unit

#: Types of attributes that say what a constraint speaks of.
_SUBJECTS = ("regions", "members", "extent", "path", "paths")
#: Attributes that say how sizes are drawn, not what they must be.
_DRAWING = ("centre", "deviation", "distribution", "bias")
_ENDS: dict[End, str] = {"min": "at least", "max": "at most"}
#: Names and words listed one by one; further ones are only counted.
_LISTED = 2
_SYMBOLS = 9


def subject(unit: Unit, regions: Sequence[str], facade: Facade) -> str:
    """Return what a unit speaks of, e.g. ``size of Facade/B/C``.

    Parameters
    ----------
    regions
        The regions in question, where only some of the constraint's take part.
    """
    first = unit.constraints[0]
    if isinstance(first, InputWord):
        return f"arrangement of {unit.region}"
    if unit.region:
        plain = all(isinstance(source, SequenceConstraint) for source in unit.sources)
        return f"{'sequences' if plain else 'arrangements'} of {unit.region}"
    shown = {a.name: _text(a, first) for a in _said(first) if a.type.name in _SUBJECTS}
    if "of" in shown and 0 < len(regions) <= _LISTED:
        shown["of"] = " and ".join(regions)
    inside = [_text(a, first) for a in _said(first) if a.type.name == "enclosing path"]
    return f"{first.kind} of {' and '.join(shown.values())}" + "".join(f" in {path}" for path in inside)


def demand(unit: Unit, parts: Sequence[Constraint], facade: Facade) -> str:
    """Return what a unit asks, e.g. ``at least 1.20 m``.

    Parameters
    ----------
    parts
        What of it takes part in the conflict.
    """
    first = unit.constraints[0]
    if isinstance(first, InputWord):
        return f"as in the input: {_word(facade.regions[unit.region].word)}"
    if unit.region:
        return ", ".join(dict.fromkeys(_rule(source) for source in unit.sources))
    said = dict.fromkeys(_bound(part, end, facade) for part in parts for end in ends_of(part))
    return ", ".join([*said, *_further(first)])


def _rule(source: Constraint) -> str:
    return str(source.word) if isinstance(source, SequenceConstraint) else str(source)


def _bound(part: Constraint, end: End, facade: Facade) -> str:
    measure = end_of(part, end)
    assert measure is not None  # it is one of those that are stated
    if not isinstance(part, Size):
        return f"{_ENDS[end]} {measure}"
    sizes = {measure.of(input_size(facade, path)) for path in facade.select(part.of)}
    if len(sizes) > 1:
        return f"{_ENDS[end]} {measure}"
    absolute = length(sizes.pop(), facade)
    return f"{_ENDS[end]} {absolute}" + (f" ({measure})" if measure.relative else "")


def _further(constraint: Constraint) -> list[str]:
    """Return the other attributes: choices as they are, the rest with their names."""
    skipped = {"min", "max", "scope", *(_DRAWING if isinstance(constraint, Size) else ())}
    rest = (a for a in _said(constraint) if a.type.name not in (*_SUBJECTS, "enclosing path"))
    return [
        _text(a, constraint) if a.type.choices else f"{a.name} {_text(a, constraint)}"
        for a in rest
        if a.name not in skipped
    ]


def _said(constraint: Constraint) -> list[Attribute]:
    """Return the attributes that a document must or does state."""
    attributes = constraint.attributes()
    return [a for a in attributes if a.required or getattr(constraint, a.field_name) != a.default]


def _text(attribute: Attribute, constraint: Constraint) -> str:
    return attribute.type.text(getattr(constraint, attribute.field_name))


def _word(symbols: Sequence[str]) -> str:
    if len(symbols) <= _SYMBOLS:
        return " ".join(symbols)
    return f"{' '.join(symbols[: _SYMBOLS - 2])} … {symbols[-1]} ({len(symbols)} regions)"


def repeated(path: str, root: Region) -> int:
    """Return how often a region stands in its parent in a layout; the first such parent says it."""
    parent, _, symbol = path.rpartition("/")
    return next((p.region.word.count(symbol) for p in place(root) if p.symbol_path == parent), 1)


def length(value: float, facade: Facade) -> str:
    """Return a size with its unit: metres to the centimetre, or finer where they are small."""
    if facade.units == "m":
        return f"{value:.2f} m" if value >= 0.095 else f"{value:.2g} m"
    return f"{format_number(round(value, 1))} {facade.units}"


def amount(some: Amount, facade: Facade) -> str:
    """Return an amount with its unit."""
    if some.units != "regions":
        return length(some.value, facade)
    return f"{some.value:.3g} region{'s' if some.value != 1 else ''}"


def name(path: str, facade: Facade) -> str:
    """Return the shortest end of a path that no other region of the facade goes by."""
    steps = path.split("/")
    shorter = ("/".join(steps[-n:]) for n in range(1, len(steps)))
    others = [other for other in facade.regions if other != path]
    return next((s for s in shorter if not any(o.endswith(f"/{s}") for o in others)), path)


def widening(unit: Unit, end: End, to: Measure, parts: Sequence[Constraint], facade: Facade) -> str:
    """Return how to say that an end of a range is moved out."""
    constraint = unit.constraints[0]
    if isinstance(constraint, Size):
        paths = facade.select(constraint.of)
        what = name(paths[0], facade) if len(paths) == 1 else str(constraint.of)
        sizes = {to.of(input_size(facade, path)) for path in paths}
        new = str(to) if to.relative else length(to.value, facade)
        if to.relative and len(sizes) == 1:
            new = f"{to} ({length(sizes.pop(), facade)})"
    else:
        what, new = subject(unit, (), facade), str(to)
    if unit.by_default:
        return f"give {what} a size of its own, {_ENDS[end]} {new}"
    return f"{'lower the minimum' if end == 'min' else 'raise the maximum'} of {what} to {new}"


def permission(region: str, words: Iterable[tuple[str, ...]], facade: Facade) -> str:
    """Return how to say that a region may have further arrangements."""
    shown = " or ".join(_word(word) for word in words)
    return f"allow {shown} in {name(region, facade)} by a further sequence"


def whole(symbols: Sequence[str]) -> Word:
    """Return the sequence that admits an arrangement as a whole."""
    return Word.parse(" ".join(["⊢", *symbols, "⊣"]))


__all__ = [
    "COUNTS",
    "amount",
    "demand",
    "length",
    "name",
    "permission",
    "repeated",
    "subject",
    "whole",
    "widening",
]
