"""Facade and layout documents, read whole: the model, and what there is to say of it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath

from layoutkit.constraints import Constraint
from layoutkit.constraints.dressing import dressed, dressing_faults
from layoutkit.diagnostics import Diagnostic, Faulty, Severity, did_you_mean, worst
from layoutkit.documents.beside import DISK, Files
from layoutkit.documents.facade_regions import FacadeReader
from layoutkit.documents.grammar import FACADE, LAYOUT, LAYOUT_MASS, MASS, NAMESPACE, SESSION
from layoutkit.documents.grids import check_grids, read_grids
from layoutkit.documents.kinds import Kinds, check_constraints, read_constraints
from layoutkit.documents.makers import Maker, Numbers, Regions
from layoutkit.documents.masses import mass_of
from layoutkit.documents.operation_grammar import OPERATIONS
from layoutkit.documents.picture import picture_of
from layoutkit.documents.reading import Reading, in_order
from layoutkit.documents.roots import is_rooted
from layoutkit.documents.scene_grammar import PLACEMENT_MODEL, SCENE
from layoutkit.documents.source import Source
from layoutkit.documents.spelling import near_namespace
from layoutkit.documents.streaming import LAYOUT_PARTS, Making, Streamed, stream
from layoutkit.documents.tree import Element
from layoutkit.model import Facade, Layout, Mass, Region
from layoutkit.model.region import TILING_TOLERANCE

#: What may stand in a facade, in this order.
_FACADE_PARTS = ("picture", "region", "constraints", "grids")
#: Documents that name a facade, and which one is meant.
_INSTEAD = {
    LAYOUT.name: "name the facade that the layout was made from; where `vary` made it, that is facade.xml",
    SESSION.name: "name the facade that the edits begin with",
}
#: Documents that are no facade, and what to do with them.
_OTHERS = {
    MASS.name: "name a facade; the mass goes with it: --mass",
    SESSION.name: "name the facade that it edits, which its attribute facade says",
    SCENE.name: "name a facade or layout; `place` and `propagate` take scenes",
    PLACEMENT_MODEL.name: "name a facade or layout; `place` takes models of placements",
    OPERATIONS.name: "name a facade or layout; `replay` takes operations",
}
_NO_TREE = Region("", math.nan, math.nan)


@dataclass(frozen=True)
class Document:
    """A document that was read.

    Attributes
    ----------
    model
        What it describes.
    diagnostics
        Remarks on it, in document order; none is an error.
    source
        Its bytes.
    """

    model: Facade | Layout
    diagnostics: tuple[Diagnostic, ...]
    source: bytes


def is_facade(document: Path | str | Source) -> bool:
    """Tell whether a document's root element is a facade; of what is no XML it is none.

    Raises
    ------
    Faulty
        If the file cannot be read.
    """
    return is_rooted(document, FACADE)


@dataclass(frozen=True)
class Opened:
    """A document as far as it could be read, with every fault.

    Attributes
    ----------
    root
        Its elements, for the places of things; of the regions of a layout, the root alone.
    """

    model: Facade | Layout
    root: Element
    diagnostics: tuple[Diagnostic, ...]
    source: Source


def model_of(layout: Element, root: Element) -> Maker[Region]:
    """Make the model of a layout's regions."""
    return Regions()


def read(path: Path | str, kinds: Kinds) -> Document:
    """Read a facade, or a layout with its facade.

    Parameters
    ----------
    path
        The document. A layout's facade is looked for beside it; without it, ``Layout.facade`` is None, and
        a warning says so.
    kinds
        Constraint kinds by the name of their element.

    Raises
    ------
    Faulty
        If the document, or the facade that it names, has errors; all of them are in it.
    """
    source = Source.of(path)
    opened = open_document(replace(source, data=source.whole()), kinds)
    if worst(opened.diagnostics) is Severity.ERROR:
        raise Faulty(opened.diagnostics)
    return Document(opened.model, opened.diagnostics, opened.source.whole())


def open_document(document: Path | Source, kinds: Kinds, making: Making = model_of) -> Opened:
    """Read a document as far as it can be.

    Parameters
    ----------
    document
        A file, or the document's source.
    making
        What is to be made of a layout's regions; the layout has none if that is no region.

    Raises
    ------
    Faulty
        If it cannot be read at all: no file, no XML, neither a facade nor a layout.
    """
    source = document if isinstance(document, Source) else Source.of(document)
    streamed = stream(source, making)
    root, reading = streamed.root, streamed.reading
    _check_root(root, reading)
    if root.name == FACADE.name:
        return Opened(_facade(root, kinds, reading), root, reading.ordered(), source)
    layout = _layout(streamed)
    facade = _facade_of(layout, root, kinds, reading)
    return Opened(replace(layout, facade=facade), root, reading.ordered(), source)


def _check_root(root: Element, reading: Reading) -> None:
    names = (FACADE.name, LAYOUT.name)
    ours = root.namespace in ("", NAMESPACE)
    if not ours or root.name not in names:
        shown = f"of the namespace {root.namespace!r}" if not ours else "no document of ours"
        hint = namespace_hint(root) if not ours else did_you_mean(root.name, (*names, *_OTHERS))
        if ours and root.name in _OTHERS:
            shown, hint = "no facade", _OTHERS[root.name]
        reading.fault("LK101", f"<{root.name}> is {shown}", root, hint)
        raise Faulty(reading.ordered())
    if not root.namespace:
        hint = f'write <{root.name} xmlns="{NAMESPACE}" ...>'
        reading.fault("LK101", f"<{root.name}> is of no namespace", root, hint)


def namespace_hint(root: Element) -> str:
    """Say what to do about a root of another namespace."""
    if near_namespace(root.namespace):
        return f"did you mean {NAMESPACE!r}?"
    return "`layoutkit convert` reads other formats"


def _facade(root: Element, kinds: Kinds, reading: Reading) -> Facade:
    values = reading.values(root, FACADE)
    parts = _parts(root, _FACADE_PARTS, reading)
    regions = FacadeReader(reading, root.file)
    tree = _tree(parts, root, regions)
    if tree.split == "faces":
        hint = "a facade is one design: `layoutkit vary --mass` puts it on the faces of a mass"
        reading.fault("LK807", "a facade cannot be split into faces", parts["region"], hint)
        regions.names_known = False
    for element in regions.instances:
        symbol = element.attributes["symbol"]
        message = f"the symbol {symbol} is defined in two ways among its siblings"
        hint = f'write <again symbol="{symbol}"/> for a replica, or another symbol for another region'
        reading.fault("LK210", message, element, hint, topic="reference")
    found: tuple[tuple[Constraint, Element], ...] = ()
    if "constraints" in parts:
        found = read_constraints(parts["constraints"], kinds, reading)
    grids = read_grids(parts["grids"], reading) if "grids" in parts else ()
    facade = Facade(
        values.get("name") or "",
        values.get("units") or "m",
        tree,
        picture_of(parts["picture"], reading) if "picture" in parts else None,
        tuple(constraint for constraint, _ in found),
        grids=tuple(grid for grid, _ in grids),
    )
    if regions.names_known:
        check_constraints(facade, found, reading)
        check_grids(facade, grids, reading)
    return facade


def _layout(streamed: Streamed) -> Layout:
    root, reading = streamed.root, streamed.reading
    values = reading.values(root, LAYOUT)
    parts = _parts(root, LAYOUT_PARTS, reading)
    if "region" not in parts:
        _no_region(root, reading)
    tree = streamed.tree if isinstance(streamed.tree, Region) else _NO_TREE
    return Layout(
        values.get("name") or "",
        values.get("units") or "m",
        tree,
        facade_file=values.get("facade"),
        seed=values.get("seed"),
        index=values.get("index"),
        picture=picture_of(parts["picture"], reading) if "picture" in parts else None,
        mass=_mass(parts, tree, root, reading),
    )


def _mass(parts: dict[str, Element], tree: Region, root: Element, reading: Reading) -> Mass | None:
    """Return what a layout's faces stand on; they have to be those of the mass."""
    if "mass" not in parts:
        if tree.split == "faces":
            hint = "add the mass that the faces stand on, before the region"
            reading.fault("LK107", "<layout> has faces, and no <mass>", root, hint)
        return None
    before = len(reading.diagnostics)
    reading.values(parts["mass"], LAYOUT_MASS)
    mass = mass_of(parts["mass"], reading)
    sound = len(reading.diagnostics) == before
    if sound and (message := _misfit(tree, mass)):
        hint = "make the layout again from its facade and mass"
        reading.fault("LK806", message, parts.get("region", root), hint, topic="layout")
    return mass if sound else None


def _misfit(tree: Region, mass: Mass) -> str:
    """Say why the regions are not the faces of the mass; empty if they are."""
    if tree.split != "faces":
        return "the layout has a mass, but its root is not split into faces"
    named, wanted = [child.symbol for child in tree.children], [face.name for face in mass.faces]
    if named != wanted:
        return f"the faces are {' '.join(named)}, and those of the mass {' '.join(wanted)}"
    for child, box in zip(tree.children, mass.boxes, strict=True):
        pairs = ((child.width, box.width), (child.height, box.height), (child.base, box.y0))
        if max(abs(one - other) for one, other in pairs) > TILING_TOLERANCE * max(tree.width, tree.height):
            return f"the face {child.symbol} has another size or place than the mass gives it"
    return ""


def _facade_of(layout: Layout, root: Element, kinds: Kinds, reading: Reading) -> Facade | None:
    """Return the facade that a layout names, its faults recorded with those of the layout."""
    if layout.facade_file is None:
        return None
    facade = named_facade(layout.facade_file, root, kinds, reading, Severity.WARNING)
    if facade is None or layout.mass is None:
        return facade
    faults = [d for d in dressing_faults(facade, layout.mass) if d.severity is Severity.ERROR]
    reading.diagnostics += faults
    return None if faults else dressed(facade, layout.mass)


def named_facade(
    file: str,
    root: Element,
    kinds: Kinds,
    reading: Reading,
    missing: Severity,
    files: Files = DISK,
) -> Facade | None:
    """Return the facade that another document names; None if it is not there, or has errors.

    What is to be said of it is recorded with the reading of that document.

    Parameters
    ----------
    file
        Relative to the document.
    root
        That of the document.
    missing
        How grave it is that the file is not there.
    files
        Where it is looked for.
    """
    path, document = Path(root.file).parent / file, root.name
    try:
        source = files.source(path)
        if source is None:
            message = f"the {document}'s facade {file!r} is not there"
            hint = missing_hint(file, path, files, "the facade", "facade")
            reading.diagnostics.append(Diagnostic("LK504", message, root.place, hint, missing, document))
            return None
        facade_root = stream(source, lambda layout, root: Numbers()).root
        if facade_root.name in _INSTEAD:
            message = f"{file!r} is no facade, but a {facade_root.name}"
            reading.fault("LK505", message, root, _INSTEAD[document], document)
            return None
        facade_reading = Reading(facade_root.namespace)
        _check_root(facade_root, facade_reading)
        facade = _facade(facade_root, kinds, facade_reading)
    except (Faulty, OSError) as error:
        if isinstance(error, OSError):  # e.g. a name longer than any file's
            message, hint = f"the facade cannot be read: {error.strerror}", "correct the attribute facade"
            reading.fault("LK001", message, root, hint, document)
        else:
            reading.diagnostics += error.diagnostics
        return None
    reading.diagnostics += in_order(facade_reading.diagnostics)
    return None if facade_reading.diagnostics.erroneous else facade


def missing_hint(name: str, path: Path, files: Files, what: str, attribute: str) -> str:
    """Say what to do about a file that is not there: it may be misspelt.

    Parameters
    ----------
    name, path
        As the document names it, and where that is.
    what
        What it is.
    attribute
        What names it.
    """
    near = files.near(path)
    if near is None:
        return f"put {what} there, or correct the attribute {attribute}"
    return f"did you mean {PurePosixPath(name).with_name(near.name).as_posix()!r}?"


def _parts(root: Element, allowed: tuple[str, ...], reading: Reading) -> dict[str, Element]:
    """Return the children of the root by name."""
    found: dict[str, Element] = {}
    for child in root.children:
        name = reading.name_of(child, root, allowed)
        if name is None:
            continue
        order = f"the order is {', '.join(allowed)}, each at most once"
        if name in found:
            reading.fault("LK108", f"<{name}> stands a second time in <{root.name}>", child, order)
            continue
        if any(allowed.index(earlier) > allowed.index(name) for earlier in found):
            reading.fault("LK108", f"<{name}> stands too late in <{root.name}>", child, order)
        found[name] = child
    return found


def _tree(parts: dict[str, Element], root: Element, regions: FacadeReader) -> Region:
    if "region" in parts:
        return regions.root(parts["region"])
    _no_region(root, regions.reading)
    regions.names_known = False
    return _NO_TREE


def _no_region(root: Element, reading: Reading) -> None:
    hint = "the root region is the whole facade, with its width and height"
    reading.fault("LK107", f"<{root.name}> has no <region>", root, hint)
