"""All that a kind answers about a facade, as text: the same answers give the same text, anywhere."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from layoutkit.constraints.answers import faults_of, violations_of, word_rules_of
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.language import TooManyStates, language
from layoutkit.constraints.word_rules import Admits, Agree, Counts, Mirrored, WordRule
from layoutkit.model import Facade
from layoutkit.sizing.answers import size_rules_of
from layoutkit.sizing.convex import Bend
from layoutkit.sizing.rules import Convex, Range, Rows, SizeRule, Target
from layoutkit.testing.sampling import Sample, drawn, reached, sizes_of, word_choices

#: How many layouts are looked at.
_LAYOUTS = 4


def samples_of(facade: Facade) -> list[Sample]:
    """Return some layouts of a facade, the same ones every time."""
    rng = np.random.default_rng(7)
    own = {path: region.word for path, region in facade.regions.items() if region.split}
    choices = word_choices(facade, rng, _LAYOUTS)
    words = [reached(facade, own), *choices[-_LAYOUTS + 1 :]]
    sizes = sizes_of(facade)
    return [drawn(facade, choice, sizes[n % len(sizes)], rng) for n, choice in enumerate(words)]


def testimony(
    facade: Facade, constraints: Sequence[Constraint], samples: Sequence[Sample]
) -> tuple[str, ...]:
    """Return what constraints of one kind answer, in the order of answering.

    Parameters
    ----------
    samples
        Layouts of the facade.
    """
    return tuple(_told(facade, constraints, samples))


def _told(facade: Facade, constraints: Sequence[Constraint], samples: Sequence[Sample]) -> Iterator[str]:
    for constraint in constraints:
        yield from (f"faults(): {fault}" for fault in faults_of(constraint, facade))
        yield from (f"ties(): {axis} {paths}" for axis, paths in constraint.ties(facade))
        yield from (f"claims(): {claim}" for claim in constraint.claims(facade))
        yield from (f"parts(): {path} {part}" for path, part in constraint.parts(facade).items())
    yield from (f"word_rules(): {_word_rule(rule, facade)}" for rule in word_rules_of(facade, constraints))
    for number, sample in enumerate(samples):
        for constraint in constraints:
            for rule in size_rules_of(constraint, sample.arrangement):
                yield f"size_rules() of layout {number}: {_size_rule(rule)}"
            for violation in violations_of(constraint, sample.view):
                told = f"{violation.path} {violation.message} {violation.amount!r}"
                yield f"violations() of layout {number}: {told}"


def _word_rule(rule: WordRule, facade: Facade) -> str:
    if isinstance(rule, Admits):
        symbols = tuple(dict.fromkeys(facade.regions[rule.path].word))
        try:
            return f"Admits {rule.path} {language(rule.automaton, symbols)}"
        except (TooManyStates, TypeError):  # another promise tells of that
            return f"Admits {rule.path}"
    if isinstance(rule, Counts):
        return f"Counts {rule.path} {sorted(rule.counted)} {rule.least} {rule.most}"
    if isinstance(rule, Agree):
        return f"Agree { ({path: dict(symbols) for path, symbols in rule.symbols.items()}) }"
    if isinstance(rule, Mirrored):
        return f"Mirrored {rule.path} {dict(rule.partners)}"
    return f"Variants {rule.path} {rule.least} {rule.most}"


def _size_rule(rule: SizeRule) -> str:
    if isinstance(rule, Range):
        return f"Range {rule.axis} {dict(rule.form)} {rule.least!r} {rule.most!r} {rule.words}"
    if isinstance(rule, Rows):
        matrix, ends = np.asarray(rule.matrix).tolist(), (list(rule.least), list(rule.most))
        return f"Rows {rule.quantities} {matrix} {ends} {rule.words}"
    if isinstance(rule, Convex):
        excess = Bend(rule).excess(np.arange(1.0, len(rule.quantities) + 1.0))
        return f"Convex {rule.quantities} {excess.tolist()} {rule.words}"
    if isinstance(rule, Target):
        return repr(rule)
    sides = ([slot.symbol_path for slot in side] for side in (rule.first, rule.second))
    return f"Aligned {rule.axis} {list(sides)} {rule.lines}"
