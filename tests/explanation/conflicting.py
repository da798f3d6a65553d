"""Facades that cannot be, small enough to see why; and what explaining them takes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from layoutkit.constraints import Constraint, Instances, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.defaults import InputWord
from layoutkit.constraints.expansion import sequences_of
from layoutkit.constraints.generator import Generator
from layoutkit.constraints.generators import framed
from layoutkit.constraints.size import input_size
from layoutkit.constraints.view import LayoutView
from layoutkit.model import Facade, Layout, Measure, Region, RegionSet, Word
from layoutkit.model.conflict import Conflict, Member, Remedy
from layoutkit_relayout.explanation.units import FLOOR
from layoutkit_relayout.stage import Relayout, RelayoutOptions

#: A shop front whose lease ends at 3 m, and whose windows are made in 1.2 m at least.
RIVOLI = """<?xml version="1.0" encoding="UTF-8"?>
<facade xmlns="urn:layoutkit:1" name="rivoli" units="m">
  <region symbol="Facade" width="6" height="4" split="columns">
    <region symbol="A" width="1.5" labels="Wall"/>
    <region symbol="B" width="3" split="columns">
      <region symbol="C" width="1" labels="Window"/>
      <again symbol="C"/>
      <again symbol="C"/>
    </region>
    <again symbol="A"/>
  </region>
  <constraints>
    <size of="Facade/A" min="0.5" max="4"/>
    <!-- the lease ends here -->
    <size of="Facade/B" max="3"/>
    <size of="Facade/B/C" min="1.2"/>
  </constraints>
</facade>
"""

#: Two conflicts that have nothing to do with each other: one across, one down.
TWICE = """<?xml version="1.0" encoding="UTF-8"?>
<facade xmlns="urn:layoutkit:1" name="twice" units="m">
  <region symbol="Facade" width="4" height="4" split="rows">
    <region symbol="Top" height="2" split="columns">
      <region symbol="L" width="2"/>
      <region symbol="R" width="2"/>
    </region>
    <region symbol="Base" height="2"/>
  </region>
  <constraints>
    <size of="Facade/Top/L" min="2.5" max="3"/>
    <size of="Facade/Top/R" min="2" max="3"/>
    <size of="Facade/Top" max="1"/>
    <size of="Facade/Base" max="2.5"/>
  </constraints>
</facade>
"""


def row(
    word: str, sizes: dict[str, float], constraints: Iterable[Constraint] = (), height: float = 3.0
) -> Facade:
    """Return a facade of terminals side by side, with constraints."""
    children = tuple(Region(s, sizes[s], height) for s in word)
    root = Region("R", sum(c.width for c in children), height, "columns", children)
    return Facade("row", "m", root, constraints=tuple(constraints))


def any_word(path: str, letters: Sequence[str]) -> list[Constraint]:
    """Return sequences that admit every word of some letters."""
    words = framed(letters, {letter: list(letters) for letter in letters}, letters)
    return [SequenceConstraint(within=(path,), word=word) for word in words]


def alone(facade: Facade, members: Iterable[Member], least: float = FLOOR) -> Facade:
    """Return a facade in which members of a conflict hold, and nothing else: no default adds to them.

    Parameters
    ----------
    least
        Share of its input size that each region keeps if no constraint states a smaller minimum. Regions
        whose arrangements no member decides may have any.
    """
    held: list[Constraint] = []
    for member in members:
        kinds = {type(constraint) for constraint in member.constraints}
        if any(issubclass(kind, SequenceConstraint | Generator) for kind in kinds):
            (region,) = member.regions
            held += [replace(sequence, within=(region,)) for sequence in sequences_of(facade)[region]]
        elif kinds == {InputWord}:
            (region,) = member.regions
            word = Word.parse(" ".join(["⊢", *facade.regions[region].word, "⊣"]))
            held.append(SequenceConstraint(within=(region,), word=word))
        else:
            held += member.constraints
    # What may differ from place to place still may.
    varied = (c for c in facade.constraints if isinstance(c, Instances))
    held += [replace(c, min=None, max=None, weight=None) for c in varied]
    decided = {path for c in held if isinstance(c, SequenceConstraint) for path in c.within}
    for path, region in facade.regions.items():
        if region.split and path not in decided:
            held += any_word(path, list(dict.fromkeys(region.word)))
    return replace(facade, constraints=(*held, *floors(facade, least)))


def floors(facade: Facade, least: float) -> Iterable[Constraint]:
    """Yield the least sizes that hold whichever constraints are left out."""
    for path in facade.regions:
        if "/" in path:
            yield Size(of=RegionSet(path), min=Measure(floor(facade, path, least), True))


def floor(facade: Facade, path: str, least: float) -> float:
    own = [c for c in facade.constraints if isinstance(c, Size) and path in facade.select(c.of)]
    stated = [c.min.of(input_size(facade, path)) / input_size(facade, path) for c in own if c.min is not None]
    return min([least, *stated])


def keeps(root: Region, facade: Facade) -> bool:
    """Tell whether a layout keeps what a facade's own constraints ask."""
    view = LayoutView(Layout("tried", facade.units, root, facade), facade)
    return not any(any(constraint.violations(view)) for constraint in facade.constraints)


def changed(facade: Facade, remedy: Remedy) -> Facade:
    """Return the facade as a remedy changes its document."""
    kept = [c for c in facade.constraints if not any(c is other for other in remedy.removed)]
    assert len(kept) + len(remedy.removed) == len(facade.constraints), "what is removed is in the document"
    return replace(facade, constraints=(*kept, *remedy.added))


def helps(facade: Facade, size: tuple[float, float], remedy: Remedy) -> bool:
    """Tell whether there is a layout, checked, after a change of the document or of the size."""
    width, height = remedy.size or size
    options = RelayoutOptions(count=1, width=Measure(width), height=Measure(height))
    (outcome,) = Relayout().run(changed(facade, remedy), options)
    return isinstance(outcome.document, Layout) and not outcome.document.violations()


def only(conflicts: tuple[Conflict, ...]) -> Conflict:
    """Return the one conflict."""
    (conflict,) = conflicts
    return conflict
