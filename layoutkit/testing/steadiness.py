"""Promises about answers: the same again, in any process and any order, and nothing else is touched."""

from __future__ import annotations

import random  # noqa: TID251 - to see whether a plugin uses its global state
from collections.abc import Iterator, Sequence
from dataclasses import replace
from difflib import unified_diff
from typing import Any

import numpy as np

from layoutkit.model import Facade
from layoutkit.testing.finding import Finding
from layoutkit.testing.sampling import Sample
from layoutkit.testing.subjects import Subject, grown, own_constraints
from layoutkit.testing.testimony import samples_of, testimony
from layoutkit.testing.witness import Silent, Told, asked, hear, witnesses


def steady(subjects: Sequence[Subject]) -> Iterator[Finding]:
    """Yield where an answer is another one the second time, in other processes, after other questions."""
    if not subjects:
        return
    order = asked(subjects)
    first: Told = {(n, larger): hear(subjects[n], larger) for n, larger in order}
    for (n, larger), told in first.items():
        if again := _difference(told, hear(subjects[n], larger)):
            yield _finding("determinism", "asked twice, it answers differently", subjects[n], again)
            return
    try:
        yield from _elsewhere(first, subjects)
    except Silent as error:
        message = f"another process cannot be asked: {error}; the class has to be importable from its module"
        yield Finding("determinism", message)


def _elsewhere(first: Told, subjects: Sequence[Subject]) -> Iterator[Finding]:
    """Ask two other processes: one the same, one with other hashes, and in the reverse order."""
    order = asked(subjects)
    same, other = witnesses(subjects, (order, order[::-1]), (1, 2))
    if first != same:
        message = "another process answers differently: nothing may hang on what a process is, or has done"
        yield _compared(first, same, subjects, "determinism", message)
    if same == other:
        return
    (hashed,) = witnesses(subjects, (order,), (2,))
    if same != hashed:
        message = "it answers differently where texts have other hashes: sort what comes out of a set"
        yield _compared(same, hashed, subjects, "determinism", message)
    if hashed != other:
        message = "it answers differently after other questions: it remembers something outside the facade"
        yield _compared(hashed, other, subjects, "state", message)


def _compared(one: Told, other: Told, subjects: Sequence[Subject], promise: str, message: str) -> Finding:
    """Return the finding that two witnesses differ, with what first shows it."""
    n, larger = next(key for key, told in one.items() if told != other[key])
    return _finding(promise, message, subjects[n], _difference(one[n, larger], other[n, larger]))


def _finding(promise: str, message: str, subject: Subject, lines: tuple[str, ...]) -> Finding:
    return Finding(promise, message, str(subject), lines)


def _difference(one: Sequence[str], other: Sequence[str]) -> tuple[str, ...]:
    if tuple(one) == tuple(other):
        return ()
    lines = list(unified_diff(one, other, "once", "then", n=0, lineterm=""))
    return tuple(line[:300] for line in lines[3:9])


def untouched(subject: Subject) -> Iterator[Finding]:
    """Yield what is remembered outside the facade, and what is changed that is given or global."""
    fresh = subject.again()
    larger = grown(fresh, fresh.constraints)
    told = testimony(larger, own_constraints(larger, subject.kind), samples_of(larger))
    shared = grown(subject.again(), subject.facade.constraints)
    testimony(subject.facade, subject.constraints, samples_of(subject.facade))
    answer = testimony(shared, own_constraints(shared, subject.kind), samples_of(shared))
    if lines := _difference(told, answer):
        message = "asked about another facade, a constraint answers by one that it has seen before"
        yield _finding("state", message, subject, lines)
    facade = replace(subject.again())  # without what has been worked out about it
    samples = samples_of(facade)
    before, state = _inputs(replace(facade), samples), _globals()
    testimony(facade, own_constraints(facade, subject.kind), samples)
    after = _globals()
    for name in state:
        if state[name] != after[name]:
            yield Finding("state", f"it uses {name}", str(subject))
    if before != _inputs(facade, samples):
        message = "it changes what it is given: the facade, an arrangement, or a layout"
        yield Finding("state", message, str(subject))


def _globals() -> dict[str, Any]:
    """Return what a kind may neither read nor change."""
    name, keys, *rest = np.random.get_state()  # noqa: NPY002 - to see whether a plugin uses it
    return {
        "numpy's global generator: take no random numbers": (name, np.asarray(keys).tobytes(), tuple(rest)),
        "Python's global generator: take no random numbers": random.getstate(),
        "numpy's way of treating errors": tuple(np.geterr().items()),
    }


def _inputs(facade: Facade, samples: Sequence[Sample]) -> str:
    parts: list[object] = [facade.root, facade.constraints, sorted(facade.regions), sorted(facade.labels)]
    for sample in samples:
        own = sample.arrangement
        parts += [dict(own.words), list(own.frames.items()), own.variables, len(own.tilings), sample.root]
    return repr(parts)
