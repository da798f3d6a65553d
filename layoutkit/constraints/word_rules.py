"""Rules on arrangements: small automata that read a composite region's word, symbol by symbol."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

if TYPE_CHECKING:
    from layoutkit.constraints.constraint import Constraint

#: What an automaton remembers: any hashable value of its own.
State = Any


class Automaton(Protocol):
    """A deterministic automaton over symbols, its states made as they are reached."""

    def start(self) -> State:
        """Return the state before the first symbol."""
        ...

    def step(self, state: State, symbol: str) -> State | None:
        """Return the state after `symbol`, or None where no valid word goes on so."""
        ...

    def accepts(self, state: State) -> bool:
        """Tell whether the word may end in `state`."""
        ...


@runtime_checkable
class Weighing(Automaton, Protocol):
    """An automaton that says which symbols are likelier than others."""

    @property
    def weighs(self) -> bool:
        """Whether it says so of any: otherwise all have the weight 1."""
        ...

    def weight(self, state: State, symbol: str) -> float:
        """Return how likely a symbol is in a state, against the others; 0 where no valid word goes on so."""
        ...


class Exactly:
    """Accepts one word only: the input's, where no sequence speaks of a region."""

    def __init__(self, word: Sequence[str]) -> None:
        self.word = tuple(word)

    def start(self) -> int:
        """Return how many symbols are read: none."""
        return 0

    def step(self, state: int, symbol: str) -> int | None:
        """Return the next position, if the symbol is the word's."""
        fits = state < len(self.word) and self.word[state] == symbol
        return state + 1 if fits else None

    def accepts(self, state: int) -> bool:
        """Tell whether the word is read whole."""
        return state == len(self.word)


class Anything:
    """Accepts every word but the empty one."""

    def start(self) -> bool:
        """Return that nothing is read."""
        return False

    def step(self, state: bool, symbol: str) -> bool:
        """Return that something is read."""
        return True

    def accepts(self, state: bool) -> bool:
        """Tell whether something is read."""
        return state


@dataclass(frozen=True)
class Admits:
    """The words of the region at `path` are those that `automaton` accepts."""

    path: str
    automaton: Automaton
    origin: tuple[Constraint, ...]


@dataclass(frozen=True)
class Counts:
    """How often regions of a set occur anywhere inside the region at `path`.

    Attributes
    ----------
    counted
        Symbol paths of the regions that count.
    least, most
        The range, inclusive, given the region's size along its split over its input size.
    """

    path: str
    counted: frozenset[str]
    least: Bound
    most: Bound
    origin: tuple[Constraint, ...]


@dataclass(frozen=True)
class Agree:
    """The words of several regions are the same under a mapping of symbols.

    Attributes
    ----------
    symbols
        For each region's path, its symbols by the name that all regions share.
    """

    symbols: Mapping[str, Mapping[str, str]]
    origin: tuple[Constraint, ...]


@dataclass(frozen=True)
class Mirrored:
    """The words of the region at `path` read the same backwards, each symbol exchanged for its partner.

    Attributes
    ----------
    partners
        The partners of every symbol: itself alone, for most.
    equal
        Whether what mirrors each other is equally large as well, as the constraint's rules on sizes say.
    """

    path: str
    partners: Mapping[str, tuple[str, ...]]
    origin: tuple[Constraint, ...]
    equal: bool = False


@dataclass(frozen=True)
class Variants:
    """The occurrences of the region at `path` in one parent may be laid out in different ways.

    Attributes
    ----------
    least, most
        How many different ways, inclusive, given the parent's size along its split over its input size. They
        are asked for where the region occurs at all; one way is always allowed.
    """

    path: str
    least: Bound
    most: Bound
    origin: tuple[Constraint, ...]


@dataclass(frozen=True, slots=True)
class Bound:
    """An end of a range of counts; a relative one grows with the region's size over its input size."""

    value: float
    relative: bool

    def at(self, growth: float) -> float:
        """Return the bound where the region's size is `growth` times its input size."""
        return self.value * growth if self.relative else self.value


WordRule = Admits | Counts | Agree | Mirrored | Variants
