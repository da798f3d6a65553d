"""A house of two floors, whose constraints are audited."""

from __future__ import annotations

from pathlib import Path

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.diagnostics import Diagnostic
from layoutkit.documents import read
from layoutkit.model import Facade
from layoutkit_relayout.auditing.stage import Audit, AuditOptions

#: In front of the first constraint.
HEAD = """\
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <region symbol="House" width="7" height="6" split="rows">
    <region symbol="Floor" height="3" split="columns">
      <region symbol="Pier" width="1" labels="Wall"/>
      <region symbol="Bay" width="2" labels="Window"/>
      <again symbol="Pier"/>
      <again symbol="Bay"/>
      <again symbol="Pier"/>
    </region>
    <region symbol="Ground" height="3" split="columns">
      <region symbol="Pier" width="1.5" labels="Wall"/>
      <region symbol="Door" width="4" labels="Door" split="rows">
        <region symbol="Over" height="1"/>
        <region symbol="Leaf" height="2"/>
      </region>
      <again symbol="Pier"/>
    </region>
  </region>
  <constraints>
"""
#: The line of the first constraint.
FIRST = HEAD.count("\n") + 1
#: Piers, and bays between them, as many as fit.
FREE = (
    '<sequence within="House/Floor" word="|- Pier Bay"/>',
    '<sequence within="House/Floor" word="Bay Pier Bay"/>',
    '<sequence within="House/Floor" word="Bay Pier -|"/>',
)

KINDS: dict[str, type[Constraint]] = {kind.kind: kind for kind in BUILT_IN}


def house(folder: Path, *constraints: str) -> Facade:
    """Return the house with constraints, each in a line of its own."""
    file = folder / "house.xml"
    text = "".join(f"    {constraint}\n" for constraint in constraints)
    file.write_text(f"{HEAD}{text}  </constraints>\n</facade>\n", encoding="utf-8")
    facade = read(file, KINDS).model
    assert isinstance(facade, Facade)
    return facade


def audited(facade: Facade, options: AuditOptions | None = None) -> tuple[Diagnostic, ...]:
    """Return what the audit says of a facade."""
    (outcome,) = Audit().run(facade, options or AuditOptions())
    assert (outcome.status, outcome.document) == ("found", None)
    return outcome.diagnostics
