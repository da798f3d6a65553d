"""Replaying: an operations tree made again on a site (Guerrero et al. 2015, section 4.1)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from layoutkit.diagnostics import Diagnostic, Faulty, blame
from layoutkit.model import Scene, World
from layoutkit.operations import Branch, Context, Node, Operation, Operations, Site
from layoutkit.operations.operation import Scope
from layoutkit.operations.sites import number_of, sites_of

#: Chance of an operation, and of dealing out what it made.
_DOING, _DEALING = 0, 1


@dataclass
class Replay:
    """The replay of an operations tree on one site.

    Attributes
    ----------
    operations
        The tree.
    context
        Its chance is that of the site; each node has a part of it by its number in document order.
    outputs
        What each node has made so far, by its number.
    parts
        What each branch was dealt, by the number of its node and its own there, from 0.
    scopes
        What each node worked on, by its number.
    """

    operations: Operations
    context: Context
    outputs: dict[int, Scope] = field(default_factory=dict)
    parts: dict[tuple[int, int], Scope] = field(default_factory=dict)
    scopes: dict[int, Scope] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._numbers = {id(node): number for number, node in enumerate(self.operations.nodes)}

    def on(self, site: Site, beside: Collection[str] = ()) -> Site:
        """Return a site after all operations.

        Parameters
        ----------
        beside
            Names of elements that are nothing to work on.
        """
        scope = tuple(name for name in site.elements if name not in beside)
        return self._all(self.operations.roots, scope, site)

    def _all(self, nodes: Sequence[Node], scope: Scope, site: Site) -> Site:
        for node in nodes:
            # What an earlier one took away is no longer there to work on.
            there = tuple(name for name in scope if name in site.elements or name in site.surfaces)
            site = self._one(node, there, site)
        return site

    def _one(self, node: Node, scope: Scope, site: Site) -> Site:
        number = self._numbers[id(node)]
        own = self.context.within(number)
        self.scopes[number] = scope
        site, made = node.operation.apply(scope, site, own.within(_DOING))
        output = self.outputs[number] = _standing(made, site, node.operation)
        site = self._all(node.children, output, site)
        for index, part in enumerate(dealt_out(output, node.branches, own.within(_DEALING))):
            self.parts[number, index] = part
            site = self._all(node.branches[index].children, part, site)
        return site


@dataclass(frozen=True)
class Replayed:
    """What a replay came to.

    Attributes
    ----------
    scene
        It was made on.
    replays, sites
        One each for every site of the scene, in document order.
    given
        Names of the polygons that sites began with.
    context
        With what was told.
    """

    scene: Scene
    replays: tuple[Replay, ...]
    sites: tuple[Site, ...]
    given: frozenset[str]
    context: Context

    @property
    def world(self) -> World:
        """All of it in three dimensions, but for sites that are not sound."""
        return self._finished[0]

    @property
    def faults(self) -> tuple[Diagnostic, ...]:
        """What is wrong: with sites that are left out of the world, and with what is not shown."""
        return self._finished[1]

    @cached_property
    def _finished(self) -> tuple[World, tuple[Diagnostic, ...]]:
        from layoutkit_operations.finishing.dressing import Photos
        from layoutkit_operations.finishing.worlds import world_of

        return world_of(self.scene, self.given, self.sites, Photos())


def replayed(
    operations: Operations, scene: Scene, context: Context, names: Collection[str] | None = None
) -> Replayed:
    """Make the operations of a tree on the sites of a scene; what fails on one is told, and the others go on.

    Parameters
    ----------
    context
        Its chance begins with the seed; each site has a part of it by its name.
    names
        Which sites; None: all.
    """
    replays, sites = [], []
    given: set[str] = set()
    every = sites_of(scene, operations.sites)
    known = {own.name for own in every} if operations.sites else set()
    for own in every:
        if names is not None and own.name not in names:
            continue
        # The polygons of sites inside this one are in the way, and nothing to work on: the others' own.
        inner = {p.name for p in own.polygons[1:] if p.name in known}
        replay = Replay(operations, context.within(number_of(scene.name, own.name)))
        try:
            site = replay.on(Site.of(own), inner)
        except Faulty as faulty:
            context.report(*faulty.diagnostics)
            continue
        except blame.ANYTHING as error:  # a site that cannot be built takes no other with it
            context.report(blame.unforeseen(error))
            continue
        replays.append(replay)
        sites.append(replace(site, elements={n: e for n, e in site.elements.items() if n not in inner}))
        given |= {polygon.name for polygon in own.polygons} - inner
    return Replayed(scene, tuple(replays), tuple(sites), frozenset(given), context)


def _standing(made: Scope, site: Site, operation: Operation) -> Scope:
    """Return what an operation says that it made, each once.

    Raises
    ------
    Misbehaviour
        If some of it is not there.
    """
    for name in made:
        if name not in site.elements and name not in site.surfaces:
            raise blame.Misbehaviour(operation, f"says that it made {name!r}, which is not there")
    return tuple(dict.fromkeys(made))


def dealt_out(output: Scope, branches: Sequence[Branch], context: Context) -> Iterator[Scope]:
    """Yield the part of each branch: what was made is dealt out at random, by the branches' weights.

    All parts are disjoint, and together the whole. Each is as large as its weight asks, up to one.
    """
    if not branches:
        return
    most = max(branch.weight for branch in branches)
    shares = [branch.weight / most for branch in branches]
    total = math.fsum(shares)
    shuffled = context.random().permutation(len(output)).tolist()
    end, begin = float(context.random(0).random()), 0
    for number, share in enumerate(shares):
        end += len(output) * share / total
        last = len(output) if number == len(branches) - 1 else max(begin, min(int(end), len(output)))
        yield tuple(output[index] for index in sorted(shuffled[begin:last]))
        begin = last
