"""The SL0 kernel: how alike two placements are, by what relates them to the features about them.

Guerrero et al. 2015, section 3.3. Two feature sets are compared under the assignment of their tuples that
makes them most alike; tuples of features of different types or labels are not alike at all. So assignments
are found for each type and label by itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.scenes.features import Array, FeatureType, Indices
from layoutkit_placement.learning.assignments import FEW, Similarities, best_columns, best_sums, joined
from layoutkit_placement.learning.descriptors import FeatureSets, Group, Single

#: So many numbers at once stay in the processor's cache.
BLOCK = 1 << 16

#: Values are multiplied by this, so that the square of a gap is all of a Gaussian's exponent.
HALF = np.float32(np.sqrt(0.5))


@dataclass(frozen=True, slots=True)
class Block:
    """The tuples that examples have of features of one type and label.

    Examples with fewer of them than others have rows of no importance.

    Attributes
    ----------
    code
        The number of the label.
    examples
        Which examples have any, shape (examples,).
    rows
        Which features of the stack they are, less than 0 for none, shape (examples, rows).
    values, importance
        Shapes (samples, examples * rows, values) and (samples, examples * rows); values times √½.
    """

    code: int
    examples: Indices
    rows: Indices
    values: Single
    importance: Single

    def similarities(self, group: Group, columns: Indices, shapes: Indices | slice) -> Similarities:
        """Return the similarities of its tuples to those of some shapes: equation 1 of the paper, and 7.

        Its weights stand for each sample point by itself: so the similarity of shapes is never greater than
        that of their sample points added up.

        Parameters
        ----------
        columns
            Features of the group, all of the block's label.

        Returns
        -------
        Array
            Shape (shapes, examples, rows, columns).
        """
        queried = group.values[shapes][:, :, columns] * HALF
        gap = self.values[:, :, None] - queried[:, :, None]
        np.multiply(gap, gap, out=gap)
        np.exp(np.negative(gap, out=gap), out=gap)
        alike = gap @ np.ones(gap.shape[-1], np.float32)
        alike *= self.importance[:, :, None]
        alike *= group.importance[shapes][:, :, columns][:, :, None]
        found: Similarities = alike.sum(axis=1)
        return found.reshape(-1, *self.rows.shape, len(columns))


@dataclass(frozen=True, slots=True)
class Stack:
    """The tuples of features of one type, of all examples one after the other.

    Attributes
    ----------
    values, importance, codes
        As in `Group`, without its first axis: shapes (samples, features, values), (samples, features) and
        (features,).
    owners
        Which example each feature is of, shape (features,).
    blocks
        The same by label.
    """

    values: Single
    importance: Single
    codes: Indices
    owners: Indices
    blocks: tuple[Block, ...]

    @classmethod
    def of(cls, groups: Mapping[int, Group]) -> Stack:
        """Return the groups of single shapes together, by the examples' numbers."""
        values = np.concatenate([group.values[0] for group in groups.values()], axis=1)
        importance = np.concatenate([group.importance[0] for group in groups.values()], axis=1)
        codes = np.concatenate([group.codes for group in groups.values()])
        owners = np.repeat(list(groups), [len(group.codes) for group in groups.values()])
        blocks = tuple(_block(int(code), values, importance, codes, owners) for code in np.unique(codes))
        return cls(values, importance, codes, owners, blocks)


Stacks = Mapping[FeatureType, Stack]
#: What examples have of features of one type and label, what shapes have of this type, and which of these are
#: of that label.
Met = tuple[Block, Group, Indices]


def _block(code: int, values: Single, importance: Single, codes: Indices, owners: Indices) -> Block:
    members = np.flatnonzero(codes == code)
    examples, first, counts = np.unique(owners[members], return_index=True, return_counts=True)
    place = np.arange(counts.max())
    places = np.minimum(first[:, None] + place, len(members) - 1)
    rows = np.where(place < counts[:, None], members[places], -1)
    own = (importance[:, rows] * (rows >= 0)).reshape(len(importance), -1)
    tuples = values[:, rows].reshape(len(values), rows.size, -1) * HALF
    return Block(code, examples, rows, tuples, own)


def stacked(sets: Sequence[FeatureSets]) -> Stacks:
    """Return the feature sets of single shapes, of all of them together."""
    return {
        of: Stack.of({number: own[of] for number, own in enumerate(sets) if of in own})
        for of in dict.fromkeys(of for own in sets for of in own)
    }


def kernel(examples: Stacks, count: int, queries: FeatureSets, shapes: int) -> Array:
    """Return the similarities of shapes to examples: equations 2, 3 and 7 of the paper.

    Parameters
    ----------
    count
        How many examples there are.
    queries
        The feature sets of the shapes.
    shapes
        How many of these there are.

    Returns
    -------
    Array
        Shape (shapes, examples).
    """
    met = [
        (block, queries[of], columns)
        for of, stack in examples.items()
        if of in queries
        for block, columns in _shared(stack, queries[of])
    ]
    found = np.zeros((shapes, count))
    numbers = max((block.values.size * len(columns) for block, _, columns in met), default=1)
    step = max(1, BLOCK // numbers)
    for start in range(0, shapes, step):
        some = slice(start, start + step)
        for of_a_size in _by_size(met):
            alike = joined([block.similarities(group, columns, some) for block, group, columns in of_a_size])
            owners = np.concatenate([block.examples for block, _, _ in of_a_size])
            found[some] += best_sums(alike) @ (owners[:, None] == np.arange(count))
    return found


def _by_size(met: Sequence[Met]) -> Iterator[Sequence[Met]]:
    """Yield those of single rows, of a few rows and of many: assignments are found in other ways for each."""
    rows = [min(block.rows.shape[1], len(columns)) for block, _, columns in met]
    for least, most in ((1, 1), (2, FEW), (FEW + 1, None)):
        if own := [each for each, count in zip(met, rows, strict=True) if least <= count <= (most or count)]:
            yield own


def taken(stack: Stack, group: Group, shapes: Indices) -> Iterator[tuple[Block, Indices]]:
    """Yield for each label which features of some shapes are taken for those of the examples.

    Yields
    ------
    Block
        What the examples have.
    Array
        For each row of it a feature of the group, by its place in it, less than 0 for none; shape (shapes,
        examples, rows).
    """
    for block, columns in _shared(stack, group):
        chosen = best_columns(block.similarities(group, columns, shapes))
        yield block, np.where(chosen >= 0, columns[chosen], -1)


def gram(sets: Sequence[FeatureSets]) -> Array:
    """Return the similarities of shapes to each other, shape (shapes, shapes)."""
    examples = stacked(sets)
    found = np.concatenate([kernel(examples, len(sets), own, 1) for own in sets])
    both: Array = (found + found.T) / 2  # equal but for rounding
    return both


def _shared(stack: Stack, group: Group) -> Iterator[tuple[Block, Indices]]:
    """Yield what examples have of each label, with the features of shapes that have it too."""
    for block in stack.blocks:
        if len(columns := np.flatnonzero(group.codes == block.code)):
            yield block, columns
