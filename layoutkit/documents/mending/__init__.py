"""Documents mended where only one reading is possible, in their own bytes."""

from layoutkit.documents.mending.mend import MENDED, Mended, mended, proposals
from layoutkit.documents.mending.repair import Edit, Repair

__all__ = ["MENDED", "Edit", "Mended", "Repair", "mended", "proposals"]
