"""The hook for kinds of operations, and the commands that use it: what it takes, what it refuses, and why."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import pytest

from layoutkit.constraints.attributes import attribute
from layoutkit.constraints.namespace import CORE, Namespace
from layoutkit.diagnostics.origin import BUILT_IN, Origin
from layoutkit.documents.grammar import SIZE
from layoutkit.hooks.checks import core_claim, operation_fault
from layoutkit.hooks.host import Host
from layoutkit.operations import Design, Operation
from layoutkit.operations.attributes import DESIGN, held
from tests.operations.documents.operation_kinds import KINDS, MODEL, Bend, Still
from tests.operations.documents.test_operation_documents import document

THEIRS = Origin("acme", "acme-plugin", "1.2", "acme")
OWN = Namespace("acme", "urn:acme:1")


@dataclass(frozen=True, kw_only=True)
class Idle(Operation):
    """It cannot be applied."""

    kind: ClassVar[str] = "idle"
    summary: ClassVar[str] = "Does nothing."


@dataclass(frozen=True, kw_only=True)
class Bare(Still):
    """It has a field that is not declared."""

    amount: float = 1.0


@dataclass(frozen=True, kw_only=True)
class Holder(Still):
    """It holds what no document has."""

    scene: Any = held("scene", "What.")


@dataclass(frozen=True, kw_only=True)
class Twice(Still):
    """It would hold two of the same element."""

    one: Any = held("placement-model", "One.")
    other: Any = held("placement-model", "Another.")


@dataclass(frozen=True, kw_only=True)
class Filed(Still):
    """It names a file that no document does."""

    facade: Design = attribute(DESIGN, "What.", Design("wall.xml"))


@dataclass(kw_only=True)
class Thawed:
    """It is something else."""


class Warm(Still):
    """It is a dataclass only by what it inherits."""


@dataclass(frozen=True, kw_only=True)
class Sound(Still):
    """All is well with it."""

    amount: float = attribute(SIZE, "How much.", 1.0)
    model: Any = held("placement-model", "Where.")


def named(kind: str) -> type:
    return dataclass(frozen=True, kw_only=True)(type("Named", (Still,), {"kind": kind}))


def spaced(namespace: Any) -> type:
    return dataclass(frozen=True, kw_only=True)(type("Spaced", (Still,), {"namespace": namespace}))


@pytest.mark.parametrize(
    ("item", "fault"),
    [
        (Thawed, "is no subclass of Operation"),
        (Still(), "is no subclass of Operation"),
        (Idle, "Idle has no apply()"),
        (Bare, "Bare.amount is not declared with attribute() or held()"),
        (Holder, "Holder.scene is held as 'scene': each of placement-model may be held once"),
        (Twice, "Twice.other is held as 'placement-model': each of placement-model may be held once"),
        (Filed, "Filed.facade has a file for its default: files are named in documents"),
        (Warm, "Warm is no frozen dataclass"),
        (named("Big"), "Named.kind is 'Big', not a name of small letters"),
        (named("branch"), "Named.kind is 'branch', which is the name of another element"),
        (named("placement-model"), "Named.kind is 'placement-model', which is the name of another"),
        (spaced("acme"), "Spaced.namespace is 'acme', and no Namespace"),
        (spaced(Namespace("xml-acme", "urn:a")), "has the prefix 'xml-acme'"),
        (spaced(Namespace("acme", CORE.uri)), "has the URI 'urn:layoutkit:1'"),
        (spaced(OWN), ""),
        (Sound, ""),
        *((kind, "") for kind in KINDS.values()),
    ],
)
def test_what_the_hook_takes(item: object, fault: str) -> None:
    found = operation_fault(item)
    assert fault in found
    assert bool(found) is bool(fault)


def test_layoutkits_namespace_is_its_own() -> None:
    assert core_claim(Still, BUILT_IN) == ""
    assert core_claim(Still, THEIRS) == "Still.namespace is layoutkit's own: give it a namespace of your own"
    assert core_claim(Bend, THEIRS) == ""


SOURCE = Path(__file__).with_name("operation_kinds.py").read_text(encoding="utf-8")
HOOK = "\n\nfrom layoutkit.hooks import hookimpl\n\n@hookimpl\ndef layoutkit_operations():\n    return [{}]\n"


def test_a_plugins_kind_takes_part(install: Callable[..., Path], layoutkit: Any, tmp_path: Path) -> None:
    install("benders", SOURCE + HOOK.format("Bend"))
    host = Host.load()
    assert host.operations.find("acme:bend").kind == "bend"
    assert host.added_by("benders")["operations"] == ("acme:bend",)
    assert host.diagnostics == ()
    assert "  operations: acme:bend" in layoutkit("plugins").out
    file = tmp_path / "o.xml"
    file.write_text(document('<select labels="A">\n<acme:bend angle="3"/>\n<acme:bend angel="3"/></select>'))
    checked = layoutkit("validate", file)
    assert checked.code == 1
    assert f"{file}:4:1: error LK103" in checked.err
    assert "did you mean 'angle'?" in checked.err
    absent = layoutkit("--without", "benders", "validate", file)
    assert f"{file}:3:1: error LK113" in absent.err


def test_a_plugin_that_takes_layoutkits_namespace_is_named(install: Callable[..., Path]) -> None:
    install("stills", SOURCE + HOOK.format("Still, Bend"))
    host = Host.load()
    assert "still" not in host.operations
    assert "acme:bend" in host.operations
    (refused,) = host.diagnostics
    assert refused.code == "LK404"
    assert "Still.namespace is layoutkit's own" in refused.message


@pytest.mark.parametrize("work", ["raise KeyError('lost')", "return Result(site, ('Nothing',))", "return 7"])
def test_an_operation_that_fails_at_its_work_is_named(
    work: str, install: Callable[..., Path], layoutkit: Any, tmp_path: Path
) -> None:
    failing = SOURCE.replace("return Result(site, scope)", work)
    install("benders", failing + HOOK.format("Bend"))
    file, scene = tmp_path / "o.xml", tmp_path / "s.xml"
    file.write_text(document("<acme:bend/>"))
    scene.write_text(
        '<scene xmlns="urn:layoutkit:1" name="s" units="m"><polygon points="0,0 1,0 1,1"/></scene>'
    )
    run = layoutkit("replay", file, scene, "--no-views", "-o", tmp_path / "out")
    assert run.code == 5
    assert "o.xml:2:1: error LK407 plugin: the operation 'acme:bend' of the plugin 'benders'" in run.err


def test_inspect_shows_the_tree(layoutkit: Any, tmp_path: Path) -> None:
    file = tmp_path / "o.xml"
    branches = '<branch weight="2"><delete/></branch><branch/>'
    inside = f'<select labels="A B"><place threshold="0.5">{MODEL}</place>{branches}</select>'
    file.write_text(document(inside, ' sites="Plot Lot"'))
    assert layoutkit("inspect", file).out.splitlines() == [
        "operations o: 3 operations, m, on each @Plot @Lot",
        '└── select labels="A B"',
        """    ├── place threshold="0.5" <placement-model 'sills'>""",
        "    ├── branch of weight 2",
        "    │   └── delete",
        "    └── branch of weight 1",
    ]
    data = layoutkit("inspect", file, "--json").data
    assert {key: data[key] for key in ("kind", "name", "units", "sites")} == {
        "kind": "operations",
        "name": "o",
        "units": "m",
        "sites": ["Plot", "Lot"],
    }
    (select,) = data["operations"]
    assert (select["kind"], select["attributes"]) == ("select", {"labels": "A B", "without": ""})
    (place,) = select["children"]
    assert place["attributes"]["threshold"] == "0.5"
    assert place["placement-model"] == "sills"
    assert [(b["weight"], [o["kind"] for o in b["operations"]]) for b in select["branches"]] == [
        (2, ["delete"]),
        (1, []),
    ]


def test_commands_for_facades_say_what_to_do_with_operations(layoutkit: Any, tmp_path: Path) -> None:
    file = tmp_path / "o.xml"
    file.write_text(document("<delete/>"))
    for command in (("vary", file, "-o", tmp_path / "out"), ("render", file, "-o", tmp_path / "o.png")):
        run = layoutkit(*command)
        assert run.code == 1
        assert "LK101" in run.err
        assert f"`layoutkit replay {file} SCENE -o out` makes the operations in a scene" in run.err


def test_operations_are_no_scene(layoutkit: Any, tmp_path: Path) -> None:
    file = tmp_path / "o.xml"
    file.write_text(document("<delete/>"))
    run = layoutkit("replay", file, file, "--no-views", "-o", tmp_path / "out")
    assert run.code == 1
    assert "error LK101 schema: <operations> is no scene" in run.err
    assert f"name a scene; `layoutkit replay {file} SCENE -o OUT` makes them in it" in run.err


def test_validate_takes_folders_with_operations(layoutkit: Any, tmp_path: Path) -> None:
    (tmp_path / "o.xml").write_text(document("<delete/>"))
    run = layoutkit("validate", tmp_path)
    assert (run.code, run.out.splitlines()[0]) == (0, f"{tmp_path / 'o.xml'}: valid")
