"""Variations of a facade as a task: bytes in, bytes out, wherever it is done."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from layoutkit.batch import Finished, Shared, Task
from layoutkit.cli.relocation import with_picture_file
from layoutkit.cli.remote import RemoteSession
from layoutkit.cli.results import FACADE_FILE, refuse_broken, variation_files, variation_name
from layoutkit.cli.vary import constrained
from layoutkit.diagnostics import Diagnostic, Faulty, blame
from layoutkit.model import Facade, Layout, Measure

if TYPE_CHECKING:
    from layoutkit.hooks import Outcome
    from layoutkit.pictures import Photo

#: Names of the files that tasks of one facade share.
DOCUMENT, PICTURE = "facade", "picture"


def vary_one_size(task: Task, shared: Shared) -> Finished:
    """Make variations of a facade at one size, from one seed: the files that ``vary`` would write.

    Parameters
    ----------
    task
        With `width`, `height` and `seed`; its key is the folder.
    shared
        The facade's document and photo; of the options, `file` is what diagnostics name, `photo` how the
        results name the photo.
    """
    session = _session(shared)
    subject = _subject(shared)
    session.report(subject.remarks)
    made = _Made(task, shared, subject, session)
    try:
        for position, outcome in enumerate(_outcomes(session, subject.facade, task, shared)):
            session.report(outcome.diagnostics)
            made.add(position, outcome)
    except Faulty as faulty:
        session.report(faulty.diagnostics)
    except blame.ANYTHING as error:  # what was made before it is good
        session.report([blame.unforeseen(error)])
    return made.finished()


@dataclass(frozen=True)
class _Subject:
    """A facade, ready to be varied.

    Attributes
    ----------
    source
        Its document for the folder of results, with the constraints that were inferred if it had none.
    remarks
        What there is to say of it.
    """

    facade: Facade
    source: bytes
    photo: Photo | None
    remarks: tuple[Diagnostic, ...]


@dataclass
class _Made:
    """What a task has made so far."""

    task: Task
    shared: Shared
    subject: _Subject
    session: RemoteSession
    files: list[tuple[str, bytes]] = field(default_factory=list)
    variations: list[dict[str, Any]] = field(default_factory=list)

    def add(self, position: int, outcome: Outcome) -> None:
        """Add one variation, or that there is none."""
        layout = outcome.document
        entry: dict[str, Any] = {"index": position, "status": outcome.status}
        if outcome.status == "found" and isinstance(layout, Layout):
            files = self._files_of(layout, position if layout.index is None else layout.index)
            self.files += files
            entry["files"] = [name for name, _ in files]
        self.variations.append(entry)

    def finished(self) -> Finished:
        """Return what came of the task."""
        count, made = self.shared.options["count"], sum("files" in entry for entry in self.variations)
        proved = any(entry["status"] == "infeasible" for entry in self.variations)
        status = "found" if made == count else "infeasible" if proved else "limit"
        if self.files:
            self.files.insert(0, (FACADE_FILE, self.subject.source))
        return Finished(
            self.task.key,
            "done" if status == "found" else "failed",
            tuple((f"{self.task.key}/{name}", data) for name, data in self.files),
            {
                "facade": self.subject.facade.name,
                **self.task.arguments,
                "status": status,
                "variations": self.variations,
            },
            tuple(self.session.diagnostics),
        )

    def _files_of(self, layout: Layout, index: int) -> tuple[tuple[str, bytes], ...]:
        from layoutkit.pictures import render_png

        refuse_broken(layout)
        options = self.shared.options
        image = (
            render_png(layout, self.subject.photo, scale=options["scale"]) if options["pictures"] else None
        )
        name = variation_name(index + 1, max(2, len(str(options["count"]))))
        return variation_files(name, layout, image)


def _outcomes(session: RemoteSession, facade: Facade, task: Task, shared: Shared) -> Iterator[Outcome]:
    arguments, options = task.arguments, shared.options
    asked = {
        "count": options["count"],
        "width": Measure.parse(arguments["width"]),
        "height": Measure.parse(arguments["height"]),
        "seed": arguments["seed"],
        **options["asked"],
    }
    return islice(session.run("relayout", facade, **asked), options["count"])


def _session(shared: Shared) -> RemoteSession:
    file = Path(shared.options["file"])
    return RemoteSession.of_options(shared.options["session"], {file: shared.files[DOCUMENT]})


@lru_cache(maxsize=2)  # tasks of a facade follow each other
def _subject(shared: Shared) -> _Subject:
    session, file = _session(shared), Path(shared.options["file"])
    facade, source = constrained(session, file, "batch")
    photo = shared.options["photo"]
    return _Subject(
        facade,
        source if photo is None else with_picture_file(source, photo),
        _photo(facade, file.parent, shared) if shared.options["pictures"] else None,
        tuple(session.diagnostics),
    )


def _photo(facade: Facade, folder: Path, shared: Shared) -> Photo | None:
    from layoutkit.pictures import Photo

    if facade.picture is None:
        return None
    return Photo.decoded(facade, shared.files.get(PICTURE), folder / facade.picture.file)
