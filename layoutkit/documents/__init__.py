"""Documents: XML to model and back, the schema, cross-references, faults with their place."""

from layoutkit.documents.document import Document, is_facade, read
from layoutkit.documents.files import load, save
from layoutkit.documents.grammar import NAMESPACE
from layoutkit.documents.insertion import with_constraints, with_grids
from layoutkit.documents.masses import MassDocument, is_mass, read_mass
from layoutkit.documents.operations import (
    OperationsDocument,
    is_operations,
    read_operations,
    read_operations_files,
)
from layoutkit.documents.placement_models import (
    PlacementModelDocument,
    is_placement_model,
    read_placement_model,
)
from layoutkit.documents.scenes import SceneDocument, is_scene, read_scene
from layoutkit.documents.schema import schema, schemas
from layoutkit.documents.sessions import SessionDocument, is_session, read_session
from layoutkit.documents.source import Source
from layoutkit.documents.validation import check
from layoutkit.documents.writing import (
    facade_bytes,
    layout_bytes,
    mass_bytes,
    operations_bytes,
    placement_model_bytes,
    scene_bytes,
    session_bytes,
)

__all__ = [
    "NAMESPACE",
    "Document",
    "MassDocument",
    "OperationsDocument",
    "PlacementModelDocument",
    "SceneDocument",
    "SessionDocument",
    "Source",
    "check",
    "facade_bytes",
    "is_facade",
    "is_mass",
    "is_operations",
    "is_placement_model",
    "is_scene",
    "is_session",
    "layout_bytes",
    "load",
    "mass_bytes",
    "operations_bytes",
    "placement_model_bytes",
    "read",
    "read_mass",
    "read_operations",
    "read_operations_files",
    "read_placement_model",
    "read_scene",
    "read_session",
    "save",
    "scene_bytes",
    "schema",
    "schemas",
    "session_bytes",
    "with_constraints",
    "with_grids",
]
