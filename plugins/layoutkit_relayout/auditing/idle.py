"""What can never matter: symbols out of reach, and constraints that no layout can activate."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from layoutkit.constraints import Constraint
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.answers import word_rules_of
from layoutkit.constraints.claims import InLine, claims_of
from layoutkit.constraints.expansion import as_written, expanded
from layoutkit.constraints.word_rules import Counts, Variants, WordRule
from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.model import Extent, Word
from layoutkit_relayout.auditing.spelling import Spelling
from layoutkit_relayout.auditing.subjects import enclosing, subjects
from layoutkit_relayout.words.extremes import longest_count

#: Names listed one by one; further ones are only counted.
_LISTED = 3
#: Characters of a constraint within a line.
_WIDEST = 72
_LOOSEN = "allow it by a further sequence, or delete the constraint"


def out_of_reach(spelling: Spelling) -> Iterator[Diagnostic]:
    """Yield the regions in no word of the region that they stand in, parent by parent.

    What is inside them goes unsaid, and constraints that speak of nothing else are told in the same breath.
    """
    facade = spelling.facade
    lost = [path for path in facade.regions if path not in spelling.reached]
    tops = [path for path in lost if path.rpartition("/")[0] in spelling.reached]
    mute = {c: spoken[0] for c in facade.constraints if (spoken := _unreached(c, spelling))}
    for parent in dict.fromkeys(path.rpartition("/")[0] for path in tops):
        own = [path.rpartition("/")[2] for path in tops if path.rpartition("/")[0] == parent]
        inside = tuple(f"{parent}/{symbol}" for symbol in own)
        silenced = [c for c, path in mute.items() if path in inside or path.startswith(_folders(inside))]
        stand = "stands" if len(own) == 1 else "stand"
        yield _warning(
            "LK228",
            f"{listed(own)} {stand} in no arrangement that {parent} can have",
            _places(c for rule in spelling.rules_on(parent) for c in rule.origin),
            f"add a sequence of {parent} that has {own[0]} in it, or delete what is not meant",
            [f"so it asks nothing: {_short(c)}" for c in silenced],
        )


def _folders(paths: Sequence[str]) -> tuple[str, ...]:
    return tuple(f"{path}/" for path in paths)


def _unreached(constraint: Constraint, spelling: Spelling) -> list[str]:
    """Return what a constraint speaks of if all of that is out of reach, and it asks for nothing else."""
    around = enclosing(constraint)
    spoken = [p for paths in subjects(constraint, spelling.facade).values() for p in paths]
    if around is not None and around not in spelling.reached:
        spoken = [around]
    for claim in claims_of(constraint, spelling.facade):
        if isinstance(claim, InLine):  # it takes regions of both sides
            lost = (side for side in (claim.first, claim.second) if spelling.reached.isdisjoint(side))
            spoken = list(next(filter(None, lost), spoken))
    return [] if spelling.reached.intersection(spoken) or not _mute(constraint, spelling) else spoken


def idle(spelling: Spelling) -> Iterator[Diagnostic]:
    """Yield the constraints of the document that no layout can activate, and parts of some that none can.

    Such as speak of regions out of reach go unsaid.
    """
    for constraint in spelling.facade.constraints:
        if _unreached(constraint, spelling):
            continue
        if why := _idle(constraint, spelling):
            message = f"no layout can activate this constraint ({constraint.qualified_name()}): {why}"
            hint = "say it of what a layout can have, or delete the constraint"
            yield _warning("LK229", message, _places([constraint]), hint)
        else:
            yield from _lost_parts(constraint, spelling)
    yield from _lost_sequences(spelling)


def _idle(constraint: Constraint, spelling: Spelling) -> str:
    """Say why a constraint never matters; empty where that is not known."""
    if not _mute(constraint, spelling):
        return ""
    named = subjects(constraint, spelling.facade)
    if named and not any(named.values()):
        return "the sets of regions that it names have nothing in them"
    rules = word_rules_of(spelling.facade, [constraint])
    return _idle_rules(rules) or _idle_pairs(constraint, spelling)


def _mute(constraint: Constraint, spelling: Spelling) -> bool:
    """Tell whether all words that there can be keep what a constraint asks of words."""
    return all(_silent(rule, spelling) for rule in word_rules_of(spelling.facade, [constraint]))


def _silent(rule: WordRule, spelling: Spelling) -> bool:
    """Tell whether a rule on words is kept by all words that there can be."""
    if isinstance(rule, Counts):
        return rule.path not in spelling.reached or _asks_nothing(rule, spelling)
    if isinstance(rule, Variants):
        return rule.path not in spelling.reached or (rule.least.value <= 0 and _stands_once(rule, spelling))
    paths = (rule.path,) if hasattr(rule, "path") else tuple(rule.symbols)
    return spelling.reached.isdisjoint(paths)


def _asks_nothing(rule: Counts, spelling: Spelling) -> bool:
    unbounded = rule.least.value <= 0 and rule.most.value == math.inf
    return unbounded or (rule.least.value <= 0 and spelling.reached.isdisjoint(rule.counted))


def _stands_once(rule: Variants, spelling: Spelling) -> bool:
    """Tell whether a region stands in no word of its parent twice."""
    parent = rule.path.rpartition("/")[0]
    if spelling.machine((parent,)) is None:
        return False
    return longest_count(spelling.model.group_of[parent], parent, rule.path) <= 1


def _idle_rules(rules: Sequence[WordRule]) -> str:
    """Say why rules on words, of which none asks anything, do not; empty where there are none."""
    if any(isinstance(rule, Counts) for rule in rules):
        return "it states neither min nor max"
    if any(isinstance(rule, Variants) for rule in rules):
        return "what it names stands only once wherever it stands"
    return ""


def _idle_pairs(constraint: Constraint, spelling: Spelling) -> str:
    """Say why what is to be in line never is asked to be."""
    for claim in claims_of(constraint, spelling.facade):
        if not isinstance(claim, InLine):
            continue
        around = claim.within
        first, second = (
            [path for path in side if around is None or path.startswith(f"{around}/")]
            for side in (claim.first, claim.second)
        )
        if not (first and second):
            return "one of its sets has no region" + (f" in {around}" if around else "")
        if not any(spelling.can_overlap(one, other, claim.axis) for one in first for other in second):
            return "no region of the first set ever overlaps one of the second along the axis of these lines"
    return ""


def _lost_parts(constraint: Constraint, spelling: Spelling) -> Iterator[Diagnostic]:
    """Yield the runs that no arrangement has, and the contexts in which none has what they are of."""
    named = subjects(constraint, spelling.facade)
    for side, paths in named.items():
        value = getattr(constraint, side)
        before, after = (_context_of(constraint, side, where) for where in ("before", "after"))
        run = value.word if isinstance(value, Extent) else None
        reached = [path for path in paths if path in spelling.reached]
        if run is not None and reached and not _has_run(reached, run, None, None, spelling):
            shown, hint = f"the run {run} of {side}", "write a run as an arrangement can have it"
        elif reached and (before or after) and not _has_run(reached, run, before, after, spelling):
            shown, hint = (
                f"the context of {side} ({_context(before, after)})",
                "write what can stand beside it",
            )
        else:
            continue
        message = f"{shown} is in no arrangement: the {constraint.qualified_name()} asks nothing of it"
        yield _warning("LK230", message, _places([constraint]), f"{hint}, or {_LOOSEN}")


def _context_of(constraint: Constraint, side: str, where: str) -> Word | None:
    """Return what stands before or after the regions of an attribute: the attribute `side-where` says it."""
    names = {a.field_name for a in constraint.attributes() if a.type.name == "context"}
    value = getattr(constraint, f"{side}_{where}") if f"{side}_{where}" in names else None
    return value if isinstance(value, Word) else None


def _context(before: Word | None, after: Word | None) -> str:
    return ", ".join(f"{where} {word}" for where, word in (("before", before), ("after", after)) if word)


def _has_run(
    paths: Sequence[str], run: Word | None, before: Word | None, after: Word | None, spelling: Spelling
) -> bool:
    """Tell whether regions, or a run in one of them, can stand between two words."""
    if run is None:
        return any(spelling.has_beside(path, before, after) for path in paths)
    words = [word for word in (before, run, after) if word is not None]
    sets = [regions for word in words for regions in word.sets]
    at_start = run.at_start or (before is not None and before.at_start)
    at_end = run.at_end or (after is not None and after.at_end)
    if (run.at_start and before and before.sets) or (run.at_end and after and after.sets):
        return False
    return any(spelling.has_run(path, sets, at_start=at_start, at_end=at_end) for path in paths)


def _lost_sequences(spelling: Spelling) -> Iterator[Diagnostic]:
    """Yield the sequences, or generators, of which nothing stands in any arrangement.

    Those of symbols out of reach go unsaid: what is to be said of these is said once.
    """
    facade = spelling.facade
    alive: dict[int, tuple[Constraint, bool]] = {}
    for constraint in expanded(facade):
        if not isinstance(constraint, SequenceConstraint):
            continue
        source = as_written(facade, constraint)
        used = any(_usable(path, constraint.word, spelling) for path in constraint.within)
        alive[id(source)] = source, used or alive.get(id(source), (source, False))[1]
    for source, used in alive.values():
        if not used:
            message = f"no arrangement contains this {source.qualified_name()}: no chain leads to it and on"
            hint = "let it overlap others from ⊢ to ⊣, or delete it"
            yield _warning("LK230", message, _places([source]), hint)


def _usable(path: str, word: Word, spelling: Spelling) -> bool:
    """Tell whether a sequence can stand in a region's arrangement, or why it cannot is said elsewhere."""
    if path not in spelling.reached:
        return True
    children = {c.symbol: c for c in spelling.facade.regions[path].children}
    reached = [c for s, c in children.items() if f"{path}/{s}" in spelling.reached]
    names = [frozenset({c.symbol, *(f"@{label}" for label in c.labels)}) for c in reached]
    if not all(any(regions.contains(own) for own in names) for regions in word.sets):
        return True
    return spelling.has_run(path, word.sets, at_start=word.at_start, at_end=word.at_end)


def _short(constraint: Constraint) -> str:
    """Return a constraint in few words, with its line."""
    text = str(constraint)
    shown = text if len(text) <= _WIDEST else f"{text[: _WIDEST - 2]} …"
    line = constraint.place.line if constraint.place is not None else 0
    return f"{shown}  (line {line})" if line else shown


def _places(constraints: Iterable[Constraint]) -> tuple[Place, ...]:
    return tuple(sorted({c.place for c in constraints if c.place is not None}))


def listed(names: Sequence[str]) -> str:
    """Return some names as one reads them out, further ones only counted."""
    if len(names) > _LISTED:
        return f"{', '.join(names[:_LISTED])} and {len(names) - _LISTED} more"
    return f"{', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else names[0]


def _warning(
    code: str, message: str, places: tuple[Place, ...], hint: str, details: Iterable[str] = ()
) -> Diagnostic:
    place, related = (places[0] if places else None), (places if len(places) > 1 else ())
    return Diagnostic(code, message, place, hint, Severity.WARNING, "semantics", tuple(details), related)
