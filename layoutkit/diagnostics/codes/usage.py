"""Usage: the command line, and which files it names (LK7)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK701",
        "fault in the command line",
        "A command, option or argument is unknown, missing, or not of its form.",
        "A misspelt option.",
        "Follow the hint; `layoutkit COMMAND --help` tells how the command is used.",
    ),
    Code(
        "LK702",
        "wrong kind of document",
        "The command takes a facade, and was given a layout.",
        "A variation named where its facade was meant.",
        "Name the facade's document; beside a layout that vary made it is facade.xml.",
    ),
    Code(
        "LK703",
        "kind of file not known",
        "No format recognises the annotation, several do, or no picture can be written with that suffix.",
        "A file of another program.",
        "Name the format with --format, or give the output another suffix.",
    ),
    Code(
        "LK704",
        "file would be overwritten",
        "The command would write over its own input, or over a file that was edited.",
        "The input's own folder named for the results.",
        "Name another folder with -o.",
    ),
    Code(
        "LK705",
        "files of an earlier run",
        "The folder holds variations that this run did not make.",
        "A second run into the same folder, with fewer variations.",
        "Delete them, or name a new folder with -o.",
        Severity.WARNING,
    ),
    Code(
        "LK706",
        "size asked of a building",
        "Its faces have the sizes that the mass gives them, and no others.",
        "--width or --height together with --mass.",
        "Leave the size away, or change the mass.",
    ),
    Code(
        "LK707",
        "setting that cannot be read",
        "An environment variable holds what its setting cannot be.",
        "A unit behind a number.",
        "Delete the variable, or write what the message asks for.",
        Severity.WARNING,
    ),
    Code(
        "LK710",
        "no such sample",
        "No shipped facade has that name.",
        "A misspelt name.",
        "Correct it; `layoutkit samples` lists them.",
    ),
    Code(
        "LK711",
        "nothing to check",
        "A folder holds no document, or no document is of a pattern.",
        "A folder of other files, or a pattern that starts from another folder.",
        "Name the folder that holds the documents.",
    ),
    Code(
        "LK712",
        "files of other kinds left out",
        "Folders and patterns hold XML files of other kinds, or texts without documents: none is checked.",
        "Annotations, or the settings of other programs, beside documents.",
        "Nothing is needed; a file that is named by itself is checked all the same.",
        Severity.NOTE,
    ),
)
