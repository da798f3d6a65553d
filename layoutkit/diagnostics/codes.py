"""The registry of diagnostic codes: what each means, how it comes about, and what to do.

Groups: LK0 files and safety, LK1 structure, LK2 references and constraints, LK3 conversion, LK4 plugins,
LK5 layouts against facades, LK6 search, LK7 usage, LK8 masses and buildings, LK9 our own faults. A code
keeps its meaning for good; retired ones are not given out again.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from layoutkit.diagnostics.diagnostic import Severity


@dataclass(frozen=True, slots=True)
class Code:
    """What there is to say of one kind of diagnostic.

    Attributes
    ----------
    code
        Its stable name.
    title
        In a few words.
    explanation
        What the program found, and why it minds.
    cause
        How it commonly comes about.
    remedy
        What to do.
    severity
        What it is reported as, unless the reporter has reason to differ.
    """

    code: str
    title: str
    explanation: str
    cause: str
    remedy: str
    severity: Severity = Severity.ERROR


_NOTE, _WARNING = Severity.NOTE, Severity.WARNING

_FILES = (
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

_STRUCTURE = (
    Code(
        "LK101",
        "not a facade or layout document",
        "The root element is neither facade nor layout, or not in the namespace urn:layoutkit:1.",
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
)

_REFERENCES = (
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
)

_CONVERSION = (
    Code(
        "LK301",
        "annotation cannot be read",
        "The file is missing, may not be opened, or is not of the format's form.",
        "A misspelt name, or a file that was cut off.",
        "Correct the path, or mend the file at the place.",
    ),
    Code(
        "LK302",
        "picture missing or of another size",
        "Annotations give shares of a picture: its size is needed, and a mask's picture has the mask's size.",
        "No picture was named, and none of the same name stands beside the annotation.",
        "Name the picture that was annotated with --image.",
    ),
    Code(
        "LK303",
        "annotation shows nothing",
        "No usable box or labelled pixel is left, so there is nothing to convert.",
        "An empty file, or one whose boxes all have faults.",
        "Mend the faults listed with it.",
    ),
    Code(
        "LK304",
        "unknown class in an annotation",
        "A box or pixel is of a class that the format does not have; it is left out.",
        "A misspelt class, or a data set with other classes.",
        "Rename the class; the hint names the nearest one, or the ones known.",
        _WARNING,
    ),
    Code(
        "LK305",
        "box without area",
        "A box has no area, or not two finite numbers along each axis; it is left out.",
        "A click instead of a drag while annotating.",
        "Nothing is needed; draw the box again if it was meant.",
        _WARNING,
    ),
    Code(
        "LK306",
        "box beyond the picture",
        "A box reaches beyond the picture; only the part inside is kept.",
        "A picture that was cropped after it was annotated.",
        "Name the picture that was annotated.",
        _WARNING,
    ),
    Code(
        "LK307",
        "box given twice",
        "Two boxes have the same class and the same edges; one is left out.",
        "An annotation saved twice.",
        "Nothing is needed.",
        _WARNING,
    ),
    Code(
        "LK308",
        "several facades in one annotation",
        "The annotation marks several facades; those side by side become buildings of one document.",
        "A row of houses in one picture.",
        "Nothing is needed; annotate them apart to get a document for each.",
        _NOTE,
    ),
    Code(
        "LK309",
        "no facade in the annotation",
        "The annotation does not say where the facade is; the box around all elements is taken for it.",
        "An annotation of elements only.",
        "Add a facade box if the wall reaches further than its elements.",
        _WARNING,
    ),
)

_PLUGINS = (
    Code(
        "LK401",
        "plugin cannot be loaded",
        "Importing the plugin's module failed.",
        "A dependency of the plugin that is missing, or of another version.",
        "Install what the error names, or uninstall the plugin.",
        _WARNING,
    ),
    Code(
        "LK402",
        "plugin does not fit the hooks",
        "The plugin implements no hook, or one that does not exist, or with other parameters.",
        "A plugin written for another version of layoutkit.",
        "Upgrade the plugin.",
        _WARNING,
    ),
    Code(
        "LK403",
        "hook fails",
        "A plugin's hook raised an error; what it would have added is missing.",
        "A fault in the plugin.",
        "Report it to the plugin's author.",
        _WARNING,
    ),
    Code(
        "LK404",
        "hook returns something unusable",
        "What a plugin's hook returned is not what the hook asks for, and was skipped.",
        "A class returned where an instance is asked for.",
        "Report it to the plugin's author.",
        _WARNING,
    ),
    Code(
        "LK405",
        "names clash",
        "Two plugins, or two things that they add, go by the same name; the first is used.",
        "Two packages that solve the same problem.",
        "Disable one of them with LAYOUTKIT_DISABLE_PLUGINS.",
        _WARNING,
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
        "LAYOUTKIT_DISABLE_PLUGINS names a plugin that is not installed.",
        "A misspelt name.",
        "Correct it; `layoutkit plugins` lists the names.",
        _WARNING,
    ),
)

_LAYOUTS = (
    Code(
        "LK501",
        "layout does not fit its facade",
        "The layout breaks a rule that every layout keeps: known regions, exact tiling, identical replicas.",
        "A layout edited by hand, or a facade edited after the layout was made.",
        "Make the layout again from the facade.",
    ),
    Code(
        "LK502",
        "layout breaks a constraint",
        "A constraint of the facade does not hold in the layout.",
        "A layout edited by hand, or a constraint added after the layout was made.",
        "Change the layout by the amount named, or loosen the constraint.",
    ),
    Code(
        "LK503",
        "units differ",
        "Layout and facade, or facade and mass, state different units: their sizes cannot be compared.",
        "A layout scaled by another program; a mass in metres for a facade in pixels.",
        "Write both in the same units.",
    ),
    Code(
        "LK504",
        "facade not found",
        "The facade that a layout names is not there: the layout was read without it.",
        "A layout moved without its facade.",
        "Put the facade where the layout names it, or correct its facade attribute.",
        _NOTE,
    ),
    Code(
        "LK505",
        "not a facade",
        "The file that a layout names as its facade is another kind of document.",
        "The layout's own file named instead.",
        "Name the facade's document.",
    ),
    Code(
        "LK506",
        "soft constraint not kept",
        "A soft constraint of the facade does not hold in the layout, which is valid all the same.",
        "Hard constraints, or soft ones of greater weight, that leave no room for it.",
        "Nothing is needed; to insist on it, delete its weight, or raise it.",
        _NOTE,
    ),
)

_SEARCH: tuple[Code, ...] = (
    Code(
        "LK601",
        "limit reached",
        "The search gave up before it found a layout or proved that there is none.",
        "Constraints that leave hardly any arrangement.",
        "Raise --node-limit, or relax a constraint.",
    ),
    Code(
        "LK602",
        "constraints inferred",
        "The facade has no constraints: those that its own regularity suggests were used.",
        "A facade fresh from `layoutkit convert`.",
        "Write them into the document with `layoutkit infer`, and edit them there.",
        _NOTE,
    ),
    Code(
        "LK603",
        "soft constraint left out",
        "A soft constraint cannot be kept at the size asked for; the layouts do without it.",
        "Hard constraints, or soft ones of greater weight, that leave no room for it.",
        "Nothing is needed; to insist on it, delete its weight, or raise it.",
        _NOTE,
    ),
)

_USAGE: tuple[Code, ...] = (
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
        _WARNING,
    ),
    Code(
        "LK706",
        "size asked of a building",
        "Its faces have the sizes that the mass gives them, and no others.",
        "--width or --height together with --mass.",
        "Leave the size away, or change the mass.",
    ),
    Code(
        "LK710",
        "no such sample",
        "No shipped facade has that name.",
        "A misspelt name.",
        "Correct it; `layoutkit samples` lists them.",
    ),
)

_BUILDINGS = (
    Code(
        "LK801",
        "part of a mass without walls",
        "An outline needs sides that meet at their ends and nowhere else, and a part a height.",
        "Points in the wrong order, or one given twice; the first one repeated at the end.",
        "Draw a simple outline; a closed one closes by itself.",
    ),
    Code(
        "LK802",
        "face partly hidden",
        "A part of the face is inside other parts of the mass; it is laid out as a whole all the same.",
        "A tower that rises from inside a podium, and begins at the ground.",
        "Let it begin where the other part ends, or divide it there; nothing else is needed.",
        _NOTE,
    ),
    Code(
        "LK803",
        "faces named alike",
        "Each face of a mass goes by a name of its own.",
        "Several parts without names.",
        "Name them: the faces of the part Tower are Tower_South and so on.",
    ),
    Code(
        "LK804",
        "scope without effect",
        "A constraint of a kind that speaks of one region at a time says the same within faces and across.",
        'scope="building" on a constraint that names one region.',
        "Delete the scope.",
        _WARNING,
    ),
    Code(
        "LK805",
        "constraint not carried to faces",
        "Every face is a copy of the facade under its own name; the constraint still names the original.",
        "A plugin's kind that holds names of regions in an attribute of a type of its own.",
        "Let its author declare them with the types of `layoutkit.constraints.attributes`.",
    ),
    Code(
        "LK806",
        "faces not those of the mass",
        "A building's layout has one region for each face of its mass, in order, and of exactly its size.",
        "A mass edited in a finished layout.",
        "Make the layout again: `layoutkit vary FACADE --mass MASS`.",
    ),
    Code(
        "LK807",
        "facade split into faces",
        "A facade is one design; only layouts of buildings have faces.",
        "A region of a layout copied into a facade.",
        "Keep the region of one face; `layoutkit vary --mass` puts it on all faces of a mass.",
    ),
)

_OURS = (
    Code(
        "LK901",
        "layoutkit failed",
        "The program ran into an error that it does not foresee.",
        "A fault of ours.",
        "Report it, with the traceback that LAYOUTKIT_DEBUG=1 shows.",
    ),
    Code(
        "LK902",
        "layout breaks its constraints",
        "The search returned a layout that the check before writing does not pass; it is not written.",
        "A fault of ours, or of the plugin whose constraints the facade uses.",
        "Report it, with the facade's document and the seed.",
    ),
)

#: Every code, in order.
CODES: Mapping[str, Code] = {
    entry.code: entry
    for group in (
        _FILES,
        _STRUCTURE,
        _REFERENCES,
        _CONVERSION,
        _PLUGINS,
        _LAYOUTS,
        _SEARCH,
        _USAGE,
        _BUILDINGS,
        _OURS,
    )
    for entry in group
}
