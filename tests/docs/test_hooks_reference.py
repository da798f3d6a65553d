"""The reference of hooks and settings says what there is, no less and no more."""

from __future__ import annotations

import re
import typing
from collections.abc import Iterable
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import pytest
import typer.main

from layoutkit.cli.app import app
from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import AttributeType
from layoutkit.constraints.claims import Claim, Relates
from layoutkit.constraints.word_rules import WordRule
from layoutkit.hooks import Format, Hooks, Outcome, SceneFormat, Stage
from layoutkit.hooks.checks import constraint_fault, operation_fault
from layoutkit.operations import Operation
from layoutkit.scenes.relationship import Relationship
from layoutkit.sizing.qp import Backend
from layoutkit.sizing.rules import SizeRule
from layoutkit.testing import PROMISES, ConstraintSuite

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "hooks.md"
HOW_TO = ROOT / "docs" / "how-to"


def section(title: str) -> str:
    """Return what stands below a heading, up to the next of its level."""
    text = PAGE.read_text(encoding="utf-8")
    level = re.search(rf"^(#+) {re.escape(title)}$", text, re.M)
    assert level is not None, title
    rest = text[level.end() :]
    return re.split(rf"^#{{1,{len(level[1])}}} ", rest, flags=re.M)[0]


def rows(text: str) -> dict[str, str]:
    """Return the rows of the tables in a text: the name in the first cell, without its parameters."""
    return {
        found[1]: found[2]
        for found in re.finditer(r"^\| `(-*[A-Za-z_-]+)(?:\([^)]*\))?` \|(.*)$", text, re.M)
    }


def public(cls: type) -> set[str]:
    """Return what a class offers: its methods, properties, class attributes and fields."""
    return {name for name in (*vars(cls), *cls.__annotations__) if not name.startswith("_")}


def test_every_hook_is_documented() -> None:
    hooks = {name for name in vars(Hooks) if name.startswith("layoutkit_")}
    assert rows(section("Hooks")).keys() == hooks


OFFERS = (Constraint, Stage, Format, SceneFormat, Relationship, Backend, Operation)


@pytest.mark.parametrize("cls", OFFERS)
def test_every_method_and_class_attribute_is_documented(cls: type) -> None:
    text = section(cls.__name__)
    for inner in ("Attributes", "Rules", "Claims"):
        text = text.split(f"### {inner}\n")[0]
    outcome = {field.name for field in fields(Outcome)} if cls is Stage else set()
    assert rows(text).keys() - {"Outcome"} == public(cls) | outcome


def test_parameters_are_the_methods_own() -> None:
    text = PAGE.read_text(encoding="utf-8")
    for cls in OFFERS:
        for name, method in vars(cls).items():
            function = getattr(method, "__func__", method)
            if name.startswith("_") or isinstance(function, type) or not callable(function):
                continue
            code = function.__code__
            count = code.co_argcount + bool(code.co_flags & 0x08)  # **values is a name, too
            names = code.co_varnames[1:count]
            assert f"`{name}({', '.join(names)})`" in text


def test_what_is_required_is_told() -> None:
    assert "`kind`, `namespace`, `summary` and `violations` are required" in section("Constraint")
    assert constraint_fault(Constraint) != ""
    assert "`kind`, `namespace`, `summary` and `apply` are required" in section("Operation")
    assert operation_fault(Operation) != ""


def test_every_field_of_an_attributes_type_is_documented() -> None:
    own = section("Attributes").partition("A type of one's own")[2]
    assert rows(own).keys() == {field.name for field in fields(AttributeType)}


def test_every_rule_is_documented_with_its_fields() -> None:
    _same_fields(rows(section("Rules")), (*typing.get_args(WordRule), *typing.get_args(SizeRule)))


def test_every_claim_is_documented_with_its_fields() -> None:
    text = section("Claims")
    _same_fields({n: cells.split("|")[0] for n, cells in rows(text).items()}, typing.get_args(Claim))
    told = text.split("`relations` yields")[1]
    assert all(f"`{field.name}`" in told for field in fields(Relates))


def _same_fields(found: dict[str, str], classes: Iterable[Any]) -> None:
    documented = {name: re.findall(r"`(\w+)`", cells) for name, cells in found.items()}
    assert documented == {cls.__name__: [field.name for field in fields(cls)] for cls in classes}


def test_the_suite_for_tests_is_documented() -> None:
    text = section("Testing")
    own = {name for name in ConstraintSuite.__annotations__ if not name.startswith("_")}
    assert rows(text).keys() == own
    promises = re.search(r"The promises are (.*?);", text, re.S)
    assert promises is not None
    assert re.findall(r"`(\w+)`", promises[1]) == list(PROMISES)


def test_every_promise_is_explained() -> None:
    page = (HOW_TO / "plugin-constraints.md").read_text(encoding="utf-8")
    assert list(rows(page.split("| promise |")[1].split("\n\n")[0])) == list(PROMISES)


def test_every_option_of_the_program_is_documented() -> None:
    group: Any = typer.main.get_command(app)
    options = {parameter.opts[0] for parameter in group.params} - {
        "--install-completion",
        "--show-completion",
    }
    assert rows(section("Options of every run")).keys() == options


def test_every_environment_variable_is_documented() -> None:
    page = section("Environment variables")
    files = [*(ROOT / "layoutkit").rglob("*.py"), *(ROOT / "plugins").glob("layoutkit_*/**/*.py")]
    code = "".join(file.read_text(encoding="utf-8") for file in files)
    # LAYOUTKIT_API is no variable: a plugin's module states it.
    assert set(re.findall(r"\bLAYOUTKIT_[A-Z_]+", code)) - {"LAYOUTKIT_API"} == set(
        re.findall(r"`(LAYOUTKIT_[A-Z_]+)`", page)
    )
    assert "`LAYOUTKIT_API = 1`" in section("Hooks")


@pytest.mark.parametrize(
    ("page", "cls"),
    [
        ("plugin-formats.md", Format),
        ("plugin-stages.md", Stage),
        ("plugin-stages.md", Outcome),
        ("plugin-qp-backends.md", Backend),
        ("plugin-scene-formats.md", SceneFormat),
        ("plugin-relationships.md", Relationship),
        ("plugin-operations.md", Operation),
    ],
)
def test_the_page_of_a_plugin_kind_names_all_that_it_offers(page: str, cls: type) -> None:
    text = (HOW_TO / page).read_text(encoding="utf-8")
    known = {field.name for field in fields(cls)} if is_dataclass(cls) else public(cls)
    assert known <= rows(text).keys()


def test_the_page_of_constraints_names_each_rule_and_method() -> None:
    text = (HOW_TO / "plugin-constraints.md").read_text(encoding="utf-8")
    rules = {cls.__name__ for cls in typing.get_args(WordRule) + typing.get_args(SizeRule)}
    assert rules <= rows(text).keys()
    given = {"kind", "namespace", "summary", "place", "comment", "attributes", "qualified_name", "soft"}
    assert {name for name in public(Constraint) - given if not re.search(rf"`{name}[`(]", text)} == set()


def test_every_kind_of_plugin_has_a_page() -> None:
    overview = (HOW_TO / "plugin.md").read_text(encoding="utf-8")
    pages = sorted(page.name for page in HOW_TO.glob("plugin-*.md"))
    assert pages == sorted(set(re.findall(r"\]\((plugin-[a-z-]+\.md)\)", overview)))
    hooks = [name for name in vars(Hooks) if name.startswith("layoutkit_")]
    texts = {page: (HOW_TO / page).read_text(encoding="utf-8") for page in pages}
    assert all(sum(f"def {hook}():" in text for text in texts.values()) == 1 for hook in hooks)


def test_every_type_of_attribute_is_listed() -> None:
    from layoutkit.constraints import attributes

    types = {name for name, value in vars(attributes).items() if isinstance(value, AttributeType)}
    listed = re.findall(r"^\| `([A-Z]+)` \|", section("Attributes"), re.M)
    assert sorted(listed) == sorted(types)
