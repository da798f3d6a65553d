"""Placement: shapes put where examples would have them (Guerrero et al. 2015, sections 3 and 4)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.attributes import attribute
from layoutkit.diagnostics import Diagnostic, Faulty, Severity
from layoutkit.documents.grammar import AMOUNT, ANSWER, SIZE, WHOLE
from layoutkit.model import Placement, PlacementModel, Scene, Spacing
from layoutkit.model.outline import area, inside
from layoutkit.operations import Context, Element, Operation, Result, Site
from layoutkit.operations.attributes import held
from layoutkit.operations.context import named
from layoutkit.operations.operation import Scope
from layoutkit.scenes.spacing import check, fill
from layoutkit_operations.outlines import NEAR, Outlines, joined, lies_inside, outlines_of

if TYPE_CHECKING:
    from numpy.random import Generator


@dataclass(frozen=True, kw_only=True)
class Place(Operation):
    """Places shapes as was learned from examples, in elements and on the surfaces of solids."""

    kind: ClassVar[str] = "place"
    summary: ClassVar[str] = (
        "Places shapes as was learned from examples: in flat elements, or on the surfaces of solids, each a "
        "scene by itself with all that stands there."
    )

    limit: int | None = attribute(WHOLE, "How many are placed at most in each; left out: all.", None)
    threshold: float = attribute(AMOUNT, "The least score; an example has about 1.", 0.3)
    share: float = attribute(AMOUNT, "With what probability each is kept, the others are left out.", 1.0)
    inside: float = attribute(
        AMOUNT,
        "The least share of its area by which each has to lie inside what it is placed in: 1 for all of it.",
        0.0,
    )
    clear: bool = attribute(
        ANSWER, "Whether none may lie over what stands there already, or is placed there.", False
    )
    each_width: float | None = attribute(
        SIZE, "Fill placements along their width with shapes of this width.", None
    )
    each_height: float | None = attribute(
        SIZE, "Fill placements along their height with shapes of this height.", None
    )
    gap_across: float = attribute(AMOUNT, "The least gap between shapes that fill a width.", 0.0)
    gap_up: float = attribute(AMOUNT, "The least gap between shapes that fill a height.", 0.0)
    model: PlacementModel | None = held("placement-model", "What was learned, and of which label.")

    def faults(self) -> Iterator[Diagnostic]:
        """Yield what makes no sense."""
        if self.model is None:
            hint = "put the placement model in it that `layoutkit learn` writes"
            yield self._fault("there is no <placement-model>", hint)
        if self.limit == 0:
            yield self._fault("limit is 0", "let at least one be placed, or leave it away")
        if self.inside > 1:
            yield self._fault(f"inside is {self.inside:g}", "choose a share of at most 1")
        if not 0 < self.share <= 1:
            yield self._fault(f"share is {self.share:g}", "choose more than 0 and at most 1")
        try:
            check(self._spacing)
        except Faulty as faulty:
            yield from (self._fault(d.message, d.hint) for d in faulty.diagnostics)

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with what was placed, as flat elements, and these.

        Each scene is as it was before: what is placed in one does not stand in another's way.
        """
        from layoutkit_operations.standing import Standing

        made: list[Element] = []
        names: dict[str, Iterator[str]] = {}
        label = self._label
        seen = Standing(site).scenes if self._apart else Standing(site).surroundings
        scenes = {(name, own[0]): own[1] for name in scope for own in seen(name)}
        for (name, surface), scene in scenes.items():
            if name not in names:
                names[name] = site.free_names(name, label or "Placed")
            outlines = outlines_of(name, surface, site)
            taken = _standing(scene, name, outlines, site) if self.clear else ()
            placed = self._placed(scene, outlines, taken, name, context)
            for shape in self._kept(placed, context.random(named(f"{name} {surface}"))):
                labels = (label,) if label else ()
                own = Element(next(names[name]), labels, surface, shape.points, shape.angle, parent=name)
                made.append(own)
        return Result(site.with_elements(*made), tuple(element.name for element in made))

    @property
    def _label(self) -> str:
        return self.model.label if self.model is not None else ""

    @property
    def _apart(self) -> bool:
        """Whether what is placed in an element is related only to what is inside it."""
        return self.model is None or self.model.settings.hierarchy

    def _placed(
        self, scene: Scene, outlines: Outlines, taken: Outlines, name: str, context: Context
    ) -> tuple[Placement, ...]:
        """Return what is placed in a scene within outlines and beside what is taken, the best first."""
        apart = replace(context, told={})
        chosen = self.clear or self.inside > 0 or not self._apart
        outcome = apart.run(
            "place",
            scene,
            model=self._asked,
            limit=None if chosen else self.limit,
            threshold=self.threshold,
            spacing=None if chosen or self._spacing == Spacing() else self._spacing,
        )
        told = (replace(told, message=f"{name}: {told.message}", place=self.place) for told in apart.told)
        context.report(*told)
        if outcome is None or not isinstance(outcome.document, Scene):
            return ()
        if not chosen:
            return outcome.document.placements
        found = self._within(outcome.document.placements, outlines, taken)
        if outcome.document.placements and not found:
            what = "inside, and clear of others" if self.clear else "inside"
            message = f"{name}: none of {len(outcome.document.placements)} places for {self._label} is {what}"
            hint = "lower inside, or show smaller examples"
            context.report(Diagnostic("LK875", message, self.place, hint, Severity.WARNING, "operations"))
        try:
            return found if self._spacing == Spacing() else fill(found, self._spacing)
        except Faulty as faulty:
            told = (replace(d, message=f"{name}: {d.message}", place=self.place) for d in faulty.diagnostics)
            context.report(*(replace(d, severity=Severity.WARNING) for d in told))
            return ()

    @property
    def _asked(self) -> PlacementModel | None:
        """The model; where places are looked through afterwards, with all that overlap each other."""
        if self.model is None or not (self.inside or self.clear):
            return self.model
        return replace(self.model, settings=replace(self.model.settings, overlapping=True))

    def _within(
        self, placed: Sequence[Placement], outlines: Outlines, others: Outlines
    ) -> tuple[Placement, ...]:
        """Return the best placements far enough inside outlines, apart from others and from each other."""
        import shapely

        overlapping = not self.clear and self.model is not None and self.model.settings.overlapping
        own, taken = joined(outlines), joined(others)
        kept: list[Placement] = []
        for shape in placed:
            box = shapely.Polygon(shape.points)
            near = NEAR * box.area
            within = lies_inside(shape.points, own, self.inside)
            centred = any(inside((shape.x, shape.y), outline) for outline in outlines)
            if within and centred and shapely.intersection(taken, box).area <= near:
                kept.append(shape)
                taken = taken if overlapping else shapely.union(taken, box)
            if len(kept) == self.limit:
                break
        return tuple(kept)

    def _kept(self, placed: Sequence[Placement], chance: Generator) -> Iterator[Placement]:
        for shape in placed:
            if self.share >= 1 or float(chance.random()) < self.share:
                yield shape

    @property
    def _spacing(self) -> Spacing:
        return Spacing(self.each_width, self.each_height, self.gap_across, self.gap_up)

    def _fault(self, message: str, hint: str) -> Diagnostic:
        return Diagnostic("LK882", f"<place>: {message}", self.place, hint, Severity.ERROR, "operations")


def _standing(scene: Scene, name: str, outlines: Outlines, site: Site) -> Outlines:
    """Return the outlines of elements that stand in what is placed in, which are smaller than that is."""
    whole = sum(map(area, outlines))
    own = (p for p in scene.polygons if p.name != name and p.name in site.elements)
    return tuple(p.points for p in own if abs(area(p.points)) < whole)
