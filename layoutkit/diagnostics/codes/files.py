"""Files: reading and writing them, and what keeps the program safe (LK0)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code

CODES = (
    Code(
        "LK001",
        "file cannot be read",
        "The file is missing, is a folder, or may not be opened.",
        "A misspelt name.",
        "Correct the path; the hint names the nearest file beside it.",
    ),
    Code(
        "LK002",
        "not well-formed XML",
        "The XML parser cannot go on; what follows the place is not read.",
        "A tag that is not closed, or a bare & or <.",
        "Correct the text at the place; write &amp; for & and &lt; for <.",
    ),
    Code(
        "LK003",
        "encoding not known or not kept",
        "The bytes are not of the encoding that the XML declaration names, or no such encoding is known.",
        "A file saved in another encoding than it declares.",
        "Save it as UTF-8.",
    ),
    Code(
        "LK004",
        "document type declaration",
        "Documents have no DTD: entities can make a small file grow without end, or draw in other files.",
        "A <!DOCTYPE ...> line.",
        "Delete it; the schema takes its place.",
    ),
    Code(
        "LK005",
        "nested too deeply",
        "Elements stand inside one another beyond the greatest depth.",
        "A generated document that wraps each region in another.",
        "Flatten the hierarchy.",
    ),
    Code(
        "LK006",
        "too many elements",
        "The document holds, or through `again` stands for, more elements than the program takes.",
        "Replicas of replicas, level upon level.",
        "Split the document.",
    ),
    Code(
        "LK007",
        "file too large",
        "The file is larger than the program reads.",
        "Another file than was meant.",
        "Name a facade or layout document.",
    ),
    Code(
        "LK008",
        "file cannot be written",
        "The file was not written; what stood there before is untouched.",
        "A folder that is missing or write-protected.",
        "Make the folder, or name another.",
    ),
    Code(
        "LK009",
        "character that XML cannot hold",
        "A name or comment contains a control character or half a surrogate pair.",
        "A file name of broken encoding.",
        "Rename what the message quotes.",
    ),
    Code(
        "LK010",
        "picture cannot be used",
        "The facade's picture is missing, cannot be decoded, or does not cover what the document says.",
        "A document moved without its picture.",
        "Put the picture where the document names it, or correct its file attribute.",
    ),
)
