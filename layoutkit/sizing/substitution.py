"""Equalities between variables, each solved for one of them."""

from __future__ import annotations

from collections.abc import Iterable

from layoutkit.sizing.arrangement import add
from layoutkit.sizing.rules import SIZE, UNIT, Form

_GIVEN = frozenset((SIZE, UNIT))
#: Factors smaller than this, of forms whose factors are about 1, are rounding.
_NOTHING = 1e-11


class Substitution:
    """What the equalities so far say: some variables as forms over the others.

    Each remembers why: a set of equalities, as the bits of a number.
    """

    def __init__(self) -> None:
        self._known: dict[int, tuple[dict[int, float], int]] = {}

    def reduce(self, form: Form) -> tuple[dict[int, float], int]:
        """Return a form over free variables, and which equalities made it so."""
        if self._known.keys().isdisjoint(form):
            return dict(form), 0
        total: dict[int, float] = {}
        why = 0
        for variable, factor in form.items():
            if variable in self._known:
                own, reason = self._resolved(variable)
                why |= reason
                for inner, value in own.items():
                    total[inner] = total.get(inner, 0.0) + factor * value
            else:
                total[variable] = total.get(variable, 0.0) + factor
        return {v: f for v, f in total.items() if abs(f) > _NOTHING}, why

    def _resolved(self, variable: int) -> tuple[dict[int, float], int]:
        """Return what is known of a variable, over free ones: deep chains without recursion."""
        pending = [variable]
        while pending:
            form, why = self._known[pending[-1]]
            unsettled = [
                v for v in form if v in self._known and not self._known.keys().isdisjoint(self._known[v][0])
            ]
            if unsettled:
                pending += unsettled
                continue
            for inner in [v for v in form if v in self._known]:
                factor = form[inner]
                own, reason = self._known[inner]
                form = add({v: f for v, f in form.items() if v != inner}, own, factor)
                why |= reason
            self._known[pending.pop()] = form, why
        return self._known[variable]

    def equate(self, form: Form, why: int) -> None:
        """Take in that a reduced form is 0, by its largest factor; the newest variable where several are."""
        pivot = max((v for v in form if v not in _GIVEN), key=lambda v: (round(abs(form[v]), 9), v))
        factor = form[pivot]
        self._known[pivot] = {v: -f / factor for v, f in form.items() if v != pivot}, why

    def take(
        self, equalities: Iterable[tuple[dict[int, float], int]], most_terms: int
    ) -> list[tuple[dict[int, float], int]]:
        """Solve equalities of few variables; return the others, and those that are left with none.

        Parameters
        ----------
        equalities
            Forms that are 0, each with the bit that it goes by.
        most_terms
            Forms of more variables are left, unless others make them shorter.
        """
        constant: list[tuple[dict[int, float], int]] = []
        pending = list(equalities)
        while True:
            left = []
            for original, bit in pending:
                form, why = self.reduce(original)
                free = len(form.keys() - _GIVEN)
                if free == 0:
                    if form:
                        constant.append((form, why | bit))
                elif free <= most_terms:
                    self.equate(form, why | bit)
                else:
                    left.append((original, bit))
            if len(left) == len(pending):
                return [*left, *constant]
            pending = left

    def free(self, count: int) -> list[int]:
        """Return the variables, of `count`, that are free."""
        return [v for v in range(SIZE + 1, count) if v not in self._known]
