"""Constraints and amounts in the user's names, short enough for a line of a diagnostic."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import WORD, Attribute
from layoutkit.constraints.claims import permitted, sized
from layoutkit.constraints.defaults import InputWord
from layoutkit.constraints.size import input_size
from layoutkit.model import Facade, Measure, Region, place
from layoutkit.model.conflict import Amount
from layoutkit.model.measure import format_number
from layoutkit_relayout.explanation.bounds import ENDS, End, end_of, ends_of
from layoutkit_relayout.explanation.units import Unit

#: Types of attributes that say what a constraint speaks of.
_SUBJECTS = ("regions", "members", "extent", "path", "paths")
_ENDS: dict[End, str] = {"min": "at least", "max": "at most"}
#: Names and words listed one by one; further ones are only counted.
_LISTED = 2
_SYMBOLS = 9
#: Characters of a name within a sentence.
_SHORT = 40


def subject(unit: Unit, regions: Sequence[str]) -> str:
    """Return what a unit speaks of, e.g. ``size of Facade/B/C``.

    Parameters
    ----------
    regions
        The regions in question, where the constraint demands something of each and only some take part.
    """
    first = unit.constraints[0]
    if isinstance(first, InputWord):
        return f"arrangement of {unit.region}"
    if unit.region:
        # What stands for others, as generators do, is not called by their name.
        plain = all(type(source) is type(first) for source in unit.sources)
        return f"{f'{first.qualified_name()}s' if plain else 'arrangements'} of {unit.region}"
    said = _subject(first)
    if regions and (len(regions) <= _LISTED or len(said) > _SHORT):
        said = _listed(regions)
    inside = [_text(a, first) for a in _said(first) if a.type.name == "enclosing path"]
    return f"{first.qualified_name()} of {said}" + "".join(f" in {path}" for path in inside)


def _subject(constraint: Constraint) -> str:
    return " and ".join(_text(a, constraint) for a in _said(constraint) if a.type.name in _SUBJECTS)


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
        return ", ".join(dict.fromkeys(_rule(source, facade) for source in unit.sources))
    said = (_range(end, [p for p in parts if end in ends_of(p)], facade) for end in ENDS)
    return ", ".join([*filter(None, said), *_further(first)])


def _listed(regions: Sequence[str]) -> str:
    if len(regions) <= _LISTED:
        return " and ".join(regions)
    return f"{', '.join(regions[:_LISTED])} and {len(regions) - _LISTED} more"


def _rule(source: Constraint, facade: Facade) -> str:
    words = [_text(a, source) for a in _said(source) if a.type is WORD]
    return words[0] if len(words) == 1 and permitted(source, facade) else str(source)


def _range(end: End, parts: Sequence[Constraint], facade: Facade) -> str:
    """Return an end that parts of one constraint have: as a size where it is the same for all of them."""
    if not parts:
        return ""
    measure = end_of(parts[0], end)
    assert measure is not None  # it is one that they state
    paths = {claim.path for part in parts for claim in sized(part, facade)}
    sizes = {measure.of(input_size(facade, path)) for path in paths}
    if len(sizes) != 1:
        return f"{_ENDS[end]} {measure}"
    return f"{_ENDS[end]} {length(sizes.pop(), facade)}" + (f" ({measure})" if measure.relative else "")


def _further(constraint: Constraint) -> list[str]:
    """Return the other attributes: choices as they are, the rest with their names."""
    skipped = {"min", "max", "scope"}
    rest = (a for a in _said(constraint) if a.type.name not in (*_SUBJECTS, "enclosing path"))
    return [
        _text(a, constraint) if a.type.choices else f"{a.name} {_text(a, constraint)}"
        for a in rest
        if a.name not in skipped and a.demands
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


def widening(unit: Unit, end: End, to: Measure, facade: Facade) -> str:
    """Return how to say that an end of a range is moved out."""
    constraint = unit.constraints[0]
    new = str(to)
    if paths := [claim.path for claim in sized(constraint, facade)]:
        sizes = {to.of(input_size(facade, path)) for path in paths}
        if len(sizes) == 1:
            new = length(sizes.pop(), facade) if not to.relative else f"{to} ({length(sizes.pop(), facade)})"
    what = _short(_subject(constraint) if paths else subject(unit, ()), constraint)
    if len(paths) == 1:
        what = name(paths[0], facade)
    if unit.by_default:
        return f"give {what} a size of its own, {_ENDS[end]} {new}"
    return f"{'lower the minimum' if end == 'min' else 'raise the maximum'} of {what} to {new}"


def _short(text: str, constraint: Constraint) -> str:
    """Return a name, or the line where it is told if the name is long."""
    line = constraint.place.line if constraint.place is not None else 0
    return text if len(text) <= _SHORT or not line else f"the {constraint.qualified_name()} in line {line}"


def permission(region: str, words: Iterable[tuple[str, ...]], facade: Facade) -> str:
    """Return how to say that a region may have further arrangements."""
    shown = " or ".join(_word(word) for word in words)
    return f"allow {shown} in {name(region, facade)} by a further sequence"
