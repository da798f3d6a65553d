"""The reference says what the code says, and every link leads somewhere."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path
from types import ModuleType

import pytest

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.documents import check

ROOT = Path(__file__).parents[2]
PAGES = [*ROOT.glob("*.md"), *sorted((ROOT / "docs").rglob("*.md"))]

FACADE = """<facade xmlns="urn:layoutkit:1" name="other" units="m">
  <region symbol="Other" width="1" height="1"/>
  <constraints>{}</constraints>
</facade>
"""


def generator() -> ModuleType:
    spec = importlib.util.spec_from_file_location("docs_generate", ROOT / "docs" / "generate.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", ["constraints.md", "operations.md", "codes.md", "commands.md"])
def test_generated_pages_are_up_to_date(name: str) -> None:
    written = (ROOT / "docs" / "reference" / name).read_text(encoding="utf-8")
    assert written == generator().PAGES[name](), "run `python docs/generate.py`"


@pytest.mark.parametrize("kind", BUILT_IN, ids=lambda kind: kind.kind)
def test_every_kind_of_constraint_has_an_example_that_can_be_parsed(
    kind: type[Constraint], tmp_path: Path
) -> None:
    page = (ROOT / "docs" / "reference" / "constraints.md").read_text(encoding="utf-8")
    (section,) = re.findall(rf"^## {kind.kind}\n(.*?)^## ", page, re.M | re.S)
    (example,) = re.findall(r"```xml\n(.*?)```", section, re.S)
    assert example.startswith("<!-- "), "it says what it is for"
    assert f"\n<{kind.kind} " in example
    file = tmp_path / "example.xml"
    file.write_text(FACADE.format(example), encoding="utf-8")
    # Names of regions are those of another facade: all that is left to complain of.
    found = {d.code for d in check(file, {kind.kind: kind})}
    assert found == {"LK201"}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    links = [link for link in re.findall(r"(?<!!)\[[^\]]*\]\(([^)#\s]+)", text) if "://" not in link]
    assert [link for link in links if not (page.parent / link).exists()] == []
