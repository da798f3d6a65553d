"""Promises about single rules: they say whose they are, and something can be made of them."""

from __future__ import annotations

from collections.abc import Iterator

from layoutkit.constraints.language import MOST_STATES, TooManyStates, language
from layoutkit.constraints.word_rules import Admits, Automaton
from layoutkit.sizing.answers import size_rules_of
from layoutkit.sizing.rules import Target
from layoutkit.testing.agreement import Trial
from layoutkit.testing.finding import Finding
from layoutkit.testing.keeping import accepted

#: So many arrangements are asked for their rules.
_ASKED = 40


def word_rules(trial: Trial) -> Iterator[Finding]:
    """Yield rules on words that do not say whose they are, and automata that are no good."""
    own = trial.subject.constraints
    for rule in trial.word_rules:
        what = f"{type(rule).__name__} of {getattr(rule, 'path', 'several regions')}"
        if not rule.origin or any(origin not in own for origin in rule.origin):
            message = f"{what}: its origin is not the constraints that it comes from: {rule.origin!r}"
            yield Finding("rules", message, str(trial.subject))
        if isinstance(rule, Admits):
            symbols = dict.fromkeys(trial.subject.facade.regions[rule.path].word)
            for wrong in _automaton(rule.automaton, tuple(symbols)):
                yield Finding("rules", f"{what}: {wrong}", str(trial.subject))


def _automaton(automaton: Automaton, letters: tuple[str, ...]) -> Iterator[str]:
    try:
        one = language(automaton, letters)
    except TooManyStates:
        yield (
            f"its automaton has more than {MOST_STATES:,} states: one that counts should stop counting where "
            "more makes no difference"
        )
        return
    except TypeError as error:
        yield f"its automaton has states that cannot be hashed: {error}"
        return
    if language(automaton, letters) != one:
        yield "its automaton reads words in another way the second time"
    for word in (letters, letters[::-1], letters * 2):
        if word and (word in one) != accepted(automaton, word):
            yield f"its automaton reads {' '.join(word)} in another way the second time"


def size_rules(trial: Trial) -> Iterator[Finding]:
    """Yield rules on sizes that do not say whose they are; what is no number is raised."""
    for sample in trial.chance[:_ASKED]:
        for constraint in trial.subject.constraints:
            for rule in size_rules_of(constraint, sample.arrangement):
                if not isinstance(rule, Target) and rule.origin is not constraint:
                    message = f"a {type(rule).__name__} has {rule.origin!r} as its origin: pass self"
                    yield trial.finding("rules", message, sample)
        for path in sample.arrangement.words:
            part = sample.without(path).arrangement
            for constraint in trial.subject.constraints:
                list(size_rules_of(constraint, part))
