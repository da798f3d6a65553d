"""The conformance suite: every promise that a constraint kind gives, tried on facades."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import islice
from pathlib import Path

import numpy as np

from layoutkit.diagnostics.blame import Misbehaviour
from layoutkit.sizing.threads import single_threaded
from layoutkit.testing import agreement, claiming, declaration, messages, rules, steadiness
from layoutkit.testing.agreement import Trial
from layoutkit.testing.finding import Finding, raised
from layoutkit.testing.subjects import Kind, subjects

#: So many findings of one promise are told.
_TOLD = 3
#: So many facades are asked about in other processes: the last ones, with all elements among them.
_ASKED = 4


@dataclass(frozen=True)
class Conformance:
    """A constraint kind, and what it is tried with.

    Parameters
    ----------
    kind
        The class.
    elements
        Constraints of the kind as they stand in documents, e.g. ``<golden:ratio of="@Window"/>``: each is
        tried by itself, and all together, in the facades of `layoutkit.testing.HOUSES`.
    documents
        Facade documents of one's own, as texts or files.
    seed
        Of the layouts that are drawn.
    """

    kind: Kind
    elements: tuple[str, ...] = ()
    documents: tuple[str | Path, ...] = ()
    seed: int = 0

    @cached_property
    def _tried(self) -> tuple[list[Trial], list[Finding]]:
        found, wrong = subjects(self.kind, self.elements, self.documents)
        return [Trial(subject, np.random.default_rng(self.seed)) for subject in found], wrong

    @property
    def trials(self) -> list[Trial]:
        """What the kind is tried with."""
        return self._tried[0]

    def findings(self, promise: str) -> list[Finding]:
        """Return where the kind does not keep a promise, by its name in `PROMISES`."""
        with single_threaded():
            return list(islice(_guarded(promise, self._asked(promise)), _TOLD))

    def _asked(self, promise: str) -> Iterator[Callable[[], Iterable[Finding]]]:
        if promise == "declaration":
            yield partial(declaration.declared, self.kind)
            yield lambda: self._tried[1]
            for trial in self.trials:
                yield partial(declaration.written, trial.subject)
        elif promise == "determinism":
            yield lambda: (f for f in self._steady if f.promise == promise)
        elif promise == "state":
            yield lambda: (f for f in self._steady if f.promise == promise)
            for trial in self.trials:
                yield partial(steadiness.untouched, trial.subject)
        else:
            for trial in self.trials:
                for ask in _BY_TRIAL[promise]:
                    yield partial(ask, trial)

    @cached_property
    def _steady(self) -> list[Finding]:
        return list(steadiness.steady([trial.subject for trial in self.trials[-_ASKED:]]))


_BY_TRIAL: Mapping[str, Sequence[Callable[[Trial], Iterator[Finding]]]] = {
    "messages": (messages.faults, messages.violations),
    "rules": (rules.word_rules, rules.size_rules),
    "prunings": (agreement.prunings,),
    "rows": (agreement.rows,),
    "beginnings": (agreement.beginnings,),
    "claims": (claiming.claims, claiming.parts, claiming.relations),
}

#: What a constraint kind promises, by name.
PROMISES: Mapping[str, str] = {
    "declaration": "The class is declared as the host asks for it; what is written can be read again.",
    "messages": "Unknown names are refused, with place and suggestion; violations say where and how much.",
    "rules": "Rules have their constraint as origin, finite numbers, arrays of the right shape, few states.",
    "prunings": "No arrangement is pruned of which there is a layout without violations.",
    "rows": "What keeps all rules has no violations, and what has no violations keeps all rows.",
    "beginnings": "What is asked while some words are undecided is kept whatever they come to be.",
    "claims": "What it claims beforehand follows from what it demands; its parts together are the whole.",
    "determinism": "The same question has the same answer, in any process.",
    "state": "Nothing is remembered outside the facade, and nothing that is given is changed.",
}


def _guarded(promise: str, asked: Iterable[Callable[[], Iterable[Finding]]]) -> Iterator[Finding]:
    """Yield findings; what is raised is one."""
    for ask in asked:
        try:
            yield from ask()
        except Misbehaviour as error:
            yield Finding(promise, str(error))
        except Exception as error:  # whatever is raised is the finding
            yield Finding(promise, f"raises {raised(error)}")


def conforms(
    kind: Kind,
    elements: Sequence[str] = (),
    documents: Sequence[str | Path] = (),
    *,
    promises: Sequence[str] = tuple(PROMISES),
    seed: int = 0,
) -> list[Finding]:
    """Return where a constraint kind does not keep its promises; an empty list if it keeps them all.

    Parameters
    ----------
    kind, elements, documents, seed
        As for `Conformance`.
    promises
        Which ones to try.
    """
    tried = Conformance(kind, tuple(elements), tuple(documents), seed)
    return [finding for promise in promises for finding in tried.findings(promise)]
