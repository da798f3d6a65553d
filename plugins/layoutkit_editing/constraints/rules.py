"""What constraints ask of sizes, as rows over the lines of nodes.

Hard constraints alone: what soft ones would like is no part of the sizing, which has an objective of its own.
Of what constraints ask, this much can be stated by rows of one axis: sizes, shares and places, frequencies
that grow with a region, and lines that coincide. The rest (arrangements, how many instances there are, convex
rules and such as relate widths to heights) is looked at when sizes are known: `constraints.checks`.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np

from layoutkit.constraints import Constraint, Size
from layoutkit.constraints.answers import word_rules_of
from layoutkit.constraints.claims import counted, varying
from layoutkit.constraints.claims import sized as sizes_of
from layoutkit.constraints.expansion import expanded
from layoutkit.constraints.size import axis_of
from layoutkit.constraints.word_rules import Bound, Counts
from layoutkit.model import Facade
from layoutkit.sizing.answers import size_rules_of
from layoutkit.sizing.arrangement import AXIS, Slot
from layoutkit.sizing.overlaps import Meetings, Pair
from layoutkit.sizing.rules import Aligned, Range
from layoutkit_editing.constraints.copies import copies_of
from layoutkit_editing.constraints.rewriting import rewritten
from layoutkit_editing.constraints.unfolding import Terms, Unfolded
from layoutkit_editing.original import Original
from layoutkit_editing.sizing.rules import Rule
from layoutkit_editing.state import State
from layoutkit_editing.topology.site import Spans
from layoutkit_editing.tree import Tree


@dataclass(frozen=True, eq=False)
class Asked:
    """What is asked of the sizes of a state.

    Attributes
    ----------
    rules
        What holds wherever nodes stand.
    aligned
        Which regions have to be in line where they overlap.
    nodes
        The node of each symbol path that `aligned` knows.
    """

    rules: tuple[Rule, ...] = ()
    aligned: tuple[Aligned, ...] = ()
    nodes: Mapping[str, int] = field(default_factory=dict)

    def __bool__(self) -> bool:
        return bool(self.rules or self.aligned)

    def out_of_line(self, spans: Spans, extents: tuple[float, float]) -> tuple[Rule, ...]:
        """Return rows for all regions that overlap where nodes stand, and are not in line as they should be.

        What overlaps by half of the smaller one or more is to be in line; what does so by less is to stand
        apart, in the order in which it stands.

        Parameters
        ----------
        extents
            Width and height of the facade.
        """
        found: dict[tuple[int, int, frozenset[int]], Sequence[Rule]] = {}
        for axis in (0, 1):
            aligned = [rule for rule in self.aligned if rule.axis == axis]
            if not aligned:
                continue
            meetings, size = Meetings(aligned), max(extents)
            ends = np.array([spans(self._node(slot), axis) for slot in meetings.slots]) / size
            for pair in sorted(meetings.out_of_line(ends.T.ravel()), reverse=True):
                nodes = frozenset((self._node(pair.first), self._node(pair.second)))
                found.setdefault((axis, id(pair.rule.origin), nodes), tuple(self._rows(pair, spans)))
        return tuple(rule for rules in found.values() for rule in rules)

    def _node(self, slot: Slot) -> int:
        return self.nodes[slot.symbol_path]

    def _rows(self, pair: Pair, spans: Spans) -> Iterator[Rule]:
        axis, origin = pair.rule.axis, pair.rule.origin
        one, other = self._node(pair.first), self._node(pair.second)
        if pair.sure:
            for share in pair.rule.lines:
                terms = (*_line(one, share, 1.0), *_line(other, share, -1.0))
                yield Rule(axis, terms, 0.0, 0.0, origin)
        else:
            before, after = sorted((one, other), key=lambda own: sum(spans(own, axis)))
            yield Rule(axis, ((after, 0, 1.0), (before, 1, -1.0)), 0.0, math.inf, origin)


#: What was asked of trees that are still in use, as copies of which original.
_KNOWN: WeakKeyDictionary[Tree, tuple[Original, Asked]] = WeakKeyDictionary()


def asked(state: State) -> Asked:
    """Return what the hard constraints of a facade's document ask of the sizes of a state.

    Raises
    ------
    Misbehaviour
        If a plugin's kind answers what makes no sense.
    """
    if not state.original.facade.constraints:
        return Asked()
    original, found = _KNOWN.get(state.tree, (None, Asked()))
    if original is not state.original:
        found = _Asking(state).all()
        _KNOWN[state.tree] = state.original, found
    return found


def rules(state: State) -> tuple[Rule, ...]:
    """Return the rows that hold wherever nodes stand."""
    return asked(state).rules


@dataclass(frozen=True)
class _Asking:
    """The hard constraints of a document, asked of a state."""

    state: State

    @property
    def facade(self) -> Facade:
        return self.state.original.facade

    @cached_property
    def hard(self) -> tuple[Constraint, ...]:
        return tuple(constraint for constraint in expanded(self.facade) if not constraint.soft)

    @cached_property
    def copies(self) -> Mapping[str, tuple[int, ...]]:
        """The nodes that are copies of each symbol path of the original."""
        return copies_of(self.state)

    def all(self) -> Asked:
        """Return everything that is asked."""
        found = [*self.sizes(), *self.growing()]
        stating = [constraint for constraint in self.hard if _states(constraint, self.facade)]
        if not stating:
            return Asked(_once(found))
        unfolded, aligned = Unfolded.of(self.state), list[Aligned]()
        for constraint in stating:
            for own in rewritten(constraint, unfolded.names):
                for rule in size_rules_of(own, unfolded.arrangement):
                    if isinstance(rule, Range):
                        found += _row(rule, constraint, unfolded)
                    elif isinstance(rule, Aligned):
                        aligned.append(replace(rule, origin=constraint))
        return Asked(_once(found), tuple(aligned), unfolded.nodes if aligned else {})

    def sizes(self) -> Iterator[Rule]:
        """Yield the sizes that constraints claim, of each copy along the axis that its source has it."""
        for constraint in self.hard:
            for claim in sizes_of(constraint, self.facade):
                axis = axis_of(self.facade, claim.path)
                for own in self.copies.get(claim.path, ()):
                    yield Rule(axis, _size(own), claim.least, claim.most, constraint)

    def growing(self) -> Iterator[Rule]:
        """Yield the sizes at which ranges that grow with a region admit the counts that there are."""
        for constraint in self.hard:
            if counted(constraint, self.facade):
                for rule in word_rules_of(self.facade, (constraint,)):
                    if isinstance(rule, Counts) and (rule.least.relative or rule.most.relative):
                        yield from self.admitting(rule, constraint)

    def admitting(self, rule: Counts, constraint: Constraint) -> Iterator[Rule]:
        """Yield the sizes at which each copy of a region may hold as many as it does."""
        region = self.facade.regions[rule.path]
        split = region.split or "columns"
        axis, size = AXIS[split], region.extent(split)
        members = {own for path in rule.counted for own in self.copies.get(path, ())}
        inside = Counter(above for own in members for above in self.state.tree.ancestors(own)[1:])
        for own in self.copies.get(rule.path, ()):
            least = inside[own] / rule.most.value * size if _grows(rule.most) else 0.0
            most = inside[own] / rule.least.value * size if _grows(rule.least) else math.inf
            yield Rule(axis, _size(own), least, most, constraint)


def _grows(bound: Bound) -> bool:
    return bound.relative and bound.value > 0


def _states(constraint: Constraint, facade: Facade) -> bool:
    """Tell whether a constraint has rules on sizes that are asked for region by region.

    Counts are asked as counts, and how many instances there are turns out when sizes are known.
    """
    if type(constraint).size_rules in (Constraint.size_rules, Size.size_rules):
        return False  # of sizes, what is claimed is all
    return not counted(constraint, facade) and not varying(constraint, facade)


def _row(rule: Range, constraint: Constraint, unfolded: Unfolded) -> Iterator[Rule]:
    """Yield a range in the lines of nodes; one over nothing is for the check to tell of."""
    terms, constant = unfolded.terms(rule.form, rule.axis)
    if terms:
        yield Rule(rule.axis, terms, rule.least - constant, rule.most - constant, constraint)


def _once(found: Sequence[Rule]) -> tuple[Rule, ...]:
    """Return rows without those that say what others do."""
    return tuple({(r.axis, frozenset(r.terms), r.least, r.most): r for r in reversed(found)}.values())[::-1]


def _size(own: int) -> Terms:
    return (own, 1, 1.0), (own, 0, -1.0)


def _line(own: int, share: float, factor: float) -> Terms:
    """Return a line of a node at a share of its extent."""
    ends = ((own, 0, (1 - share) * factor), (own, 1, share * factor))
    return tuple(term for term in ends if term[2])
