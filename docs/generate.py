"""Writes the pages of the reference that follow from declarations in the code; a test holds them equal.

Run it from the root of the project: ``python docs/generate.py``.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import typer.main

from layoutkit.cli.app import app
from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.constraints.attributes import Attribute, AttributeType
from layoutkit.diagnostics import Faulty
from layoutkit.diagnostics.codes import CODES
from layoutkit.diagnostics.codes.examples import GAP, UNSHOWN, Example, Frame
from layoutkit.documents import read
from layoutkit.documents.operation_grammar import BRANCH, OPERATIONS, holdings
from layoutkit.documents.writing import constraint_lines
from layoutkit.model import Facade
from layoutkit.model.measure import format_number
from layoutkit.samples import list_samples
from layoutkit_operations.kinds import BUILT_IN as OPERATION_KINDS

REFERENCE = Path(__file__).parent / "reference"
HOW_TO = Path(__file__).parent / "how-to"
_FILE = re.compile(r"<!-- file: \S+ -->\n```xml\n(.*?)```", re.S)
NOTE = "<!-- written by docs/generate.py: change what it reads, and run it again -->"

#: What the types of attributes mean to those who write documents.
TYPES = {
    "measure": "a number of at least 0, in document units or a count; with `%`, a share of the input's",
    "count": "a whole number of at least 0",
    "regions": (
        "paths such as `Facade/Floor/Bay`, labels such as `@Window`, and all that is inside a region, "
        "`Facade/Floor/*`, joined by `|` (or), `&` (and), `-` (without), with parentheses"
    ),
    "extent": "regions; or a run of neighbours, as the path of their parent, a colon, and their symbols",
    "word": (
        "symbols, `@labels` and sets in braces, such as `{A @Door}`, of direct subregions; `|-` or `⊢` first "
        "for the start, `-|` or `⊣` last for the end"
    ),
    "context": "a word of what stands beside; or only its end of the encompassing region, `|-` or `-|`",
    "pairs": "pairs of symbols of direct subregions, separated by spaces, such as `E:K L:R`",
    "weight": "a number above 0",
    "bias": "a number from -1 to 1",
    "members": "as regions; a single symbol means a direct subregion of the region that `within` names",
    "enclosing path": "the path of a region, such as `Facade/Floor`",
    "pattern": (
        "a word with marks: `?` behind what may be left out, `+` behind what may be repeated, `*` for both, "
        "with what comes between two repetitions in brackets, as in `(A B)+[C]`; parentheses group, and `|` "
        "stands between alternatives"
    ),
    "path": "the path of a region, such as `Facade/Floor`",
    "paths": "paths, separated by spaces",
}

#: What the types of operations' attributes mean.
OPERATION_TYPES = {
    "size": "a number above 0",
    "amount": "a number of at least 0",
    "number": "a number",
    "whole": "a whole number of at least 0",
    "symbol": "a label: a letter or underscore, then letters, digits and underscores",
    "labels": "labels, separated by spaces",
    "text": "any text",
    "colour": "a colour such as `#c8b090`: two hexadecimal digits each of red, green and blue",
    "facade file": "the file of a facade's document, relative to that of the operations",
    "session file": "the file of a session's document, relative to that of the operations",
}
_OPERATIONS = """\
<operations xmlns="urn:layoutkit:1" name="houses" units="m" sites="Plot">
  <select labels="House">
    <extrude height="6" random="0.2">
      <select labels="Front"> <vary facade="front.xml"/> </select>
    </extrude>
  </select>
  <select labels="Tree">
    <branch weight="3"> <extrude height="5" cap="none"/> </branch>
    <branch/>
  </select>
</operations>"""


def constraints_page() -> str:
    """Return the reference of the built-in constraints."""
    used = {a.type.name: a.type for kind in BUILT_IN for a in kind.attributes() if not a.type.choices}
    examples = _examples()
    lines = ["# Reference: constraints", "", NOTE, ""]
    lines += ["They stand in the element `constraints` of a facade, each as an element of its own. A comment"]
    lines += [
        "directly above one says why it is there. `layoutkit schema` also explains those that plugins add."
    ]
    for kind in BUILT_IN:
        lines += ["", f"## {kind.kind}", "", kind.summary, "", "| attribute | | |", "|---|---|---|"]
        lines += [_row(attribute) for attribute in kind.attributes()]
        lines += ["", "```xml", *constraint_lines([examples[kind]]), "```"]
    lines += ["", "## Values", "", "| type | is |", "|---|---|"]
    lines += [f"| {name} | {_cell(TYPES[name])} |" for name in used]
    return "\n".join([*lines, ""])


def _row(attribute: Attribute) -> str:
    need = "required" if attribute.required else "optional"
    if not attribute.required and attribute.default not in (None, "", ()):
        default = attribute.default
        shown = format_number(default) if isinstance(default, float) else attribute.type.text(default)
        need = f"`{shown}` if left out"
    return f"| `{attribute.name}` | {_type(attribute.type)}, {need} | {_cell(attribute.help)} |"


def _type(kind: AttributeType) -> str:
    if not kind.choices:
        return kind.name
    return f"{'some' if kind.many else 'one'} of {', '.join(f'`{choice}`' for choice in kind.choices)}"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _examples() -> dict[type[Constraint], Constraint]:
    """Return, for each kind, the first constraint with a reason given: samples, then how-to pages."""
    found: dict[type[Constraint], Constraint] = {}
    for facade in (*_samples(), *_shown()):
        for constraint in facade.constraints:
            if constraint.comment:
                found.setdefault(type(constraint), constraint)
    return found


def _samples() -> Iterator[Facade]:
    for sample in list_samples():
        yield from _facades(sample.path)


def _shown() -> Iterator[Facade]:
    """Yield the facades of the how-to pages."""
    with TemporaryDirectory() as folder:
        file = Path(folder, "shown.xml")
        for page in sorted(HOW_TO.glob("*.md")):
            for shown in _FILE.findall(page.read_text(encoding="utf-8")):
                file.write_text(shown, encoding="utf-8")
                yield from _facades(file)


def _facades(path: Path) -> Iterator[Facade]:
    """Yield the facade of a document: none of what is no facade, or shows a fault."""
    with suppress(Faulty):
        model = read(path, {kind.kind: kind for kind in BUILT_IN}).model
        if isinstance(model, Facade):
            yield model


def operations_page() -> str:
    """Return the reference of operations documents, and of the kinds of operations that are built in."""
    lines = ["# Reference: operations", "", NOTE, ""]
    lines += [
        "An operations document is a tree: each operation works on what the one that it stands in has made",
        "or chosen, those in the root on everything. What an operation holds comes first, then the",
        "operations that go on with all of its output, then branches, which share the output out among them.",
        "Kinds that plugins add are elements of their own namespaces; `layoutkit schema` explains them, too.",
        "",
        "```xml",
        *_OPERATIONS.splitlines(),
        "```",
    ]
    for element in (OPERATIONS, BRANCH):
        lines += _declared_element(element.name, element.help, tuple(element.attributes.values()))
    for kind in OPERATION_KINDS:
        lines += _declared_element(kind.kind, kind.summary, kind.attributes())
        lines += ["", *(f"It holds `<{own.element}>`: {own.help}" for own in holdings(kind))]
        if not holdings(kind):
            lines.pop()
    used = {a.type.name for kind in OPERATION_KINDS for a in kind.attributes() if not a.type.choices}
    lines += ["", "## Values", "", "| type | is |", "|---|---|"]
    lines += [f"| {name} | {_cell(meaning)} |" for name, meaning in OPERATION_TYPES.items() if name in used]
    return "\n".join([*lines, ""])


def _declared_element(name: str, help: str, attributes: tuple[Attribute, ...]) -> Iterator[str]:
    yield from ("", f"## {name}", "", help)
    if attributes:
        yield from ("", "| attribute | | |", "|---|---|---|")
        yield from map(_row, attributes)


def codes_page() -> str:
    """Return the reference of diagnostic codes."""
    lines = ["# Reference: diagnostic codes", "", NOTE, ""]
    lines += [
        "How to read a diagnostic is told [here](../how-to/diagnostics.md). Each code is shown by an example"
    ]
    lines += ["with the fault, and by the same one mended; what they stand in is shown [below](#frames)."]
    for code in CODES.values():
        lines += [
            "",
            f"## {code.code}: {code.title}",
            "",
            f"*{str(code.severity).capitalize()}.* {code.explanation}",
        ]
        lines += ["", f"- Commonly from: {code.cause}", f"- Remedy: {code.remedy}"]
        lines += _shown_example(code.example) if code.example else _unshown(code.code)
    frames = dict.fromkeys(code.example.frame for code in CODES.values() if code.example)
    lines += ["", "## Frames", "", f"Examples stand where `{GAP}` is."]
    for frame in sorted(frames, key=lambda frame: frame.name):
        lines += _frame(frame)
    return "\n".join([*lines, ""])


def _shown_example(example: Example) -> Iterator[str]:
    """Yield the lines of an example."""
    language, frame = _language(example.frame), example.frame
    yield from ("", f"Wrong, in [{frame.name}](#{_anchor(frame.name)}):", "")
    yield from (
        f"```{language}",
        example.wrong,
        "```",
        "",
        "Mended:",
        "",
        f"```{language}",
        example.mended,
        "```",
    )


def _unshown(code: str) -> Iterator[str]:
    yield from ("", f"There is no example: {UNSHOWN[code]}.")


def _frame(frame: Frame) -> Iterator[str]:
    """Yield the lines that show what examples stand in."""
    yield from ("", f"### {_title(frame.name)}", "")
    if frame.command == GAP:
        yield "Commands, in a folder with the files below."
    else:
        yield f"The fault is seen by `{frame.command}`; the file is `{frame.file}`."
    if frame.text.strip() != GAP:
        yield from ("", f"```{_language(frame)}", frame.text.rstrip(), "```")
    if frame.pictures:
        yield from ("", f"Beside it is a picture, `{'`, `'.join(frame.pictures)}`.")
    shown: dict[str, str] = {}
    for name, text in frame.beside.items():
        if text in shown:
            yield from ("", f"`{name}` is the same as `{shown[text]}`.")
            continue
        shown[text] = name
        language = "python" if name.endswith(".py") else "xml" if name.endswith(".xml") else "text"
        yield from ("", f"`{name}`:", "", f"```{language}", text.rstrip(), "```")


def _language(frame: Frame) -> str:
    return {"py": "python", "xml": "xml"}.get(frame.file.rpartition(".")[2], "sh")


def _title(name: str) -> str:
    return name[0].upper() + name[1:]


def _anchor(title: str) -> str:
    """Return what links to a heading, as GitHub makes it."""
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")


def commands_page() -> str:
    """Return the reference of the commands."""
    group: Any = typer.main.get_command(app)
    lines = ["# Reference: commands", "", NOTE, ""]
    lines += ["`layoutkit [--strict] COMMAND ...`. Results go to stdout, progress and diagnostics to stderr."]
    lines += [
        "[Exit codes](../how-to/diagnostics.md) and [environment variables](hooks.md) are told elsewhere."
    ]
    lines += ["", "| option of `layoutkit` itself | |", "|---|---|"]
    lines += [_parameter(parameter) for parameter in group.params]
    for name, command in group.commands.items():
        lines += _command(name, command)
    return "\n".join([*lines, ""])


def _command(name: str, command: Any) -> list[str]:
    """Return the section of a command, and of those below it."""
    lines = [
        "",
        f"## {name}",
        "",
        inspect.cleandoc(command.help),
        "",
        "| argument or option | |",
        "|---|---|",
    ]
    lines += [_parameter(parameter) for parameter in _parameters(command)]
    lines += ["", inspect.cleandoc(command.epilog).replace("`\n\n- `", "`\n- `")]
    for inner_name, inner in getattr(command, "commands", {}).items():
        lines += _command(f"{name} {inner_name}", inner)
    return lines


def _parameters(command: Any) -> list[Any]:
    """Return the arguments and options of a command, those included that a stage declares."""
    context = command.make_context(command.name, [], resilient_parsing=True)
    return [parameter for parameter in command.get_params(context) if parameter.name != "help"]


def _parameter(parameter: Any) -> str:
    """Return a row of a command's table."""
    if parameter.param_type_name == "argument":
        return f"| `{parameter.metavar or parameter.name.upper()}` | {_cell(parameter.help or '')} |"
    value = "" if parameter.is_flag else f" {_value(parameter)}"
    help_text = parameter.help or ""
    if parameter.required:
        help_text += " Required."
    elif parameter.default not in (None, "") and not parameter.is_flag:
        help_text += f" By default {parameter.default}."
    if parameter.secondary_opts:
        help_text += f" By default {'on' if parameter.default else 'off'}."
    own = [*parameter.opts[:-1], " / ".join([parameter.opts[-1] + value, *parameter.secondary_opts])]
    names = ", ".join(f"`{name}`" for name in own)
    return f"| {_cell(names)} | {_cell(help_text)} |"


def _value(parameter: Any) -> str:
    """Return what stands for an option's value: what it is called, its choices, or a number or text."""
    if parameter.metavar:
        return str(parameter.metavar)
    if choices := getattr(parameter.type, "choices", ()):
        return "|".join(map(str, choices))
    return "N" if parameter.type.name.split()[0] in ("integer", "float") else "TEXT"


PAGES = {
    "constraints.md": constraints_page,
    "operations.md": operations_page,
    "codes.md": codes_page,
    "commands.md": commands_page,
}

if __name__ == "__main__":
    for name, page in PAGES.items():
        (REFERENCE / name).write_text(page(), encoding="utf-8")
