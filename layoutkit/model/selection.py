"""Region sets: symbols and labels with union, intersection and difference."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Literal

#: What a symbol or label may be called: a letter or underscore, then letters, digits, underscores.
SYMBOL = r"[^\W\d]\w*"

_PATH = rf"{SYMBOL}(?:/{SYMBOL})*"
_TOKEN = re.compile(rf"\s*(?:(?P<operator>[|&()-])|(?P<name>@{SYMBOL}|{_PATH}(?:/\*)?))")
Operator = Literal["|", "&", "-"]
#: Parentheses within parentheses, and changes from one operator to another, in one expression.
DEPTH_LIMIT = 50


@dataclass(frozen=True, slots=True)
class RegionSet:
    """A set of regions, written as an expression over names.

    A name is a label (``@Window``), a symbol path from the root (``Facade/Floor/Bay``), all that is inside
    such a region (``Facade/Floor/*``) or, where the context is one composite region, the symbol of a direct
    child (``Bay``). Names join with ``|`` (union), ``&`` (intersection) and ``-`` (difference), which bind
    alike, from left to right; parentheses group: ``@Window - @DoorSized``.

    Attributes
    ----------
    name
        The name, where the set is a single one; else empty.
    operator, left, right
        The operation, where it is not.
    """

    name: str = ""
    operator: Operator | None = None
    left: RegionSet | None = None
    right: RegionSet | None = None

    @classmethod
    def parse(cls, text: str) -> RegionSet:
        """Read an expression.

        Raises
        ------
        ValueError
            If the text is not of that form; the message says where.
        """
        tokens = [*_tokens(text)][::-1]
        found = _expression(tokens, text, 0)
        if tokens:
            raise ValueError(f"unexpected {tokens[-1]!r} in {text!r}")
        return found

    @classmethod
    def union(cls, names: Iterable[str]) -> RegionSet:
        """Return the union of single names, at least one.

        Raises
        ------
        ValueError
            If there is no name, or one of them is not of a name's form.
        """
        sets = [cls.parse(name) for name in names]
        if not sets:
            raise ValueError("a set of regions cannot be empty")
        found = sets[0]
        for other in sets[1:]:
            found = cls(operator="|", left=found, right=other)
        return found

    def names(self) -> tuple[str, ...]:
        """Return every name in the expression, in order, labels with their ``@``."""
        return tuple(leaf.name for leaf in self._spine("|&-") for leaf in leaf._leaves())

    def _spine(self, operators: str) -> list[RegionSet]:
        """Return the operands joined by these operators along the left: as many as a union has names."""
        operands, node = [], self
        while node.left is not None and node.right is not None and (node.operator or "") in operators:
            operands.append(node.right)
            node = node.left
        return [node, *reversed(operands)]

    def _leaves(self) -> Iterator[RegionSet]:
        if self.operator is None:
            yield self
        else:
            for operand in self._spine("|&-"):
                yield from operand._leaves()

    def terms(self) -> tuple[str, ...]:
        """Return the names joined by unions, or the whole expression as a single term."""
        return tuple(str(operand) for operand in self._spine("|"))

    def contains(self, names: frozenset[str]) -> bool:
        """Tell whether a region that goes by all of `names` (labels with their ``@``) is in the set."""
        spine, node = list[RegionSet](), self
        while node.left is not None:
            spine.append(node)
            node = node.left
        found = node.name in names
        for node in reversed(spine):
            assert node.right is not None
            if found != (node.operator == "|"):  # else the right side changes nothing
                found = node.right.contains(names) is (node.operator != "-")
        return found

    def __str__(self) -> str:
        parts: list[str] = []
        node = self
        while node.left is not None and node.right is not None:
            right = f"({node.right})" if node.right.operator else str(node.right)
            parts += [right, str(node.operator)]
            if node.left.operator and node.left.operator != node.operator:  # read alike by everyone
                return " ".join([f"({node.left})", *reversed(parts)])
            node = node.left
        return " ".join([node.name, *reversed(parts)])


def _tokens(text: str) -> Iterator[str]:
    position, end = 0, len(text.rstrip())
    while position < end:
        token = _TOKEN.match(text, position)
        if token is None:
            raise ValueError(f"unexpected {text[position:].strip()[0]!r} in {text!r}")
        yield token[0].strip()
        position = token.end()


def _expression(tokens: list[str], text: str, depth: int) -> RegionSet:
    """Read an expression off the end of the reversed tokens."""
    found, last = _operand(tokens, text, depth), ""
    while tokens and tokens[-1] in ("|", "&", "-"):
        operator: Operator = tokens.pop()  # type: ignore[assignment]  # one of the three, as just tested
        depth, last = depth + (operator != last), operator
        if depth > DEPTH_LIMIT:
            raise ValueError(f"{text!r} changes between operators more than {DEPTH_LIMIT} times")
        found = RegionSet(operator=operator, left=found, right=_operand(tokens, text, depth))
    return found


def _operand(tokens: list[str], text: str, depth: int) -> RegionSet:
    if not tokens:
        raise ValueError(f"a name is missing at the end of {text!r}")
    head = tokens.pop()
    if head == "(":
        if depth == DEPTH_LIMIT:
            raise ValueError(f"parentheses are nested more than {DEPTH_LIMIT} deep in {text!r}")
        found = _expression(tokens, text, depth + 1)
        if not tokens or tokens.pop() != ")":
            raise ValueError(f"a parenthesis is not closed in {text!r}")
        return found
    if head in ("|", "&", "-", ")"):
        raise ValueError(f"a name is expected before {head!r} in {text!r}")
    return RegionSet(head)
