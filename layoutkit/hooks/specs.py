"""Hook specifications: what a plugin can add, and what it must offer to do so.

A plugin is a module (or object) that an installed package names under the entry point group `layoutkit`, and
that implements some of the hooks of `Hooks`, each marked with `hookimpl`. Everything built in does the same.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import pluggy

from layoutkit.diagnostics import Diagnostic
from layoutkit.diagnostics.origin import PROJECT
from layoutkit.model import Facade

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint
    from layoutkit.model import (
        Count,
        DroppedEdit,
        Evidence,
        Layout,
        Piece,
        PlacementModel,
        ProposedEdit,
        Scene,
        World,
    )
    from layoutkit.model.conflict import Explanation
    from layoutkit.operations import Operation
    from layoutkit.scenes.relationship import Relationship
    from layoutkit.sizing.qp import Backend

#: The version of this interface. A plugin's module may state the one that it was written for, as `API`.
API_VERSION = 1
#: What a plugin's module calls it.
API = "LAYOUTKIT_API"

hookspec = pluggy.HookspecMarker(PROJECT)
hookimpl = pluggy.HookimplMarker(PROJECT)

Status = Literal["found", "infeasible", "limit"]


@dataclass(frozen=True)
class Outcome:
    """One result of a stage.

    Attributes
    ----------
    status
        ``found``; ``infeasible``, which is proved; or ``limit``: the budget ran out.
    document
        The new facade, layout, scene, fitted model or world; None where there is none.
    seconds
        Time spent on this one (search and sizing; no reading, writing or pictures).
    explanation
        Why there is no document, with the layout that comes nearest, where a stage looks for that.
    count
        How many arrangements there are, where a stage counts them.
    proposal
        The edit that leads to the document, or that comes to nothing, where a stage proposes edits.
    origins
        Of an edited facade: for each terminal, by its unique path, the pieces of the original facade that
        its picture is made of.
    evidence
        Of a scene with placements: what speaks for them, where that is asked for.
    """

    status: Status
    document: Facade | Layout | Scene | PlacementModel | World | None
    diagnostics: tuple[Diagnostic, ...] = ()
    seconds: float = 0.0
    explanation: Explanation | None = None
    count: Count | None = None
    proposal: ProposedEdit | DroppedEdit | None = None
    origins: Mapping[str, tuple[Piece, ...]] | None = None
    evidence: Evidence | None = None


class Stage(ABC):
    """Turns one document into others.

    Attributes
    ----------
    name
        What commands ask for, e.g. ``relayout``.
    takes
        What it works on: `layoutkit.model.Facade`, or `layoutkit.model.Scene`.
    summary
        What it does, in one sentence.
    options
        Frozen dataclass of its options, every field with a default. If there is a field `backends`, commands
        hand it the solvers of quadratic programs of all plugins, in the order in which they are to be asked.
    """

    name: ClassVar[str]
    summary: ClassVar[str]
    options: ClassVar[type]
    takes: ClassVar[type] = Facade

    @abstractmethod
    def run(self, document: Any, options: Any, /) -> Iterator[Outcome]:
        """Yield the results, each as soon as it is there.

        Parameters
        ----------
        document
            What to work on.
        options
            An instance of the class's `options`.
        """


class Format(ABC):
    """Reads annotations that others made.

    Attributes
    ----------
    name
        What ``convert --format`` takes, e.g. ``cmp``.
    summary
        What it reads, in one sentence.
    """

    name: ClassVar[str]
    summary: ClassVar[str]

    @abstractmethod
    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file, whose first bytes are `head`, seems to be of this format."""

    @abstractmethod
    def read(self, path: Path, picture: Path | None) -> tuple[Facade, Sequence[Diagnostic]]:
        """Return the facade, its picture's file as given, and remarks on defects survived.

        Raises
        ------
        Faulty
            If nothing can be made of the file.
        """


class SceneFormat(ABC):
    """Reads scenes that others drew.

    Attributes
    ----------
    name
        What ``convert --format`` takes, e.g. ``geojson``.
    summary
        What it reads, in one sentence.
    """

    name: ClassVar[str]
    summary: ClassVar[str]

    @abstractmethod
    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file, whose first bytes are `head`, seems to be of this format."""

    def parts(self, path: Path) -> Sequence[str]:
        """Return the names of the scenes in a file: layers, rooms, flats. By default there is one, unnamed.

        Raises
        ------
        Faulty
            If nothing can be made of the file.
        """
        return ("",)

    @abstractmethod
    def read(self, path: Path, part: str) -> tuple[Scene, Sequence[Diagnostic]]:
        """Return the scene of one of its `parts`, and remarks on defects survived.

        Raises
        ------
        Faulty
            If nothing can be made of the file, or it has no such part.
        """


class Hooks:
    """The hooks. Each is called once, when the program starts to need it."""

    @hookspec
    def layoutkit_constraints(self) -> Iterable[type[Constraint]]:  # type: ignore[empty-body]  # a specification
        """Return constraint kinds: subclasses of `layoutkit.constraints.Constraint`."""

    @hookspec
    def layoutkit_stages(self) -> Iterable[Stage]:  # type: ignore[empty-body]  # a specification
        """Return stages."""

    @hookspec
    def layoutkit_formats(self) -> Iterable[Format]:  # type: ignore[empty-body]  # a specification
        """Return formats that ``convert`` reads."""

    @hookspec
    def layoutkit_qp_backends(self) -> Iterable[Backend]:  # type: ignore[empty-body]  # a specification
        """Return solvers of quadratic programs."""

    @hookspec
    def layoutkit_scene_formats(self) -> Iterable[SceneFormat]:  # type: ignore[empty-body]  # a specification
        """Return formats of scenes."""

    @hookspec
    def layoutkit_relationships(self) -> Iterable[Relationship]:  # type: ignore[empty-body]  # a specification
        """Return functions that relate points and poses to what stands in a scene."""

    @hookspec
    def layoutkit_operations(self) -> Iterable[type[Operation]]:  # type: ignore[empty-body]  # a specification
        """Return kinds of operations: subclasses of `layoutkit.operations.Operation`."""
