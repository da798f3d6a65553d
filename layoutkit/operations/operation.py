"""What an operation is: the one interface that built-in kinds and plugins share.

A kind is a frozen dataclass. Its attributes are declared with `layoutkit.constraints.attributes.attribute`;
reading, writing, the schema and the reference follow from the declaration.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from layoutkit.constraints.attributes import Attribute, attributes_of
from layoutkit.constraints.namespace import CORE, Namespace
from layoutkit.diagnostics import Diagnostic, Place

if TYPE_CHECKING:
    from layoutkit.operations.context import Context
    from layoutkit.operations.site import Site

#: Names of elements and surfaces that an operation works on, or has made.
Scope = tuple[str, ...]


class Result(NamedTuple):
    """What an operation comes to: the site as it is afterwards, and the output, the scope of what follows."""

    site: Site
    output: Scope


@dataclass(frozen=True, kw_only=True)
class Operation(ABC):
    """A step of modelling that can be made again elsewhere (Guerrero et al. 2015, section 4.1).

    Attributes
    ----------
    kind
        The name of its element in documents.
    namespace
        Whose element it is: one of the package's own, except for what comes with layoutkit.
    summary
        What it does, in one sentence, for the reference and the schema.
    place
        Where in its document it stands.
    """

    kind: ClassVar[str]
    namespace: ClassVar[Namespace] = CORE
    summary: ClassVar[str]

    place: Place | None = field(default=None, compare=False, repr=False)

    @classmethod
    def qualified_name(cls) -> str:
        """Return what users call the kind: the name of its element, with the prefix of its namespace."""
        return cls.namespace.named(cls.kind)

    @classmethod
    def attributes(cls) -> tuple[Attribute, ...]:
        """Return the declared attributes, in order."""
        return attributes_of(cls)

    def faults(self) -> Iterator[Diagnostic]:
        """Yield what is wrong with the operation itself, before anything is done."""
        return iter(())

    @abstractmethod
    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site as it is afterwards, and what was made or chosen.

        It may change what is in its scope, or stands on that, and nothing else. What cannot be done to one
        element is reported to the context, and the others go on.

        Parameters
        ----------
        scope
            The output of the parent operation; of a root, all elements of the site.
        site
            What there is.
        context
            Chance, stages, and where to report.
        """
