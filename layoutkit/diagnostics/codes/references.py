"""References and constraints: names, ranges, sums, what a constraint needs and what it means (LK2)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK201",
        "unknown name",
        "A constraint names a region or label that the facade lacks.",
        "A misspelt path, or a region that was renamed.",
        "Correct the name; the hint names the nearest.",
    ),
    Code(
        "LK202",
        "empty range",
        "The least value is above the greatest.",
        "min and max exchanged.",
        "Exchange them, or widen one.",
    ),
    Code(
        "LK203",
        "constraints cannot hold together",
        "No layout of the size asked for keeps all constraints.",
        "Ranges too narrow for the facade's size.",
        "Loosen one of those that the message lists.",
    ),
    Code(
        "LK205",
        "arrangement of a terminal",
        "A constraint speaks of the arrangement of a region that is not divided.",
        "The path of a leaf where that of its parent was meant.",
        "Name a region that has a split.",
    ),
    Code(
        "LK206",
        "lines of two axes",
        "Upright and level lines stand in one alignment.",
        'lines="left top".',
        "Write one alignment for each axis.",
    ),
    Code(
        "LK207",
        "run across the dimension",
        "A run of subregions has a size of its own only along its region's split.",
        "The width of a run in a region of rows.",
        "Exchange width and height, or name a region instead of a run.",
    ),
    Code(
        "LK208",
        "different symbols",
        "Regions of the same arrangement must have the same symbols.",
        "Bays that stand in line under different names.",
        "Give subregions that correspond the same symbol.",
    ),
    Code(
        "LK210",
        "symbol defined in two ways",
        "Siblings of the same symbol are identical regions, yet two differ.",
        "A copied region, edited in one place only.",
        "Write <again symbol=.../> for a replica, or give the other one its own symbol.",
    ),
    Code(
        "LK211",
        "again of an unknown symbol",
        "`again` repeats an earlier sibling, and none has that symbol.",
        "A misspelt symbol, or the replica before its original.",
        "Correct the symbol, or write the region in full here.",
    ),
    Code(
        "LK212",
        "children do not add up",
        "The sizes of the children along the split must add up to the parent's.",
        "One child resized, and no other.",
        "Change a child, or the parent, by the difference that the hint names.",
    ),
    Code(
        "LK213",
        "empty picture box",
        "The part of the picture that the document covers has no area.",
        "right and left, or bottom and top, exchanged: pixels count downwards.",
        "Exchange them.",
    ),
    Code(
        "LK214",
        "initial sizes not determined",
        "Uniform and triangular distributions run from min to max, and a bias moves a centre towards one of "
        "them: what they need must be there.",
        "A bias towards the greatest size, and no max.",
        "Add what the message names, or delete the attribute.",
    ),
    Code(
        "LK215",
        "context without meaning",
        "What stands before a region can end with no ⊣, what stands after it can begin with no ⊢, and a "
        "context is that of an extent that is there.",
        "before and after exchanged.",
        "Exchange them, or delete the one that the message names.",
    ),
    Code(
        "LK216",
        "instances of the whole facade",
        "The root stands in no other region, in which it could occur in several ways.",
        "The path of the root where that of a region inside was meant.",
        "Name regions inside it.",
    ),
    Code(
        "LK217",
        "symbol without a partner of its own",
        "In a symmetry, each symbol has one partner: another one by its pair, or itself without any.",
        "A symbol that stands in two pairs.",
        "Delete one of the pairs, or write another symmetry.",
    ),
    Code(
        "LK218",
        "two anchors on one axis",
        "A region is held by one point: at most one of left, center, right, and one of top, middle, bottom.",
        'anchor="left right".',
        "Choose one; to hold both sides, lock the size as well.",
    ),
    Code(
        "LK220",
        "pattern that sequences cannot say",
        "Overlapping sequences see neighbours only: none cover exactly the pattern's arrangements.",
        "A symbol that stands in several roles, such as piers on both sides of the only door.",
        "Give the symbol another name in each role, or write a wider pattern and bound it by a frequency.",
    ),
    Code(
        "LK221",
        "no sequences to go by",
        "A reversal or reuse goes by the sequences of a region that has none.",
        "A region that keeps the input's arrangement, which needs no sequence.",
        "Add a replication or other sequences for it.",
    ),
    Code(
        "LK222",
        "regions do not correspond",
        "Neither the names nor the places of the subregions tell which of two regions stand for each other.",
        "A pattern reused for a region of another structure.",
        "Say which symbols correspond, or give them the same names.",
    ),
    Code(
        "LK223",
        "run that the input lacks",
        "A replication repeats what the input has, and the input has no such run.",
        "Symbols in another order.",
        "Write a run of the input, or a sequence for one that it lacks.",
    ),
    Code(
        "LK224",
        "sizes that cannot add up",
        "What regions ask for inside another never adds up to what that one may have: it can have no size. "
        "That is an error if every layout needs the region, else a warning.",
        "A maximum lowered, and no minimum inside; or the other way round.",
        "Make up for what is missing, as the hint says: raise the maximum, or lower minima inside.",
    ),
    Code(
        "LK225",
        "no arrangement left",
        "The sequences of a region admit no arrangement, or none of theirs satisfies what else is asked of "
        "it: a symmetry, a frequency, another region's arrangement. That is an error if every layout needs "
        "the region, else a warning.",
        "No sequence that begins with ⊢, or none that ends with ⊣; a count that no arrangement has.",
        "Add a sequence that closes the gap, or loosen what else is asked.",
    ),
    Code(
        "LK226",
        "constraints that contradict each other",
        "The constraints cannot hold together in any layout, whatever its size.",
        "Two ranges of one region that do not meet; a size asked of a region that a lock keeps at another.",
        "Loosen one of those that the message lists, by the amount named.",
    ),
    Code(
        "LK227",
        "no layout of the facade's own size",
        "It is proved that no layout is as wide and as high as the facade itself; others may exist.",
        "Constraints written for another size; constraints that the input itself does not keep.",
        "Ask for the size that the hint names, or loosen one of the constraints listed.",
        Severity.WARNING,
    ),
    Code(
        "LK228",
        "symbol out of reach",
        "No arrangement that a region can have contains the symbol: it is in no layout, nor is what is "
        "inside. Constraints that speak of nothing else ask nothing.",
        "Sequences that were written before the region was added.",
        "Add a sequence with the symbol that overlaps others, or delete what is not meant.",
        Severity.WARNING,
    ),
    Code(
        "LK229",
        "constraint that never matters",
        "No layout can activate the constraint: what it speaks of cannot be there, or it asks nothing of it.",
        "An alignment of regions that stand side by side; a frequency without min and max.",
        "Say it of what a layout can have, or delete it.",
        Severity.WARNING,
    ),
    Code(
        "LK230",
        "neighbours that no arrangement has",
        "A sequence, a run or a context is in no arrangement that its region can have.",
        "A sequence that no other one overlaps; a context read in the wrong direction.",
        "Write the neighbours as an arrangement can have them, or allow these by a further sequence.",
        Severity.WARNING,
    ),
    Code(
        "LK231",
        "label nearly named",
        "No constraint names the label, and it differs from one that constraints name by its case, or by one "
        "letter. Labels that no constraint names, and that are like none, are no fault.",
        "Window in one region, window in another.",
        "Write one name for both, if both are meant.",
        Severity.NOTE,
    ),
)
