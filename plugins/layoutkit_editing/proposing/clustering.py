"""Proposals grouped by how alike their structure is, so that the first few shown differ.

What the paper names as its future work: "defining a structural similarity measure between variations" and
clustering by it (Dang et al. 2014, section 7).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.grids.labels import name_of, worth_of
from layoutkit_editing.proposing.applying import AXES

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from layoutkit_editing.proposing.proposals import Proposal
    from layoutkit_editing.proposing.signatures import Signatures
    from layoutkit_editing.state import Lattice, State

    Floats = NDArray[np.float64]

#: How many groups there are at most.
MOST = 6
#: How much spacing counts beside the order of what is spaced.
SPACING = 0.25
#: Distortions that agree to so many decimals are about the same.
ABOUT = 2
#: What is worth so much is an element that people look at; and what of its size are steps of strain.
WORTHY, STRAINS = 0.5, (1.15, 1.4, 2.0)
#: Stands behind the end of a grid's lines.
_NOTHING = -2


def ordered(
    before: State, proposals: Sequence[Proposal], signatures: Signatures
) -> list[tuple[Proposal, int]]:
    """Return proposals in the order in which to show them, each with the number of its group.

    Better are those in which no window, door or the like is much larger or smaller than it was; then those
    that distort less as a whole; of those that distort about as much, those in which fewer lines stand beside
    others than they did: a copy of the ground floor is rather a second ground floor than an attic.
    Groups are numbered by their best proposal. Of each group in turn the best one is shown, then the next
    of each, and so on; ties go by the order given.

    Parameters
    ----------
    signatures
        Of the facade before the edit.
    """
    worthy = np.array([worth_of(name_of(placed.region)) >= WORTHY for placed in before.original.places])
    ranked = [
        (
            _strained(each, worthy),
            round(each.sized.distortion, ABOUT),
            _news(before, each, signatures),
            each.sized.distortion,
            number,
        )
        for number, each in enumerate(proposals)
    ]
    best = [proposals[number] for *_, number in sorted(ranked)]
    groups = _grouped(differences(best, signatures))
    numbers: dict[int, int] = {}
    seen: dict[int, int] = {}
    ranks = []
    for place, group in enumerate(groups):
        number = numbers.setdefault(group, len(numbers))
        seen[number] = seen.get(number, -1) + 1
        ranks.append((seen[number], number, place))
    return [(best[place], number) for _, number, place in sorted(ranks)]


def _strained(proposal: Proposal, worthy: NDArray[np.bool_]) -> int:
    """Return how much the worst terminal of some sources is off its size: 0 little, more in steps."""
    flat, sizes = proposal.sized.flat, proposal.state.original.sizes
    own = flat.terminals[worthy[flat.sources[flat.terminals]]]
    places = proposal.sized.places[:, own]
    shares = (places[:, :, 1] - places[:, :, 0]) / sizes[:, flat.sources[own]]
    worst = float(np.abs(np.log(shares)).max(initial=0.0))
    return sum(worst > math.log(step) for step in STRAINS)


def _news(before: State, proposal: Proposal, signatures: Signatures) -> int:
    """Return how many lines of edited grids stand beside lines unlike those that like ones stood beside."""
    edit, count = proposal.edit, 0
    known = signatures.all_of(proposal.state.tree)
    for name in edit.grids:
        seen = set(pairwise(_looks(before.lattice(name), AXES[edit.axis], known)))
        beside = pairwise(_looks(proposal.state.lattice(name), AXES[edit.axis], known))
        count += sum(pair not in seen for pair in beside)
    return count


def _looks(lattice: Lattice, axis: int, known: Mapping[int, int]) -> list[tuple[int | None, ...]]:
    return [tuple(None if own is None else known[own] for own in line) for line in lattice.lines(axis)]


def _grouped(distances: Floats) -> list[int]:
    """Return the group of each: average linkage, as many groups as the root of their number."""
    from scipy.cluster.hierarchy import fcluster, linkage
    from scipy.spatial.distance import squareform

    count = len(distances)
    if count < 3:
        return list(range(count))
    tree = linkage(squareform(distances, checks=False), "average")
    groups: list[int] = fcluster(tree, min(MOST, math.ceil(math.sqrt(count))), "maxclust").tolist()
    return groups


def differences(proposals: Sequence[Proposal], signatures: Signatures) -> Floats:
    """Return how much the structures of proposals differ, pair by pair (n × n, from 0 on).

    The distance of two grids is that of their lines as words: what it takes to turn one into the other,
    where lines differ by the share of their elements that look different, or to turn it into the mirrored
    other, if that is less; divided by the number of lines. To it comes, with less weight, how much lines are
    spaced differently.
    """
    count = len(proposals)
    total = np.zeros((count, count))
    if not count:
        return total
    edit = proposals[0].edit
    for name in edit.grids:
        words, places = _words(proposals, name, signatures)
        mirrored = [word[::-1] for word in words]
        total += np.minimum(_distances(words, words), _distances(words, mirrored))
        total += SPACING * _unlike(places)
    return (total + total.T) / 2


def _words(
    proposals: Sequence[Proposal], name: str, signatures: Signatures
) -> tuple[list[Floats], list[Floats]]:
    """Return each proposal's lines as rows of signatures, and where they stand, from 0 to 1."""
    words: list[Floats] = []
    places: list[Floats] = []
    for proposal in proposals:
        axis = AXES[proposal.edit.axis]
        own, found = proposal.state, proposal.sized
        lines = own.lattice(name).lines(axis)
        known = signatures.all_of(own.tree)
        words.append(np.array([[-1 if e is None else known[e] for e in line] for line in lines], dtype=float))
        spans = [[found.span(e, axis) for e in line if e is not None] for line in lines]
        centres = [np.mean(span) if span else 0.0 for span in spans]
        places.append(np.array(centres) / found.extents[axis])
    return words, places


def _distances(first: Sequence[Floats], second: Sequence[Floats]) -> Floats:
    """Return the edit distances of all pairs of words, divided by the greater length."""
    longest = max(len(word) for word in (*first, *second))
    one, other = _padded(first, longest), _padded(second, longest)
    costs = (one[:, None, :, None] != other[None, :, None, :]).mean(axis=-1)
    lengths = [np.array([len(word) for word in words]) for words in (first, second)]
    table = np.zeros((longest + 1, longest + 1, len(first), len(second)))
    table[0] = np.arange(longest + 1)[:, None, None]
    table[:, 0] = np.arange(longest + 1)[:, None, None]
    for i in range(1, longest + 1):
        for j in range(1, longest + 1):
            changed = table[i - 1, j - 1] + costs[:, :, i - 1, j - 1]
            table[i, j] = np.minimum(changed, np.minimum(table[i - 1, j], table[i, j - 1]) + 1.0)
    rows, columns = lengths[0][:, None], lengths[1][None, :]
    found = table[rows, columns, np.arange(len(first))[:, None], np.arange(len(second))[None, :]]
    return np.asarray(found / np.maximum(rows, columns))


def _padded(words: Sequence[Floats], longest: int) -> Floats:
    return np.stack(
        [np.pad(word, ((0, longest - len(word)), (0, 0)), constant_values=_NOTHING) for word in words]
    )


def _unlike(places: Sequence[Floats]) -> Floats:
    """Return the mean distance of corresponding lines, for all pairs; lines are matched by their order."""
    longest = max(map(len, places))
    even = np.linspace(0.0, 1.0, longest)
    drawn = np.stack([np.interp(even, np.linspace(0.0, 1.0, len(own)), own) for own in places])
    return np.asarray(np.abs(drawn[:, None] - drawn[None]).mean(axis=-1))
