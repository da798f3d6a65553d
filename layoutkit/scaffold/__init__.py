"""What ``layoutkit plugins new`` writes: the beginning of a plugin package that works as it stands."""

from layoutkit.scaffold.naming import Naming
from layoutkit.scaffold.package import constraint_package, write_package

__all__ = ["Naming", "constraint_package", "write_package"]
