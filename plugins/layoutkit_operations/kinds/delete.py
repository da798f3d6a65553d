"""Deletion (Guerrero et al. 2015, section 4.1)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.operations import Context, Operation, Result, Site
from layoutkit.operations.operation import Scope


@dataclass(frozen=True, kw_only=True)
class Delete(Operation):
    """Takes elements away, and what stands on them."""

    kind: ClassVar[str] = "delete"
    summary: ClassVar[str] = (
        "Takes away the elements in the scope, and all that was made on them; nothing is left. Surfaces go "
        "with their solids, and what was merged stays a part of those."
    )

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site without the elements in the scope."""
        gone = []
        for name in scope:
            element = site.elements.get(name)
            if element is None:
                self._remark(context, f"{name} is a surface", "delete the element that it is of")
            elif element.solid not in ("", name):
                self._remark(context, f"{name} is a part of {element.solid}", "delete it before it is merged")
            else:
                gone.append(name)
        return Result(site.without(gone), ())

    def _remark(self, context: Context, why: str, hint: str) -> None:
        message = f"{why}, and is not deleted"
        context.report(Diagnostic("LK883", message, self.place, hint, Severity.WARNING, "operations"))
