"""Documents: XML to model and back, the schema, cross-references, faults with their place."""

from layoutkit.documents.document import Document, is_facade, read
from layoutkit.documents.files import load, save
from layoutkit.documents.grammar import NAMESPACE
from layoutkit.documents.insertion import with_constraints, with_grids
from layoutkit.documents.masses import MassDocument, is_mass, read_mass
from layoutkit.documents.schema import schema, schemas
from layoutkit.documents.sessions import SessionDocument, is_session, read_session
from layoutkit.documents.source import Source
from layoutkit.documents.validation import check
from layoutkit.documents.writing import facade_bytes, layout_bytes, mass_bytes, session_bytes

__all__ = [
    "NAMESPACE",
    "Document",
    "MassDocument",
    "SessionDocument",
    "Source",
    "check",
    "facade_bytes",
    "is_facade",
    "is_mass",
    "is_session",
    "layout_bytes",
    "load",
    "mass_bytes",
    "read",
    "read_mass",
    "read_session",
    "save",
    "schema",
    "schemas",
    "session_bytes",
    "with_constraints",
    "with_grids",
]
