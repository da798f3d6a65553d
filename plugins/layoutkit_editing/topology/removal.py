"""Removal of a row or column from a grid: insertion backwards."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from layoutkit_editing.topology.insertion import Jump
from layoutkit_editing.topology.site import Refused, Site
from layoutkit_editing.tree import Node, Tree

if TYPE_CHECKING:
    from layoutkit.model.session import Gap


def removal(site: Site, at: int, gap: Gap) -> Jump:
    """Remove a line, and with each of its elements what stands between it and the next one.

    Parameters
    ----------
    at
        Index of the line.
    gap
        Which gap goes. Beyond the outermost lines there is a margin, which stays.

    Raises
    ------
    Refused
        If the grid has no other line, or nothing could take an element's room.
    """
    if len(site.lines) == 1:
        raise Refused("the grid has no other line: delete the grid's elements, or the grid, by hand")
    done: set[int] = set()
    gone: set[int] = set()
    for row, element in enumerate(site.lines[at]):
        if element is not None and element not in done:
            alone, doomed = _doomed(site, element, row, at, gap)
            done |= alone
            gone |= set(doomed)
    return Jump(without(site.tree, gone, site.state.elements - done))


def _doomed(site: Site, element: int, row: int, at: int, gap: Gap) -> tuple[frozenset[int], tuple[int, ...]]:
    """Return which elements go together with one, and the nodes that go with them."""
    line = frozenset(own for own in site.lines[at] if own is not None)
    others = dict(_neighbours(site, row, at))
    parent = min(
        (site.tree.common_ancestor(element, other) for other in others.values()),
        key=lambda own: -len(site.tree.ancestors(own)),
        default=None,
    )
    if parent is not None and site.tree.nodes[parent].split == site.split:
        children = site.tree.nodes[parent].children
        own = site.tree.holding(parent, element)
        inside = site.inside(own)
        if inside <= line:
            return inside, (own, *_gap(site, children, children.index(own), parent, others, gap))
    return frozenset({element}), (_alone(site, element),)


def _alone(site: Site, element: int) -> int:
    """Return what goes with one element whose neighbours are no help: what is beside it takes its room.

    Raises
    ------
    Refused
        If nothing is beside it along the axis: whatever reaches across would go with it.
    """
    nodes, parents = site.tree.nodes, site.tree.parents
    own = element
    while own != site.tree.root and nodes[parents[own]].split != site.split:
        own = parents[own]
        if site.inside(own) != {element}:
            own = site.tree.root
    if own == site.tree.root:
        raise Refused(f"nothing is beside {site.called(element)} that could take its room")
    return own


def _neighbours(site: Site, row: int, at: int) -> Iterator[tuple[Gap, int]]:
    """Yield the nearest elements of the row on both sides of a line, as far as there are some."""
    sides: tuple[tuple[Gap, Sequence[tuple[int | None, ...]]], ...] = (
        ("before", site.lines[:at][::-1]),
        ("after", site.lines[at + 1 :]),
    )
    for side, lines in sides:
        nearest = next((line[row] for line in lines if line[row] is not None), None)
        if nearest is not None:
            yield side, nearest


def _gap(
    site: Site, children: Sequence[int], own: int, parent: int, others: dict[Gap, int], gap: Gap
) -> tuple[int, ...]:
    """Return the children between what goes and what holds the next element on one side."""
    there = {side: other for side, other in others.items() if parent in site.tree.ancestors(other)}
    side = gap if gap in there else next(iter(there))
    other = children.index(site.tree.holding(parent, there[side]))
    between = children[other + 1 : own] if side == "before" else children[own + 1 : other]
    return tuple(between) if not any(site.inside(each) for each in between) else ()


def without(tree: Tree, doomed: Collection[int], kept: frozenset[int]) -> Tree:
    """Return the tree without some nodes; what is beside them takes their room.

    A composite that is left with one child becomes that child, and so does one that is left empty.

    Parameters
    ----------
    kept
        Nodes that stay what they are, even as an only child or with one: elements of grids.

    Raises
    ------
    Refused
        If nothing is left.
    """
    gone = set(doomed)
    for own in doomed:
        for above in tree.ancestors(own)[1:]:
            if not gone.issuperset(tree.nodes[above].children):
                break
            gone.add(above)
    if tree.root in gone:
        raise Refused("nothing of the facade would be left")
    nodes = dict(tree.nodes)
    parents = {tree.parents[own] for own in gone} - gone
    for above in parents:
        left = tuple(child for child in nodes[above].children if child not in gone)
        nodes[above] = nodes[above]._replace(children=left)
    for own in sorted(parents, key=lambda o: -len(tree.ancestors(o))):
        if len(nodes[own].children) == 1 and not kept.intersection((own, *nodes[own].children)):
            _give_way(nodes, tree, own)
    return Tree(nodes, tree.root).changed({})


def _give_way(nodes: dict[int, Node], tree: Tree, own: int) -> None:
    """Put a composite's only child in its place."""
    (only,) = nodes[own].children
    if own == tree.root:
        nodes[own] = nodes[only]._replace(source=nodes[own].source)
        return
    above = tree.parents[own]
    siblings = tuple(only if child == own else child for child in nodes[above].children)
    nodes[above] = nodes[above]._replace(children=siblings)
