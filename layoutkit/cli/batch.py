"""``layoutkit batch``: variations of many facades, at many sizes, from many seeds."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli.batching import (
    FIRST_SEED,
    Afresh,
    Scheduler,
    SeedList,
    Seeds,
    Workers,
    carried_out,
    plugins_of,
    runner_of,
)
from layoutkit.cli.options import Json, finite, read_size
from layoutkit.cli.relocation import picture_file
from layoutkit.cli.remote import options_of
from layoutkit.cli.results import FACADE_FILE
from layoutkit.cli.session import Session
from layoutkit.cli.vary import Sampling
from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.model import Measure

if TYPE_CHECKING:
    from layoutkit.batch import Plan, Shared, Task

EXAMPLES = """
Examples:

- `layoutkit batch house.xml --width 10,12,14 --seeds 0-9 -n 4 -o out`

- `layoutkit batch facades/*.xml --seeds 0-99 -n 1 --workers 8 -o out`

- `layoutkit batch facades/*.xml --seeds 0-99 -n 1 --scheduler tcp://10.0.0.1:8786 -o out`
"""


@dataclass(frozen=True)
class Sizes:
    """Sizes as a user lists them."""

    measures: tuple[Measure, ...]

    @classmethod
    def parse(cls, text: str) -> Sizes:
        """Read sizes, separated by commas: ``10,12,120%``; each counts once.

        Raises
        ------
        typer.BadParameter
            If one is none.
        """
        return cls(tuple(dict.fromkeys(read_size(part.strip()) for part in text.split(","))))

    def __str__(self) -> str:
        return ",".join(map(str, self.measures))


def read_sizes(text: str | Sizes) -> Sizes:
    """Read sizes; typer also hands defaults in."""
    return text if isinstance(text, Sizes) else Sizes.parse(text)


SizeList = Annotated[
    Sizes,
    typer.Option(
        parser=read_sizes,
        metavar="SIZES",
        show_default="100%",
        help="Numbers in the documents' units, or percentages of the inputs' sizes, such as 10,12,120%.",
    ),
]
#: Bytes of a file's name that are no text, as Python has them.
_UNREADABLE = re.compile("[\udc80-\udcff]")
_AS_IS = Sizes((Measure(1.0, relative=True),))


def batch(
    context: typer.Context,
    facade_files: Annotated[list[Path], typer.Argument(metavar="FACADE", help="Facade documents (XML).")],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="The folder for results.")],
    width: SizeList = _AS_IS,
    height: SizeList = _AS_IS,
    seeds: SeedList = FIRST_SEED,
    count: Annotated[int, typer.Option("-n", "--count", min=1, help="How many variations of each.")] = 8,
    sampling: Annotated[
        Sampling, typer.Option(metavar="WAY", help="Which arrangements, as in `layoutkit vary`.")
    ] = Sampling.weighted,
    node_limit: Annotated[
        int | None,
        typer.Option(min=1, show_default=False, help="Words tried for one variation before giving up."),
    ] = None,
    pictures: Annotated[
        bool, typer.Option("--picture/--no-picture", help="Whether each variation gets a picture.")
    ] = True,
    scale: Annotated[
        float,
        typer.Option(
            min=0.01, max=100, callback=finite, help="Size of the pictures, as a multiple of the photo's own."
        ),
    ] = 1.0,
    workers: Workers = None,
    scheduler: Scheduler = None,
    afresh: Afresh = False,
    as_json: Json = False,
) -> int:
    """Make variations of many facades, at many sizes, from many seeds.

    Every facade is varied at every width and height from every seed, as `layoutkit vary` does it, into a
    folder of its own: DIR/house/w12-h100pct-s3/variation-01.xml. DIR/manifest.json lists all. The bytes are
    the same whoever does the work: this process, several, or a cluster.

    The same command goes on where it was interrupted. A task that fails is listed, and does not stop others.

    Exit code 0: all is done. Else that of the gravest failure: 1 faults, 3 proved that there are no (more)
    variations, 4 the search gave up at a limit.
    """
    session = Session.of(context)
    options = {
        "count": count,
        "asked": _asked(sampling, node_limit),
        "pictures": pictures,
        "scale": scale,
        "session": options_of(session),
    }
    runner = runner_of(session, workers, scheduler)
    _load_plugins(session)
    files = list(dict.fromkeys(facade_files))
    plan = _plan(dict(zip(names_of(files), files, strict=True)), width, height, seeds, options, session)
    _refuse_own_inputs(plan.tasks, files, output)
    return carried_out(session, plan, output, runner, afresh=afresh, as_json=as_json)


def names_of(files: Sequence[Path]) -> Iterator[str]:
    """Yield a name for the results of each facade: no two the same, whatever the case of letters.

    It is the file's own, without the suffix; or that of its folder, if the file is called facade.xml, as in
    samples and results. What has the name of another gets a number.
    """
    taken: set[str] = set()
    for file in files:
        stem = file.resolve().parent.name if file.name == FACADE_FILE else file.stem
        stem = _UNREADABLE.sub("_", stem or file.stem)
        stem = stem if stem.strip(".") else "_"  # else it would be a way to another folder
        number, name = 1, stem
        while name.casefold() in taken:
            number += 1
            name = f"{stem}-{number}"
        taken.add(name.casefold())
        yield name


def _plan(
    files: Mapping[str, Path],
    width: Sizes,
    height: Sizes,
    seeds: Seeds,
    options: dict[str, Any],
    session: Session,
) -> Plan:
    from layoutkit.batch import Plan

    photos = {name: _photo_file(file) for name, file in files.items()}
    tasks = [
        task
        for name, file in files.items()
        for task in _tasks(
            name, file, photos[name], product(width.measures, height.measures, seeds.numbers), options
        )
    ]
    told = {
        "facades": {name: file.as_posix() for name, file in files.items()},
        "widths": [str(measure) for measure in width.measures],
        "heights": [str(measure) for measure in height.measures],
        "seeds": list(seeds.numbers),
        **options,
        "plugins": plugins_of(session),
    }
    copies = {f"{name}/{_photo_name(photo)}": photo for name, photo in photos.items() if photo is not None}
    return Plan("batch", tasks, told, copies)


def _tasks(
    name: str,
    file: Path,
    photo: Path | None,
    cases: Iterator[tuple[Measure, Measure, int]],
    options: Mapping[str, Any],
) -> Iterator[Task]:
    """Yield the tasks of a facade: one for each width, height and seed."""
    from layoutkit.batch import Reread, Task
    from layoutkit.cli.varied import vary_one_size

    named = None if photo is None else f"../{_photo_name(photo)}"
    source = Reread.of(
        partial(_read, file, photo, {**options, "file": str(file), "photo": named}), f"{file} or its picture"
    )
    for width, height, seed in cases:
        key = f"{name}/w{_spelled(width)}-h{_spelled(height)}-s{seed}"
        arguments = {"width": str(width), "height": str(height), "seed": seed}
        yield Task(key, vary_one_size, arguments, source)


def _read(file: Path, photo: Path | None, options: Mapping[str, Any]) -> Shared:
    """Read what the tasks of a facade share.

    Raises
    ------
    Faulty
        If its document cannot be read; a photo that is missing is for the tasks to tell.
    """
    from layoutkit.batch import Shared
    from layoutkit.cli.varied import DOCUMENT, PICTURE
    from layoutkit.documents import load

    files = {DOCUMENT: load(file)}
    if photo is not None and options["pictures"] and photo.is_file():
        files[PICTURE] = load(photo)
    return Shared(files, options)


def _photo_file(file: Path) -> Path | None:
    """Return the photo of a facade; None where it names none, or cannot be read."""
    from layoutkit.documents import load

    try:
        named = picture_file(load(file))
    except Faulty:  # which its tasks tell
        return None
    return None if named is None else file.parent / named


def _photo_name(photo: Path) -> str:
    return f"facade{photo.suffix.lower()}"


def _spelled(measure: Measure) -> str:
    return str(measure).replace("%", "pct")


def _asked(sampling: Sampling, node_limit: int | None) -> dict[str, Any]:
    """Return what is asked of the stage beyond sizes and seeds: by default it needs to know of nothing."""
    asked: dict[str, Any] = {}
    if sampling is not Sampling.weighted:
        asked["sampling"] = str(sampling)
    if node_limit is not None:
        asked["node_limit"] = node_limit
    return asked


def _load_plugins(session: Session) -> None:
    """Load what tasks will need, so that what fails is told once, and here.

    Raises
    ------
    Faulty
        If a stage or solver is missing.
    """
    session.host.stages.find("relayout")
    session.backends  # noqa: B018 - named wrongly, it is told
    session.host.constraints  # noqa: B018
    session.report()


def _refuse_own_inputs(tasks: Sequence[Task], files: Sequence[Path], output: Path) -> None:
    """Raise `Faulty` if the copy of a facade in a folder of results would overwrite an input."""
    copies = {(output / task.key / FACADE_FILE).resolve(): task.key for task in tasks}
    for file in files:
        if (key := copies.get(file.resolve())) is not None:
            message = f"the results' copy of the facade in {key} would overwrite the input {file}"
            place = Place(str(output))
            hint = f"name another folder with -o, such as {output / 'variations'}"
            raise Faulty([Diagnostic("LK704", message, place, hint, topic="usage")])
