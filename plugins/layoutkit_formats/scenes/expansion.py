"""How large an SVG drawing becomes once every `use` is written out: some are made to grow without end."""

from __future__ import annotations

from xml.etree.ElementTree import Element

_LINKS = ("href", "{http://www.w3.org/1999/xlink}href")


def expanded(root: Element) -> float:
    """Return how many elements a drawing has with those that `use` repeats; infinite if one uses itself."""
    known = {name: element for element in root.iter() if (name := element.get("id"))}
    sizes: dict[Element, float] = {}
    # What it holds and uses comes before an element; one that is met again on the way down uses itself.
    pending = [(root, False)]
    open_: set[Element] = set()
    while pending:
        element, ready = pending.pop()
        if ready:
            open_.discard(element)
            sizes[element] = 1 + sum(sizes[inner] for inner in _inside(element, known))
        elif element in open_:
            return float("inf")
        elif element not in sizes:
            open_.add(element)
            pending.append((element, True))
            pending += ((inner, False) for inner in _inside(element, known) if inner not in sizes)
    return sizes[root]


def _inside(element: Element, known: dict[str, Element]) -> list[Element]:
    if not element.tag.endswith("use"):
        return list(element)
    link = next((element.get(name) for name in _LINKS if element.get(name)), None) or ""
    used = known.get(link.removeprefix("#"))
    return [*element, used] if used is not None else list(element)
