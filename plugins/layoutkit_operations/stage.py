"""The stage that replays an operations tree on a scene."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Scene

if TYPE_CHECKING:
    from layoutkit.operations import Operations
    from layoutkit.operations.context import Stages


@dataclass(frozen=True)
class ReplayOptions:
    """Options of the stage `replay`.

    Attributes
    ----------
    operations
        What is to be replayed.
    seed
        Start of all random choices.
    sites
        Names of the sites that are to be built, where there are sites; None: all.
    stages
        How operations run stages of other plugins.
    """

    operations: Operations | None = None
    seed: int = 0
    sites: tuple[str, ...] | None = None
    stages: Stages | None = None


class ReplayOperations(Stage):
    """Makes a session of modelling again (Guerrero et al. 2015, section 4.1)."""

    name: ClassVar[str] = "replay"
    summary: ClassVar[str] = "Makes the operations of a tree again on a scene, in three dimensions."
    options: ClassVar[type] = ReplayOptions
    takes: ClassVar[type] = Scene

    def run(self, scene: Scene, options: ReplayOptions) -> Iterator[Outcome]:
        """Yield the world that comes of a scene, once; every body of it was checked.

        Raises
        ------
        Faulty
            If there are no operations, or no way to run stages, or they do not fit the scene (LK881).
        """
        from layoutkit.operations import Context
        from layoutkit.sizing.threads import single_threaded
        from layoutkit_operations.matching import misfits, unmatched
        from layoutkit_operations.replaying import replayed

        operations, stages = options.operations, options.stages
        if operations is None or stages is None:
            raise Faulty([Diagnostic("LK881", "there is nothing to replay", topic="operations")])
        if faults := tuple(misfits(operations, scene)):
            raise Faulty(faults)
        start = time.perf_counter()
        context = Context(stages, (options.seed,))
        with single_threaded():
            made = replayed(operations, scene, context, options.sites)
            world = made.world
        told = (*context.told, *made.faults, *unmatched(operations, made))
        yield Outcome("found", world, told, time.perf_counter() - start)
