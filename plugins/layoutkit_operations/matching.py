"""Whether operations match a scene: its units, its sites, and what they choose."""

from __future__ import annotations

from collections.abc import Iterator

from layoutkit.diagnostics import Diagnostic, Severity, did_you_mean
from layoutkit.model import Scene
from layoutkit.operations import Operations
from layoutkit_operations.kinds.select import Select, reached
from layoutkit_operations.replaying import Replayed


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
