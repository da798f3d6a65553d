"""Documents: XML to model and back, the schema, cross-references, faults with their place."""

from layoutkit.documents.document import Document, read
from layoutkit.documents.files import load, save
from layoutkit.documents.grammar import NAMESPACE
from layoutkit.documents.insertion import with_constraints
from layoutkit.documents.schema import schema
from layoutkit.documents.validation import check
from layoutkit.documents.writing import facade_bytes, layout_bytes

__all__ = [
    "NAMESPACE",
    "Document",
    "check",
    "facade_bytes",
    "layout_bytes",
    "load",
    "read",
    "save",
    "schema",
    "with_constraints",
]
