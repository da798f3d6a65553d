"""What operations are given besides what they work on: chance, stages, and where to report."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Protocol

from layoutkit.diagnostics import Diagnostic, Faulty

if TYPE_CHECKING:
    from numpy.random import Generator

    from layoutkit.hooks.specs import Outcome


def named(name: str) -> int:
    """Return a number for a name, by which chance hangs on nothing else."""
    return zlib.crc32(name.encode())


class Stages(Protocol):
    """Runs stages by their names, whichever plugin they are of."""

    def __call__(self, stage: str, document: Any, /, **options: Any) -> Iterator[Outcome]:
        """Yield what a stage makes of a document, with its default options but for those given."""


@dataclass(frozen=True)
class Context:
    """What an operation is given.

    Attributes
    ----------
    stages
        Runs stages of any plugin.
    entropy
        What all chance of the operation begins with: the seed, then the scene, the site and the node.
    told
        What is reported, in order.
    kept
        What was worked out once for all elements and sites, by keys that say what it hangs on.
    """

    stages: Stages
    entropy: tuple[int, ...]
    told: dict[Diagnostic, None] = field(default_factory=dict)
    kept: dict[Any, Any] = field(default_factory=dict)

    def random(self, *which: int) -> Generator:
        """Return the chance of one of the things that an operation works on: it hangs on no other."""
        from numpy.random import SeedSequence, default_rng

        return default_rng(SeedSequence(self.entropy[0], spawn_key=(*self.entropy[1:], *which)))

    def within(self, *which: int) -> Context:
        """Return the context of a part of the work, with chance of its own."""
        return replace(self, entropy=(*self.entropy, *which))

    def run(self, stage: str, document: Any, **options: Any) -> Outcome | None:
        """Return the first outcome of a stage, and report what it says; faults are reported, too.

        Returns
        -------
        Outcome or None
            None where the document has faults.
        """
        try:
            outcome = next(iter(self.stages(stage, document, **options)))
        except Faulty as faulty:
            self.report(*faulty.diagnostics)
            return None
        self.report(*outcome.diagnostics)
        return outcome

    def report(self, *diagnostics: Diagnostic) -> None:
        """Add to what is told, each once."""
        self.told.update(dict.fromkeys(diagnostics))
