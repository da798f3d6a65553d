"""Plugins that work, and every way in which one can fail: it is named with its package, the host lives."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import pytest

from layoutkit.constraints import BUILT_IN
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.hooks.host import Host

FORMAT = """
    from layoutkit.hooks import Format, hookimpl

    class Toy(Format):
        name = "toy"
        summary = "Reads toys."
        def recognises(self, path, head): return head.startswith(b"toy")
        def read(self, path, picture): raise RuntimeError("no toys today")

    @hookimpl
    def layoutkit_formats():
        return [Toy()]
"""


def codes(host: Host) -> list[str]:
    return [d.code for d in host.diagnostics]


def everything(host: Host) -> None:
    for name in ("constraints", "stages", "formats", "backends"):
        getattr(host, name)


def test_the_built_in_kinds_and_backends_are_there_in_order() -> None:
    host = Host.load(points=())
    assert list(host.constraints.values()) == list(BUILT_IN)
    assert list(host.constraints) == [kind.kind for kind in BUILT_IN]
    assert list(host.backends) == ["daqp", "clarabel"]
    assert host.diagnostics == ()


def test_a_plugin_adds_its_format_and_is_named_with_its_package(install: Any) -> None:
    install("toys", FORMAT)
    host = Host.load()
    assert host.formats.find("toy").name == "toy"
    assert str(host.origins["toys"]) == "plugin 'toys' of acme-plugin 1.2"
    assert host.added_by("toys")["formats"] == ("toy",)
    assert host.added_by("builtin")["backends"] == ("daqp", "clarabel")
    assert host.diagnostics == ()


BROKEN = {
    "import": ("import a_module_that_is_not_there", "LK401", "No module named 'a_module_that_is_not_there'"),
    "syntax": ("def (", "LK401", "SyntaxError"),
    "exit": ("import sys; sys.exit(3)", "LK401", "SystemExit: 3"),
    "empty": ("", "LK402", "implements no hook"),
    "misspelt": (
        "from layoutkit.hooks import hookimpl\n@hookimpl\ndef layoutkit_stage(): return []",
        "LK402",
        "implements 'layoutkit_stage', which is no hook",
    ),
    "parameters": (
        "from layoutkit.hooks import hookimpl\n@hookimpl\ndef layoutkit_stages(host): return []",
        "LK402",
        "host",
    ),
    "raises": (
        "from layoutkit.hooks import hookimpl\n@hookimpl\ndef layoutkit_formats(): raise KeyError('lost')",
        "LK403",
        "fails in layoutkit_formats: KeyError: 'lost'",
    ),
    "raises late": (
        "from layoutkit.hooks import hookimpl\n@hookimpl\ndef layoutkit_formats():\n yield from [1 / 0]",
        "LK403",
        "ZeroDivisionError",
    ),
    "none": (
        "from layoutkit.hooks import hookimpl\n@hookimpl\ndef layoutkit_stages(): pass",
        "LK404",
        "returns nothing from layoutkit_stages",
    ),
    "no list": (
        "from layoutkit.hooks import hookimpl\n@hookimpl\ndef layoutkit_stages(): return 3",
        "LK403",
        "TypeError",
    ),
    "no format": (
        "from layoutkit.hooks import hookimpl\n@hookimpl\ndef layoutkit_formats(): return ['cmp']",
        "LK404",
        "'cmp' is no instance of Format",
    ),
    "class for instance": (
        "from layoutkit.hooks import Stage, hookimpl\n@hookimpl\ndef layoutkit_stages(): return [Stage]",
        "LK404",
        "is no instance of Stage",
    ),
    "no backend": (
        "from layoutkit.hooks import hookimpl\n@hookimpl\ndef layoutkit_qp_backends(): return [1]",
        "LK404",
        "1 is no instance of Backend",
    ),
    "unchecked constraint": (
        """
        from dataclasses import dataclass
        from layoutkit.constraints import Constraint
        from layoutkit.hooks import hookimpl
        @dataclass(frozen=True, kw_only=True)
        class Lazy(Constraint):
            kind = "lazy"
            summary = "Does nothing."
        @hookimpl
        def layoutkit_constraints(): return [Lazy]
        """,
        "LK404",
        "Lazy has no violations(): nothing would check it",
    ),
    "undeclared attribute": (
        """
        from dataclasses import dataclass
        from layoutkit.constraints import Constraint
        from layoutkit.hooks import hookimpl
        @dataclass(frozen=True, kw_only=True)
        class Bare(Constraint):
            kind = "bare"
            summary = "Has an attribute that documents cannot hold."
            extra: int = 3
            def violations(self, view): return iter(())
        @hookimpl
        def layoutkit_constraints(): return [Bare]
        """,
        "LK404",
        "Bare.extra is not declared",
    ),
    "mutable constraint": (
        """
        from layoutkit.constraints import Constraint
        from layoutkit.hooks import hookimpl
        class Loose(Constraint):
            kind = "loose"
            summary = "Is no dataclass."
            def violations(self, view): return iter(())
        @hookimpl
        def layoutkit_constraints(): return [Loose]
        """,
        "LK404",
        "Loose is no frozen dataclass",
    ),
    "bad name": (FORMAT.replace('"toy"', '"To y"'), "LK404", "'To y', not a name"),
    "no summary": (FORMAT.replace("summary =", "other ="), "LK404", "Toy.summary is missing"),
    "bare options": (
        """
        from dataclasses import dataclass
        from layoutkit.hooks import Stage, hookimpl
        @dataclass(frozen=True)
        class Options:
            count: int
        class Stuck(Stage):
            name = "stuck"
            summary = "Has an option without a default."
            options = Options
            def run(self, facade, options): return iter(())
        @hookimpl
        def layoutkit_stages(): return [Stuck()]
        """,
        "LK404",
        "Options.count has no default",
    ),
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_plugin_is_named_and_skipped(name: str, install: Any) -> None:
    source, code, told = BROKEN[name]
    install("broken", source)
    install("toys", FORMAT, package="good-plugin", version="3.0")
    host = Host.load()
    everything(host)
    assert codes(host) == [code]
    (diagnostic,) = host.diagnostics
    assert "plugin 'broken' of acme-plugin 1.2" in diagnostic.message
    assert told in diagnostic.message
    assert diagnostic.severity is Severity.WARNING
    assert "toy" in host.formats, "the good plugin still works"
    assert list(host.backends) == ["daqp", "clarabel"]


@pytest.mark.parametrize("name", BROKEN)
def test_strict_makes_a_broken_plugin_an_error(name: str, install: Any) -> None:
    source, code, _ = BROKEN[name]
    install("broken", source)
    with pytest.raises(Faulty) as raised:
        everything(Host.load(Severity.ERROR))
    assert [(d.code, d.severity) for d in raised.value.diagnostics] == [(code, Severity.ERROR)]


def test_a_misspelt_hook_is_told_the_nearest_one(install: Any) -> None:
    install("broken", BROKEN["misspelt"][0])
    (diagnostic,) = Host.load().diagnostics
    assert diagnostic.hint == "did you mean 'layoutkit_stages'?"


def test_a_clash_of_names_is_reported_and_the_first_is_kept(install: Any) -> None:
    install("alpha", FORMAT, package="alpha", version="1")
    install("beta", FORMAT, package="beta", version="2")
    host = Host.load()
    assert type(host.formats["toy"]).__module__ == "alpha"
    (diagnostic,) = host.diagnostics
    assert diagnostic.code == "LK405"
    assert "plugin 'beta' of beta 2 adds the format 'toy'" in diagnostic.message
    assert "plugin 'alpha' of alpha 1" in diagnostic.message
    assert host.added_by("beta")["formats"] == ()


def test_built_in_names_cannot_be_taken(install: Any) -> None:
    source = """
        from layoutkit.constraints import Size
        from layoutkit.hooks import hookimpl
        @hookimpl
        def layoutkit_constraints(): return [Size]
    """
    install("greedy", source, plugin="builtin")
    install("sly", source, package="sly", version="1")
    host = Host.load()
    assert [d.code for d in host.diagnostics] == ["LK405"], "the plugin's own name"
    assert list(host.constraints.values()) == list(BUILT_IN)
    assert codes(host) == ["LK405", "LK405"]


def test_one_module_under_two_names_is_loaded_once(install: Any) -> None:
    install("toys", FORMAT)
    install("toys", FORMAT, package="other", version="1", plugin="again")
    host = Host.load()
    assert codes(host) == ["LK405"]
    assert "toy" in host.formats


def test_disabled_plugins_are_not_imported(install: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    install("broken", "raise SystemExit('imported')")
    monkeypatch.setenv("LAYOUTKIT_DISABLE_PLUGINS", " broken , ")
    host = Host.load()
    assert host.diagnostics == ()
    assert "broken" not in host.origins


def test_a_disabled_name_that_is_none_is_reported(install: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    install("toys", FORMAT)
    monkeypatch.setenv("LAYOUTKIT_DISABLE_PLUGINS", "toy")
    host = Host.load()
    assert codes(host) == ["LK408"]
    assert host.diagnostics[0].hint == "did you mean 'toys'?"


def test_an_unknown_name_suggests_the_nearest(install: Any) -> None:
    install("toys", FORMAT)
    with pytest.raises(Faulty) as raised:
        Host.load().formats.find("toi")
    (diagnostic,) = raised.value.diagnostics
    assert (diagnostic.code, diagnostic.hint) == ("LK406", "did you mean 'toy'?")


def test_an_unknown_name_also_names_the_plugins_that_failed(install: Any) -> None:
    install("broken", "import a_module_that_is_not_there")
    with pytest.raises(Faulty) as raised:
        Host.load(points=None).stages.find("whatever")
    assert [d.code for d in raised.value.diagnostics] == ["LK401", "LK406"]
    assert all(d.severity is Severity.ERROR for d in raised.value.diagnostics)


def test_each_hook_is_called_once_and_only_when_it_is_needed(install: Any) -> None:
    install(
        "counting",
        """
        from layoutkit.hooks import hookimpl
        calls = []
        @hookimpl
        def layoutkit_formats():
            calls.append("formats")
            return []
        @hookimpl
        def layoutkit_stages():
            calls.append("stages")
            return []
        """,
    )
    host = Host.load()
    calls = sys.modules["counting"].calls
    assert calls == []
    assert "x" not in host.formats
    assert "x" not in host.formats
    assert calls == ["formats"]


def test_looking_up_constraints_imports_nothing_heavy() -> None:
    program = (
        "import sys; from layoutkit.hooks.host import Host; Host.load().constraints;"
        "print([m for m in ('numpy', 'scipy', 'lxml', 'PIL', 'rich') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
