"""Names mended: elements, attributes, and the namespace of the whole document."""

from __future__ import annotations

from collections.abc import Iterator

from layoutkit.documents.grammar import NAMESPACE
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.mending.expected import ROOTS, element_type, possible
from layoutkit.documents.mending.manuscript import Manuscript, Written
from layoutkit.documents.mending.repair import Repair
from layoutkit.documents.spelling import meant, misspelt_namespace


def root(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK101: a root of no namespace gets ours, and so does one that misspells it; a misspelt one its name."""
    if misspelt_namespace(element.namespace) and meant(element.name, ROOTS):
        name = f"xmlns:{element.prefix}" if element.prefix else "xmlns"
        given = manuscript.attributes(element)[name]
        edit = manuscript.edit(element, given.value, given.value + len(given.raw), NAMESPACE)
        yield Repair("LK101", f'{name}="{given.raw}"', f'{name}="{NAMESPACE}"', (edit,))
    elif element.name not in ROOTS:
        yield from misspelt_element(element, manuscript, kinds)
    elif not element.namespace:
        added = f'xmlns="{NAMESPACE}"'
        written = manuscript.attributes(element).get("xmlns")
        if written is not None:  # an empty one
            edit = manuscript.edit(element, written.name, written.end, added)
        else:
            behind = 1 + len(element.name)
            edit = manuscript.edit(element, behind, behind, f" {added}")
        yield Repair("LK101", "" if written is None else 'xmlns=""', added, (edit,))


def misspelt_element(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK101, LK102: an element whose name is nearly that of one that has its attributes."""
    known = possible(element, kinds)
    name = meant(element.name, known) if element.name not in known else None
    if name is None:
        return
    declared = known[name]
    given = {
        one if one in declared.attributes else meant(one, declared.attributes) for one in element.attributes
    }
    if None not in given and given >= set(declared.required):
        prefix = f"{element.prefix}:" if element.prefix else ""
        code = "LK101" if element.parent is None else "LK102"
        was, becomes = f"<{prefix}{element.name}>", f"<{prefix}{name}>"
        yield Repair(code, was, becomes, manuscript.renamed(element, name))


def misspelt_attributes(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK103: attributes whose names are nearly those of others, which are not there."""
    declared = element_type(element, kinds)
    if declared is None:
        return
    unknown = [name for name in element.attributes if name not in declared.attributes]
    names = {name: meant(name, declared.attributes) for name in unknown}
    written = manuscript.attributes(element)
    for name, becomes in names.items():
        twice = list(names.values()).count(becomes) > 1
        if becomes is None or becomes in element.attributes or twice:
            continue
        start = written[name].name
        edit = manuscript.edit(element, start, start + len(name), becomes)
        yield Repair("LK103", name, becomes, (edit,))
