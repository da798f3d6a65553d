"""A check opens the document and the facade that it names, and nothing else: no file, no socket."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = """
import sys
from layoutkit.constraints import BUILT_IN
from layoutkit.documents import check, read_mass

kinds = {kind.kind: kind for kind in BUILT_IN}
check(sys.argv[1], kinds)  # whatever is imported when it is first needed is imported now
events = []

def hook(event, arguments):
    if event.split(".")[0] in ("open", "exec", "import", "socket", "subprocess", "os", "urllib", "ctypes"):
        events.append((event, str(arguments[0])))

sys.addaudithook(hook)
found = check(sys.argv[1], kinds)
events, seen = [], events
for event, what in seen:
    print(event, what)
print(*(d.code for d in found))
"""
NETWORK = "http://127.0.0.1:9/x"
REGION = '<region symbol="F" width="1" height="1"/>'
HEAD = 'xmlns="urn:layoutkit:1" name="f" units="m"'
INCLUDED = f'<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="{NETWORK}"/>'
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
LOCATED = f'xmlns:xsi="{INSTANCE}" xsi:schemaLocation="urn:layoutkit:1 {NETWORK}.xsd"'
PICTURE = f'<picture file="{NETWORK}.png" left="0" top="0" right="1" bottom="1"/>'
HOSTILE = {
    "external entity": (
        f'<!DOCTYPE facade [<!ENTITY x SYSTEM "file:///etc/hostname">]><facade {HEAD}>&x;</facade>',
        "LK004",
    ),
    "external subset": (f'<!DOCTYPE facade SYSTEM "{NETWORK}.dtd"><facade {HEAD}>{REGION}</facade>', "LK004"),
    "public subset": (
        f'<!DOCTYPE facade PUBLIC "-//W3C//DTD XHTML 1.0 Strict//EN" "{NETWORK}"><facade/>',
        "LK004",
    ),
    "parameter entity": (f'<!DOCTYPE facade [<!ENTITY % p SYSTEM "{NETWORK}"> %p;]><facade/>', "LK004"),
    "notation": (f'<!DOCTYPE facade [<!NOTATION n SYSTEM "{NETWORK}">]><facade/>', "LK004"),
    "inclusion": (f"<facade {HEAD}>{REGION}{INCLUDED}</facade>", "LK102"),
    "inclusion in a layout": (
        f'<layout {HEAD}><region symbol="F" width="1" height="1" split="rows">{INCLUDED}</region></layout>',
        "LK102",
    ),
    "schema location": (f"<facade {HEAD} {LOCATED}>{REGION}</facade>", ""),
    "stylesheet": (
        f'<?xml-stylesheet href="{NETWORK}.xsl" type="text/xsl"?><facade {HEAD}>{REGION}</facade>',
        "",
    ),
    "model": (f'<?xml-model href="{NETWORK}.rng"?><facade {HEAD}>{REGION}</facade>', ""),
    "base": (f'<facade {HEAD} xml:base="{NETWORK}/">{REGION}</facade>', "LK103"),
    "picture": (
        f"<facade {HEAD}>{PICTURE}{REGION}</facade>",
        "",
    ),
    "facade on the network": (f'<layout {HEAD} facade="{NETWORK}.xml">{REGION}</layout>', "LK504"),
    "namespace to fetch": (f'<facade xmlns="{NETWORK}" name="f" units="m">{REGION}</facade>', "LK101"),
}
_LAUGHS = "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 30))
LAUGHS = f'<!DOCTYPE facade [<!ENTITY l0 "ha">{_LAUGHS}]>'
QUADRATIC = f'<!DOCTYPE facade [<!ENTITY a "{"a" * 100_000}">]><facade>{"&a;" * 100_000}</facade>'
HOSTILE |= {
    "billion laughs": (f"{LAUGHS}<facade>&l29;</facade>", "LK004"),
    "billion laughs in an attribute": (f'{LAUGHS}<facade name="&l29;"/>', "LK004"),
    "quadratic blow-up": (QUADRATIC, "LK004"),
}  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE)
def test_nothing_is_fetched(name: str, tmp_path: Path) -> None:
    text, code = HOSTILE[name]
    path = tmp_path / "hostile.xml"
    path.write_text(text)
    command = [sys.executable, "-I", "-c", PROGRAM, path]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=20)
    *events, codes = done.stdout.split("\n")[:-1]
    assert codes == code
    assert events
    assert set(events) == {f"open {path}"}


def test_the_hook_would_see_it(tmp_path: Path) -> None:
    """The same program, with a check that fetches."""
    path = tmp_path / "x.xml"
    path.write_text("<a/>")
    fetching = PROGRAM.replace(
        "found = check(sys.argv[1], kinds)\nevents,",
        "import socket\nsocket.socket().connect_ex(('127.0.0.1', 9))\n"
        "open('/etc/hostname').close()\nfound = []\nevents,",
    )
    done = subprocess.run(
        [sys.executable, "-I", "-c", fetching, path], capture_output=True, text=True, check=True
    )
    assert "socket.connect" in done.stdout
    assert "open /etc/hostname" in done.stdout
