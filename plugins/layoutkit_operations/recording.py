"""Recording: operations made on an example scene, and kept as a tree that can be replayed elsewhere.

A session of modelling in Python::

    session = Recorder(scene, sites=("Plot",))
    houses = session.select("Plot").place("House", {"Plot_1": [Placement(8, 9, 10, 8)]})
    solid = houses.do(Extrude(height=6, random=0.2, cap="gable"))
    solid.select("Front").do(Vary(facade=design("house/facade.xml", folder)))
    session.operations("houses")
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from layoutkit.constraints.attributes import Attribute
from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.model import LearningSettings, Placement, PlacementModel, Scene, World
from layoutkit.operations import Asset, Branch, Context, Design, Named, Node, Operation, Operations, Steps
from layoutkit.operations.operation import Scope
from layoutkit_operations.kinds.place import Place
from layoutkit_operations.kinds.select import Select
from layoutkit_operations.matching import misfits, unmatched
from layoutkit_operations.replaying import Replay, Replayed, replayed
from layoutkit_operations.standing import Standing

if TYPE_CHECKING:
    from layoutkit.hooks.running import Runner


class Recorder:
    """A session of modelling on an example scene.

    Every step is an operation, which works on what the step before it made. What a step comes to is found by
    replaying all that was recorded: so it is the same here as anywhere.

    Parameters
    ----------
    scene
        The example.
    sites
        Labels of polygons that are built on each by itself; see `layoutkit.operations.Operations`.
    seed
        Start of all random choices.
    stages
        What runs stages; by default with all installed plugins.
    """

    def __init__(
        self, scene: Scene, sites: Sequence[str] = (), seed: int = 0, stages: Runner | None = None
    ) -> None:
        self._scene, self._seed = scene, seed
        self._sites = (sites,) if isinstance(sites, str) else tuple(sites)
        self._stages = stages or _runner()
        self._roots: list[_Draft] = []
        self._made: Replayed | None = None

    def do(self, operation: Operation) -> Step:
        """Make an operation on the whole scene: a root of the tree."""
        return self._added(self._roots, operation)

    def select(self, *labels: str) -> Step:
        """Choose what has one of some labels, in the whole scene."""
        return self.do(Select(labels=labels))

    def operations(self, name: str) -> Operations:
        """Return what was recorded."""
        roots = tuple(draft.node() for draft in self._roots)
        return Operations(name, self._scene.units, roots, self._sites)

    @property
    def world(self) -> World:
        """The example scene as it is now, in three dimensions."""
        return self._replayed().world

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """What operations had to say, and what is wrong with what they came to."""
        made, recorded = self._replayed(), self.operations(self._scene.name)
        told = (*misfits(recorded, self._scene), *made.context.told, *made.faults, *unmatched(recorded, made))
        return tuple(dict.fromkeys(told))

    def _added(self, drafts: list[_Draft], operation: Operation) -> Step:
        if not isinstance(operation, Operation):
            hint = "take one of layoutkit_operations.kinds"
            raise Faulty([_nonsense(f"{operation!r} is no operation", hint)])
        if faults := tuple(_misfits(operation)) or tuple(operation.faults()):
            raise Faulty(faults)
        draft = _Draft(operation)
        drafts.append(draft)
        self._made = None
        return Step(self, draft)

    def _replayed(self) -> Replayed:
        """Return what all that was recorded comes to; it is replayed once."""
        if self._made is None:
            context = Context(self._stages, (self._seed,))
            self._made = replayed(self.operations(self._scene.name), self._scene, context)
        return self._made

    def _number(self, draft: _Draft) -> int:
        """Return the number of a node in document order."""
        order: list[_Draft] = []
        for root in self._roots:
            root.listed(order)
        return next(number for number, other in enumerate(order) if other is draft)


@dataclass(frozen=True)
class Step:
    """A recorded operation, or one part of what it made.

    Attributes
    ----------
    branch
        Which of the parts that its output was dealt into; None: all of it.
    """

    recorder: Recorder
    draft: _Draft
    branch: int | None = None

    def do(self, operation: Operation) -> Step:
        """Make an operation on what this step made.

        Raises
        ------
        Faulty
            If the operation makes no sense by itself.
        """
        own = self.draft.children if self.branch is None else self.draft.branches[self.branch].children
        return self.recorder._added(own, operation)

    def select(self, *labels: str, without: Sequence[str] = ()) -> Step:
        """Choose what has one of some labels, of what this step made and all that stands on it."""
        return self.do(Select(labels=labels, without=tuple(without)))

    def place(
        self,
        label: str,
        examples: Mapping[str, Sequence[Placement]],
        settings: LearningSettings = LearningSettings(),  # noqa: B008 - frozen
        like: Place = Place(),  # noqa: B008 - frozen
    ) -> Step:
        """Learn from a few placements, and place such shapes in all that this step made.

        Parameters
        ----------
        label
            What is placed.
        examples
            By the name of an element or a surface, placements in its coordinates. What stands there is what
            they are related to.
        settings
            What learning goes by.
        like
            An operation whose attributes are taken, but for its model.

        Raises
        ------
        Faulty
            If a name is not there, or nothing can be learned.
        """
        model = self._learned(label, examples, settings)
        return self.do(replace(like, model=model))

    def split(self, *weights: float) -> tuple[Step, ...]:
        """Deal what this step made out at random into disjoint parts, each as large as its weight asks."""
        if wrong := [weight for weight in weights if not 0 < weight < math.inf]:
            hint = "weights are above 0: a part that is left as it is has a weight, too"
            raise Faulty([_nonsense(f"split: {wrong[0]!r} is no weight", hint)])
        begin = len(self.draft.branches)
        self.draft.branches += (_DraftBranch(weight) for weight in weights)
        self.recorder._made = None
        return tuple(Step(self.recorder, self.draft, begin + number) for number in range(len(weights)))

    @property
    def output(self) -> Scope:
        """Names of what this step made, over all sites."""
        number = self.recorder._number(self.draft)
        return tuple(name for own in self.recorder._replayed().replays for name in self._of(own, number))

    def scene(self, name: str) -> Scene:
        """Return the scene that shapes would be placed in, in an element or on a surface of a name.

        Raises
        ------
        Faulty
            If there is no such name (LK889).
        """
        for site in self.recorder._replayed().sites:
            if name in site.elements or name in site.surfaces:
                found = next(iter(Standing(site).scenes(name)), None)
                if found is not None:
                    return found[1]
        raise Faulty([_unknown(name, self.output)])

    def _of(self, replay: Replay, number: int) -> Scope:
        if self.branch is None:
            return replay.outputs.get(number, ())
        return replay.parts.get((number, self.branch), ())

    def _learned(
        self, label: str, examples: Mapping[str, Sequence[Placement]], settings: LearningSettings
    ) -> PlacementModel:
        scenes = [
            replace(self.scene(name), placements=tuple(replace(shape, label=label) for shape in shapes))
            for name, shapes in examples.items()
        ]
        if not scenes:
            raise Faulty([_unknown("", self.output)])
        first, *more = scenes
        stages = self.recorder._stages
        outcome = next(iter(stages("learn", first, label=label, more=tuple(more), settings=settings)))
        assert isinstance(outcome.document, PlacementModel)  # or it would have raised
        return outcome.document


def design(file: str, folder: Path) -> Design:
    """Return a facade's document, and its picture, as operations hold it.

    Parameters
    ----------
    file
        Relative to the folder that the operations' document will lie in.
    folder
        That folder.

    Raises
    ------
    Faulty
        If it cannot be read, or is no facade.
    """
    from layoutkit import documents
    from layoutkit.model import Facade

    path = folder / file
    facade = documents.read(path, _runner().host.constraints).model
    if not isinstance(facade, Facade):
        message, hint = f"{file} is a layout", "name the facade's own document"
        raise Faulty([Diagnostic("LK702", message, hint=hint, topic="usage")])
    picture = None if facade.picture is None else documents.load(path.parent / facade.picture.file)
    return Design(file, facade, picture)


def steps(file: str, folder: Path) -> Steps:
    """Return the edits of a session's document, as operations hold them.

    Parameters
    ----------
    file, folder
        As for `design`.

    Raises
    ------
    Faulty
        If it cannot be read, or is no session.
    """
    from layoutkit.documents.beside import DISK
    from layoutkit.documents.sessions import read_session

    read = read_session(folder / file, _runner().host.constraints, DISK)
    return Steps(file, read.session.done)


def asset(file: str, folder: Path) -> Asset:
    """Return a mesh that others modelled, as operations hold it.

    Parameters
    ----------
    file, folder
        As for `design`.

    Raises
    ------
    Faulty
        If it cannot be read; whether it is a mesh is asked when it is used.
    """
    from layoutkit import documents

    return Asset(file, documents.load(folder / file))


@dataclass(eq=False)
class _Draft:
    """A node that may still get children."""

    operation: Operation
    children: list[_Draft] = field(default_factory=list)
    branches: list[_DraftBranch] = field(default_factory=list)

    def node(self) -> Node:
        children = tuple(child.node() for child in self.children)
        branches = (
            Branch(tuple(child.node() for child in branch.children), branch.weight)
            for branch in self.branches
        )
        return Node(self.operation, children, tuple(branches))

    def listed(self, order: list[_Draft]) -> None:
        order.append(self)
        for child in (*self.children, *(c for branch in self.branches for c in branch.children)):
            child.listed(order)


@dataclass(eq=False)
class _DraftBranch:
    weight: float
    children: list[_Draft] = field(default_factory=list)


def _misfits(operation: Operation) -> Iterator[Diagnostic]:
    """Yield which attributes have values that no document can hold."""
    for attribute in operation.attributes():
        value = getattr(operation, attribute.field_name)
        if value == attribute.default and not attribute.required:
            continue
        try:
            read = attribute.type.parse(attribute.type.text(value))
            fits = isinstance(value, type(read)) if isinstance(read, Named) else read == value
        except (ValueError, TypeError, AttributeError):  # it is of another kind altogether
            fits = False
        if not fits:
            message = f"<{operation.kind}>: {attribute.name} is {value!r}, and no {attribute.type.name}"
            yield _nonsense(message, _meant(value, attribute))
        elif isinstance(value, Named) and not value.read:
            hint = "read it first: by design, steps or asset of layoutkit_operations.recording"
            yield _nonsense(f"<{operation.kind}>: {attribute.name} names {value}, which was not read", hint)


def _meant(value: Any, attribute: Attribute) -> str:
    """Return what to write: where a value stands as in documents, what Python has for it."""
    try:
        return f"write {attribute.type.parse(value)!r}"
    except (ValueError, TypeError, AttributeError):
        return attribute.help


def _nonsense(message: str, hint: str) -> Diagnostic:
    return Diagnostic("LK882", message, hint=hint, topic="operations")


def _runner() -> Runner:
    from layoutkit.hooks.host import Host
    from layoutkit.hooks.running import Runner

    return Runner(Host.load())


def _unknown(name: str, known: Scope) -> Diagnostic:
    from layoutkit.diagnostics import did_you_mean

    if not name:
        hint = "show placements by the name of what they are in"
        return Diagnostic("LK889", "there are no examples", hint=hint, topic="operations")
    message = f"nothing is called {name!r} at this step"
    return Diagnostic("LK889", message, hint=did_you_mean(name, known), topic="operations")
