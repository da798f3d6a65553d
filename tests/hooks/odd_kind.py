"""A small facade that names a plugin's constraint, and that plugin, for tests of such as fail or hang."""

from __future__ import annotations

FACADE = """<facade xmlns="urn:layoutkit:1" xmlns:odd="urn:odd:1" name="row" units="m">
  <region symbol="R" width="6" height="2" split="columns">
    <region symbol="A" width="1"/>
    <region symbol="B" width="4"/>
    <again symbol="A"/>
  </region>
  <constraints>
    <repetition within="R" pattern="(A|B)+"/>
    <odd:rule/>
  </constraints>
</facade>
"""
KIND = """
from dataclasses import dataclass
from math import inf, nan
import numpy as np
from layoutkit.constraints import Constraint
from layoutkit.constraints.claims import EquallyLarge, InLine, Relates, Sized
from layoutkit.constraints.namespace import Namespace
from layoutkit.constraints.word_rules import Admits, Bound, Counts
from layoutkit.diagnostics import Diagnostic
from layoutkit.hooks import hookimpl
from layoutkit.model import Violation
from layoutkit.sizing.rules import Convex, Quantity, Range, Rows, Target

class Automaton:
    def start(self): return 0
    def step(self, state, symbol): return 0
    def accepts(self, state): return True

@dataclass(frozen=True, kw_only=True)
class Rule(Constraint):
    kind = "rule"
    namespace = Namespace("odd", "urn:odd:1")
    summary = "Fails in one way or another."
    def violations(self, view):
        return iter(())
{method}

@hookimpl
def layoutkit_constraints():
    return [Rule]
"""
