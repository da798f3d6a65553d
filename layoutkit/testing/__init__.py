"""What the tests of a constraint plugin need: a conformance suite that finds where promises are not kept.

With pytest, a class is enough (`ConstraintSuite`); `conforms` gives the findings as a list.
"""

from layoutkit.testing.conformance import PROMISES, Conformance, conforms
from layoutkit.testing.finding import Finding
from layoutkit.testing.houses import HOUSES
from layoutkit.testing.subjects import facade_with
from layoutkit.testing.suite import ConstraintSuite

__all__ = ["HOUSES", "PROMISES", "Conformance", "ConstraintSuite", "Finding", "conforms", "facade_with"]
