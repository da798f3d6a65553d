"""Options that the fields of a dataclass declare."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

import pytest
import typer
import typer.main

from layoutkit.cli.declared import declared_by, given


def _told(default: Any, help: str, **more: Any) -> Any:
    return field(default=default, metadata={"help": help, **more})


@dataclass(frozen=True)
class Settings:
    """Of every type that options have."""

    how_far: float = _told(1.5, "How far.")
    turn: float = _told(0.0, "A turn.", least=-90)
    times: int | None = _told(None, "How often.")
    round_about: bool = _told(True, "Whether round about.")
    way: Literal["left", "right"] = _told("left", "Which way.")
    names: tuple[str, ...] = _told((), "What counts.")


Called = list[tuple[Any, ...]]


@pytest.fixture
def called() -> Called:
    return []


@pytest.fixture
def run(called: Called) -> Callable[..., int]:
    app = typer.Typer()

    @app.command()
    @declared_by(Settings, "settings")
    def go(context: typer.Context, place: str, settings: Settings = Settings(), loud: bool = False) -> int:
        called.append((place, settings, loud, given(context, Settings)))
        return 0

    return lambda *arguments: app(list(arguments), standalone_mode=False)


def test_defaults_are_those_of_the_fields(run: Callable[..., int], called: Called) -> None:
    run("here")
    assert called == [("here", Settings(), False, [])]


def test_each_field_is_an_option(run: Callable[..., int], called: Called) -> None:
    run("here", "--how-far", "2", "--turn", "-30", "--times", "3", "--no-round-about", "--way", "right")
    assert called[0][1] == Settings(2.0, -30.0, 3, False, "right")
    assert called[0][3] == ["--how-far", "--turn", "--times", "--round-about", "--way"]
    run("here", "--names", "a", "--names", "b", "--loud")
    assert called[1][1:3] == (Settings(names=("a", "b")), True)


@pytest.mark.parametrize(
    "wrong",
    [("--how-far", "-1"), ("--how-far", "nan"), ("--way", "up"), ("--times", "2.5"), ("--turn", "-91")],
)
def test_what_a_field_cannot_be_is_refused(
    run: Callable[..., int], called: Called, wrong: tuple[str, str]
) -> None:
    with pytest.raises(typer.BadParameter):
        run("here", *wrong)
    assert called == []
