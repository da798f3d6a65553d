"""The stage that replays an operations tree on a scene."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic, Faulty, Severity, did_you_mean
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Scene

if TYPE_CHECKING:
    from layoutkit.operations import Operations
    from layoutkit.operations.context import Stages
    from layoutkit_operations.replaying import Replayed


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


def misfits(operations: Operations, scene: Scene) -> Iterator[Diagnostic]:
    """Yield why they cannot (LK881): units differ, or the scene has none of the sites."""
    if operations.units != scene.units:
        named = f"the operations {operations.name} are in {operations.units}"
        yield _misfit(f"{named}, and the scene {scene.name} in {scene.units}", "write both in the same units")
    known = scene.labels
    if operations.sites and set(operations.sites).isdisjoint(known):
        wanted = " or ".join(f"@{label}" for label in operations.sites)
        message = f"the scene {scene.name} has no {wanted}, and {operations.name} builds on nothing else"
        yield _misfit(message, did_you_mean(operations.sites[0], known) if known else "the scene is empty")


def _misfit(message: str, hint: str) -> Diagnostic:
    return Diagnostic("LK881", message, hint=hint, topic="operations")


def unmatched(operations: Operations, made: Replayed) -> Iterator[Diagnostic]:
    """Yield a warning of each selection that chose nothing anywhere, though there was something there."""
    from layoutkit_operations.kinds.select import Select, reached

    for number, node in enumerate(operations.nodes):
        own = node.operation
        if not isinstance(own, Select) or any(replay.outputs.get(number) for replay in made.replays):
            continue
        if set(own.labels) <= set(operations.sites):  # of sites of several labels, a scene may have some
            continue
        seen: dict[str, None] = {}
        for replay, site in zip(made.replays, made.sites, strict=True):
            for name in reached(replay.scopes.get(number, ()), site):
                element = site.elements.get(name)
                labels = element.labels if element is not None else site.surfaces[name].labels
                seen.update(dict.fromkeys(labels))
        if seen:
            message = f"nothing is labelled {' or '.join(own.labels)}, of what is to be chosen of"
            hint = did_you_mean(own.labels[0], seen)
            yield Diagnostic("LK888", message, own.place, hint, Severity.WARNING, "operations")
