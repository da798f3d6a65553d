"""What this package adds to layoutkit: the stages `infer`, `relayout`, `count`, `explain` and `audit`."""

from __future__ import annotations

from collections.abc import Iterable

from layoutkit.hooks.specs import Stage, hookimpl


@hookimpl
def layoutkit_stages() -> Iterable[Stage]:
    """Return the stages."""
    from layoutkit_relayout.auditing.stage import Audit
    from layoutkit_relayout.counting.stage import CountArrangements
    from layoutkit_relayout.explanation.stage import Explain
    from layoutkit_relayout.inference.stage import Infer
    from layoutkit_relayout.stage import Relayout

    return (Infer(), Relayout(), CountArrangements(), Explain(), Audit())
