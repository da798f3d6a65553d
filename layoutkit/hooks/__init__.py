"""Hook specifications, and the host that loads plugins.

Plugins import from here: `hookimpl`, and the classes that the hooks return instances of.
"""

from layoutkit.hooks.specs import Format, Hooks, Outcome, SceneFormat, Stage, Status, hookimpl

__all__ = ["Format", "Hooks", "Outcome", "SceneFormat", "Stage", "Status", "hookimpl"]
