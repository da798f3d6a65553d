"""What editors are given: a schema that explains all, a catalogue that leads to it, and settings."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from lxml import etree

from layoutkit.constraints import BUILT_IN
from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.documents import NAMESPACE, check, schemas
from layoutkit.hooks.host import Host
from layoutkit.shipped import shipped

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/how-to/editors.md").read_text(encoding="utf-8")
XS = "{http://www.w3.org/2001/XMLSchema}"
CATALOG = "{urn:oasis:names:tc:entity:xmlns:xml:catalog}"
KINDS = {kind.kind: kind for kind in BUILT_IN}


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", PAGE, re.S | re.M)


def test_every_element_and_attribute_is_explained() -> None:
    for text in schemas(Host.load().constraints).values():
        root = etree.fromstring(text)
        found = [e for e in root.iter(f"{XS}element", f"{XS}attribute") if "ref" not in e.attrib]
        assert found
        for declared in found:
            said = declared.findtext(f"{XS}annotation/{XS}documentation")
            assert said, declared.attrib
            assert said.strip()[-1] in ".:)", declared.attrib


def test_the_catalogue_leads_to_the_schema() -> None:
    folder = shipped("schemas")
    catalogue = etree.parse(folder / "catalog.xml").getroot()
    assert catalogue.tag == f"{CATALOG}catalog"
    entries = [entry for entry in catalogue if entry.get("uri")]
    named = {entry.get("name") or entry.get("systemId"): entry.get("uri") for entry in entries}
    assert named == {NAMESPACE: "layoutkit.xsd"}
    schema = etree.parse(folder / named[NAMESPACE]).getroot()
    assert schema.get("targetNamespace") == NAMESPACE


def test_the_catalogue_and_the_schema_are_shipped() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    included = project["tool"]["hatch"]["build"]["targets"]["wheel"]["force-include"]
    assert included["schemas"] == "layoutkit/_shipped/schemas"


@pytest.mark.skipif(sys.platform == "win32", reason="libxml2 takes its catalogues from a list with blanks")
def test_libxml2_finds_the_schema_by_the_catalogue(tmp_path: Path) -> None:
    """In a process of its own: libxml2 reads its catalogues once."""
    program = (
        "import sys; from lxml import etree\n"
        "schema = etree.XMLSchema(etree.parse('urn:layoutkit:1'))\n"
        "print(schema.validate(etree.parse(sys.argv[1])))"
    )
    environment = {"XML_CATALOG_FILES": (shipped("schemas") / "catalog.xml").as_uri()}
    document = ROOT / "facades/plain/facade.xml"
    command = [sys.executable, "-c", program, document]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout == "True\n"


def test_the_catalogue_of_the_page_is_the_one_that_is_shipped() -> None:
    (shown,) = (block for block in blocks("xml") if "<catalog" in block)
    parser = etree.XMLParser(remove_comments=True, remove_blank_text=True)
    kept = (shipped("schemas") / "catalog.xml").read_text()
    one, other = (etree.fromstring(text.encode(), parser) for text in (shown, kept))
    assert etree.tostring(one, method="c14n") == etree.tostring(other, method="c14n")


def test_the_settings_of_the_page_can_be_read() -> None:
    settings = [json.loads(block) for block in blocks("json")]
    assert [sorted(s) for s in settings] == [
        ["xml.catalogs", "xml.downloadExternalResources.enabled"],
        ["xml.fileAssociations"],
        ["tasks", "version"],
    ]


def patterns() -> list[dict[str, str | int]]:
    return [matcher["pattern"] for matcher in json.loads(blocks("json")[2])["tasks"][0]["problemMatcher"]]


@pytest.mark.parametrize(
    "place", [Place("in/a b.xml", 3, 7), Place("C:\\a.xml", 3, 7), Place("in/a b.xml"), None]
)
@pytest.mark.parametrize("code", ["LK101", "GOLD12"])
def test_one_pattern_of_the_task_reads_a_diagnostic(place: Place | None, code: str) -> None:
    told = str(Diagnostic(code, "size: of 3:4: error x", place, severity=Severity.NOTE))
    found = [(pattern, match) for pattern in patterns() if (match := re.match(str(pattern["regexp"]), told))]
    assert len(found) == (place is not None), "what is of no file is no problem of the editor's"
    for pattern, match in found:
        assert place
        assert match[pattern["file"]] == place.file
        assert (match[pattern["code"]], match[pattern["severity"]]) == (code, "note")
        assert ("line" in pattern) == (place.line > 0)


def test_the_task_reads_what_the_program_writes(tmp_path: Path) -> None:
    pattern = patterns()[0]
    path = tmp_path / "a.xml"
    path.write_text('<facade xmlns="urn:layoutkit:1" name="f" units="m">\n <regoin/></facade>')
    for diagnostic in check(path, KINDS):
        found = re.match(str(pattern["regexp"]), str(diagnostic).split("\n")[0])
        assert found
        told = {name: found[group] for name, group in pattern.items() if name != "regexp"}
        assert diagnostic.place
        assert (told["code"], int(told["line"])) == (diagnostic.code, diagnostic.place.line)
        assert (told["file"], told["severity"]) == (str(path), "error")


def test_the_document_of_the_page_is_valid_by_the_schema() -> None:
    (shown,) = (block for block in blocks("xml") if "<facade" in block)
    assert etree.XMLSchema(file=ROOT / "schemas/layoutkit.xsd").validate(etree.fromstring(shown.encode()))
