"""Weighted sampling: words are as likely as letters' frequencies and sequences' weights say."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import product
from math import inf

import numpy as np
import pytest
from countable import row, search, sequences, sized, stack
from scipy.stats import chisquare

from layoutkit.constraints import Symmetry
from layoutkit.constraints.covering import Covering, Piece
from layoutkit.model import Facade, Region
from layoutkit_relayout.search.outlook import Outlook
from layoutkit_relayout.search.search import Search

ONE = {"a": (1.0, 1.0), "b": (1.0, 1.0)}


def weighed(first: float, second: float) -> Facade:
    """Return a row of bays: `a` is likelier than `b` by the ratio of the weights."""
    facade = row(ONE)
    more = [
        *sequences("R", "⊢ a", "a a", "b a", weight=first),
        *sequences("R", "⊢ b", "a b", "b b", weight=second),
        *sequences("R", "a ⊣", "b ⊣", weight=min(first, second)),
    ]
    return Facade("weighed", "m", facade.root, constraints=(*sized("R", ONE), *more))


def draw(found: Search, count: int) -> Counter[tuple[str, ...]]:
    """Draw words of the only group, each by an even share of all weight."""
    (group,) = found.model.groups
    question = Outlook(found.model, found.size, {}).question(group)
    assert question is not None
    fitting = found.candidates.fitting(group, question, question.members, inf)
    generator = np.random.default_rng(4)
    return Counter(fitting.draw(generator.random()) for _ in range(count))


def stated(found: Search, words: Sequence[tuple[str, ...]]) -> list[float]:
    """Return the share of each word: the product of its letters' weights in the states it goes through."""
    (group,) = found.model.groups
    machine = group.machine(group.members)
    weights = found.model.weights(group, machine)
    shares = []
    for word in words:
        state, share = 0, 1.0
        for letter in map(machine.letters.index, word):
            share *= float(weights[state, letter])
            state = int(machine.next[state, letter])
        shares.append(share)
    return [share / sum(shares) for share in shares]


@pytest.mark.parametrize("weights", [(1.0, 1.0), (3.0, 1.0), (1.0, 9.0)])
def test_words_are_drawn_by_weight(weights: tuple[float, float]) -> None:
    found = search(weighed(*weights), 4.0)
    words = [*product("ab", repeat=4)]
    expected = stated(found, words)
    seen = draw(found, 4000)
    kept = [n for n, share in enumerate(expected) if share * 4000 >= 5]
    rest = 4000 - sum(seen[words[n]] for n in kept)
    counts = [seen[words[n]] for n in kept] + ([rest] if len(kept) < len(words) else [])
    shares = [4000 * expected[n] for n in kept]
    shares += [4000 - sum(shares)] if len(kept) < len(words) else []
    assert chisquare(counts, shares).pvalue > 0.01


def test_a_weight_is_a_ratio() -> None:
    """With weights 3 and 1, a word with one more of `a` in place of `b` is three times as likely."""
    words = [tuple("aaaa"), tuple("aaab"), tuple("abab"), tuple("bbbb")]
    own = stated(search(weighed(3.0, 1.0), 4.0), words)
    assert [own[0] / share for share in own] == pytest.approx([1.0, 3.0, 9.0, 81.0])


def test_equal_weights_change_nothing() -> None:
    for weight in (1.0, 5.0):
        found = search(weighed(weight, weight), 5.0)
        plain = search(row(ONE), 5.0)
        for index in range(8):
            assert found.variation(1, index, 500).root == plain.variation(1, index, 500).root


def test_variations_follow_the_weights() -> None:
    door = Region("R", 1.0, 3.0, "columns", (Region("a", 1.0, 3.0), Region("b", 1.0, 3.0)))
    either = [*sequences("R", "⊢ a ⊣", weight=4.0), *sequences("R", "⊢ b ⊣")]
    facade = Facade("either", "m", door, constraints=(*sized("R", ONE), *either))
    found = search(facade, 1.0)
    seen = Counter(found.variation(2, index, 100).root.word for index in range(500))  # type: ignore[union-attr]  # all are found
    assert chisquare([seen["a",], seen["b",]], [400.0, 100.0]).pvalue > 0.01


def test_without_weights_none_are_looked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(self: Covering, state: object, symbol: str) -> float:
        raise AssertionError("a weight was asked for")

    monkeypatch.setattr(Covering, "weight", fail)
    assert search(stack({"F": ONE, "G": ONE}), 4.0).variation(0, 0, 100).root is not None


def test_pieces_that_a_word_is_in_weigh() -> None:
    rare, common = Piece((frozenset("a"), frozenset("b")), True, False, 2.0), Piece((frozenset("b"),) * 2)
    automaton = Covering((rare, common))
    assert automaton.weighs
    assert automaton.weight(automaton.start(), "a") == 2.0
    after = automaton.step(automaton.start(), "a")
    assert after is not None
    assert automaton.weight(after, "b") == 2.0
    assert automaton.weight(after, "a") == 0.0


def test_mirrored_words_weigh_at_the_near_end() -> None:
    facade = weighed(3.0, 1.0)
    mirrored = Facade("m", "m", facade.root, constraints=(*facade.constraints, Symmetry(of=("R",))))
    found = search(mirrored, 4.0)
    (group,) = found.model.groups
    weights = found.model.weights(group, machine := group.machine(group.members))
    near = {part[0]: float(weights[0, letter]) for letter, part in enumerate(machine.parts) if len(part) > 1}
    assert near["a"] == pytest.approx(3 * near["b"])
