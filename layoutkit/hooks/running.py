"""Stages run by their names, with what they are handed of all plugins."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from layoutkit.diagnostics.blame import Misbehaviour
from layoutkit.hooks.host import Host
from layoutkit.hooks.specs import Outcome

if TYPE_CHECKING:
    from layoutkit.scenes.relationship import Relationship
    from layoutkit.sizing.qp import Backend


@dataclass(frozen=True)
class Runner:
    """Runs stages of any plugin.

    A stage whose options have a field `backends`, `relationships` or `stages` is handed the solvers of
    quadratic programs, the relationship functions, or this runner.

    Attributes
    ----------
    host
        The plugins.
    backend
        The solver that is asked first, where one is named.
    """

    host: Host
    backend: str | None = None

    def __call__(self, stage: str, document: Any, /, **options: Any) -> Iterator[Outcome]:
        """Yield what a stage makes of a document, with its default options but for those given.

        Raises
        ------
        Faulty
            If no plugin has a stage of that name, or no solver that of the one to be asked first.
        Misbehaviour
            If the stage takes documents of another kind, or yields something else than outcomes.
        """
        found = self.host.stages.find(stage)
        if not isinstance(document, found.takes):
            kind = type(document).__name__
            raise Misbehaviour(found, f"takes a {found.takes.__name__}, and {stage} is asked of a {kind}")
        asked = found.options()
        handed = {field.name for field in fields(asked)} & {"backends", "relationships", "stages"}
        given = {name: getattr(self, name) for name in sorted(handed)}
        for outcome in found.run(document, replace(asked, **{**given, **options})):
            if not isinstance(outcome, Outcome):
                raise Misbehaviour(found, f"yields {outcome!r}, and no Outcome")
            yield outcome

    @cached_property
    def backends(self) -> tuple[Backend, ...]:
        """The solvers of quadratic programs, in the order in which they are asked."""
        known = self.host.backends
        if self.backend is None:
            return tuple(known.values())
        first = known.find(self.backend)
        return (first, *(other for other in known.values() if other is not first))

    @cached_property
    def relationships(self) -> tuple[Relationship, ...]:
        """The relationship functions of all plugins."""
        return tuple(self.host.relationships.values())

    @property
    def stages(self) -> Runner:
        """The runner itself: what operations run stages by."""
        return self
