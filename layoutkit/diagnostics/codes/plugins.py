"""Plugins (LK4)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK401",
        "plugin cannot be loaded",
        "Importing the plugin's module failed.",
        "A dependency of the plugin that is missing, or of another version.",
        "Install what the error names, or uninstall the plugin.",
        Severity.WARNING,
    ),
    Code(
        "LK402",
        "plugin does not fit the hooks",
        "The plugin implements no hook, or one that does not exist, or with other parameters.",
        "A plugin written for another version of layoutkit.",
        "Upgrade the plugin.",
        Severity.WARNING,
    ),
    Code(
        "LK403",
        "hook fails",
        "A plugin's hook raised an error; what it would have added is missing.",
        "A fault in the plugin.",
        "Report it to the plugin's author.",
        Severity.WARNING,
    ),
    Code(
        "LK404",
        "hook returns something unusable",
        "What a plugin's hook returned is not what the hook asks for, and was skipped.",
        "A class returned where an instance is asked for.",
        "Report it to the plugin's author.",
        Severity.WARNING,
    ),
    Code(
        "LK405",
        "names clash",
        "Two plugins, or two things that they add, go by the same name; the first is used.",
        "Two packages that solve the same problem.",
        "Disable one of them with LAYOUTKIT_DISABLE_PLUGINS.",
        Severity.WARNING,
    ),
    Code(
        "LK406",
        "no such stage, format, backend or constraint",
        "Nothing of that name is loaded.",
        "A misspelt name, or a plugin that is not installed.",
        "Correct the name; `layoutkit plugins` lists what is loaded.",
    ),
    Code(
        "LK407",
        "plugin failed",
        "A plugin raised an error while it was at work.",
        "A fault in the plugin.",
        "Report it to the plugin's author; LAYOUTKIT_DEBUG=1 shows the traceback.",
    ),
    Code(
        "LK408",
        "unknown plugin disabled",
        "LAYOUTKIT_DISABLE_PLUGINS, or the option --without, names a plugin that is not installed.",
        "A misspelt name.",
        "Correct it; `layoutkit plugins` lists the names.",
        Severity.WARNING,
    ),
    Code(
        "LK409",
        "plugin for another version of the interface",
        "The plugin states a version of the plugin interface other than this layoutkit's, and is skipped.",
        "layoutkit upgraded, and the plugin not; or the other way round.",
        "Upgrade the one that the hint names.",
        Severity.WARNING,
    ),
)
