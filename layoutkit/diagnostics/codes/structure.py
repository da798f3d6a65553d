"""The structure of documents: elements and attributes (LK1)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code

CODES = (
    Code(
        "LK101",
        "not a document of layoutkit",
        "The root element is none of facade, layout, mass, session, scene, placement-model and operations, "
        "is not the one that is wanted, or is not in the namespace urn:layoutkit:1.",
        "A document of another format, or a forgotten xmlns.",
        'Write xmlns="urn:layoutkit:1" on the root; `layoutkit convert` reads other formats.',
    ),
    Code(
        "LK102",
        "unknown element",
        "No element of that name may stand here.",
        "A misspelt name, or a constraint whose plugin is not installed.",
        "Correct the name; `layoutkit plugins` lists what is loaded.",
    ),
    Code(
        "LK103",
        "unknown attribute",
        "The element has no attribute of that name.",
        "A misspelt name.",
        "Correct it; the hint names the nearest.",
    ),
    Code(
        "LK104",
        "missing attribute",
        "The element lacks an attribute that it needs.",
        "A region without its size along the parent's split.",
        "Add it.",
    ),
    Code(
        "LK105",
        "bad attribute value",
        "The value is not of the attribute's form.",
        'split="column" for split="columns".',
        "Correct it; the hint says what is meant.",
    ),
    Code(
        "LK106",
        "bad size",
        "Sizes are finite numbers greater than 0.",
        "nan, inf, 0, a negative number, or a unit after the number.",
        "Write a plain number in the document's units.",
    ),
    Code(
        "LK107",
        "missing element",
        "The element lacks a child that it needs.",
        "A facade without its root region.",
        "Add it.",
    ),
    Code(
        "LK108",
        "element out of place",
        "The element is known, but not here, not in this order, or not twice.",
        "The picture written after the region.",
        "Move or delete it.",
    ),
    Code(
        "LK109",
        "text where none is allowed",
        "Between elements, only comments and white space may stand.",
        "A stray character beside a tag.",
        "Delete it, or make it a comment.",
    ),
    Code(
        "LK110",
        "children without a split",
        "A region with children must say how it is divided.",
        "A forgotten split attribute.",
        'Add split="columns" or split="rows".',
    ),
    Code(
        "LK111",
        "split without children",
        "A region with a split has no children to divide it into.",
        "Children deleted, and the attribute left.",
        "Delete the split, or add children.",
    ),
    Code(
        "LK112",
        "size that follows from the parent",
        "A child has only the size along its parent's split; across it, the parent's holds.",
        "A width given to the child of a rows region.",
        "Delete the attribute.",
    ),
    Code(
        "LK113",
        "constraint or operation of an unknown namespace",
        "No plugin that is loaded has constraints or operations of the element's namespace.",
        "A plugin that is not installed, is disabled, or could not be loaded; or a misspelt namespace.",
        "Install or enable the plugin, or correct the namespace; `layoutkit plugins` lists what is loaded.",
    ),
)
