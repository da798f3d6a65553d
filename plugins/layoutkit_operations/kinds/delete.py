"""Deletion (Guerrero et al. 2015, section 4.1)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from layoutkit.operations import Context, Operation, Result, Site
from layoutkit.operations.operation import Scope


@dataclass(frozen=True, kw_only=True)
class Delete(Operation):
    """Takes elements away, and what stands on them."""

    kind: ClassVar[str] = "delete"
    summary: ClassVar[str] = (
        "Takes away what is in the scope, and all that was made on it. Its output is empty."
    )

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site without what is in the scope."""
        return Result(site.without(scope), ())
