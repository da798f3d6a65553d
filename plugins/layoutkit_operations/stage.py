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
    stages
        How operations run stages of other plugins.
    """

    operations: Operations | None = None
    seed: int = 0
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
            If there are no operations, or no way to run stages, or the units differ (LK881).
        """
        from layoutkit.operations import Context
        from layoutkit.sizing.threads import single_threaded
        from layoutkit_operations.checking import faults_of
        from layoutkit_operations.replaying import replayed

        operations, stages = options.operations, options.stages
        if operations is None or stages is None:
            raise Faulty([Diagnostic("LK881", "there is nothing to replay", topic="operations")])
        check_units(operations, scene)
        start = time.perf_counter()
        context = Context(stages, (options.seed,))
        with single_threaded():
            made = replayed(operations, scene, context)
            world = made.world
        faults = [fault for body in world.bodies for fault in faults_of(body)]
        yield Outcome("found", world, (*context.told, *faults), time.perf_counter() - start)


def check_units(operations: Operations, scene: Scene) -> None:
    """Raise `Faulty` where operations and scene count in different units (LK881)."""
    if operations.units != scene.units:
        message = f"the operations {operations.name} are in {operations.units}, the scene in {scene.units}"
        hint = "write both in the same units"
        raise Faulty([Diagnostic("LK881", message, hint=hint, topic="operations")])
