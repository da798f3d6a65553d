"""Another process that is asked the same: ``python -m layoutkit.testing.witness``, its orders on stdin.

It gets what to ask as JSON, and answers with what `testimony` tells of each document, read anew: of the
facade itself, and of a larger one.
"""

from __future__ import annotations

import importlib
import importlib.util
import json
import os
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from layoutkit.testing.subjects import Kind, Subject, grown, own_constraints, read_facade
from layoutkit.testing.testimony import samples_of, testimony

#: What was asked (the number of a document, and whether its facade was grown), and what was told.
Told = dict[tuple[int, bool], tuple[str, ...]]
#: A witness answers within seconds, or not at all.
_PATIENCE = 120.0


class Silent(Exception):  # noqa: N818 - it says what the matter is
    """A witness could not answer."""


def asked(subjects: Sequence[Subject]) -> list[tuple[int, bool]]:
    """Return what is asked of some subjects, in order."""
    return [(number, larger) for number in range(len(subjects)) for larger in (False, True)]


def hear(subject: Subject, larger: bool) -> tuple[str, ...]:
    """Return what this process tells of a subject, read anew."""
    facade = read_facade(subject.text, subject.name, subject.kind)
    if larger:
        facade = grown(facade, facade.constraints)
    return testimony(facade, own_constraints(facade, subject.kind), samples_of(facade))


def witnesses(
    subjects: Sequence[Subject], orders: Sequence[Sequence[tuple[int, bool]]], seeds: Sequence[int]
) -> Iterator[Told]:
    """Yield what other processes tell, all at work at the same time.

    Parameters
    ----------
    orders
        For each process, what it is asked, in order.
    seeds
        For each, what its hashes of texts begin with.

    Raises
    ------
    Silent
        If one fails.
    """
    started = [_started(subjects, order, seed) for order, seed in zip(orders, seeds, strict=True)]
    try:
        for process, given in started:
            out, err = process.communicate(given, timeout=_PATIENCE)
            if process.returncode:
                raise Silent(err.strip().splitlines()[-1] if err.strip() else "it ended without a word")
            yield {(n, larger): tuple(lines) for n, larger, lines in json.loads(out)}
    except subprocess.TimeoutExpired:
        raise Silent(f"it did not come to an end in {_PATIENCE:g} seconds") from None
    finally:
        for process, _ in started:
            process.kill()
            process.wait()
            for pipe in (process.stdin, process.stdout, process.stderr):
                if pipe is not None:
                    pipe.close()


def _started(
    subjects: Sequence[Subject], order: Sequence[tuple[int, bool]], seed: int
) -> tuple[subprocess.Popen[str], str]:
    kind = subjects[0].kind
    given = {
        "module": kind.__module__,
        "name": kind.__qualname__,
        "file": getattr(sys.modules.get(kind.__module__), "__file__", None),
        "path": sys.path,
        "documents": [[subject.name, subject.text] for subject in subjects],
        "order": order,
    }
    process = subprocess.Popen(
        [sys.executable, "-c", "from layoutkit.testing.witness import main; main()"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        encoding="utf-8",
        env={
            **os.environ,
            "PYTHONHASHSEED": str(seed),
            "PYTHONIOENCODING": "utf-8",
            "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
        },
    )
    return process, json.dumps(given)


def main() -> None:
    """Answer what is asked on stdin."""
    given: Mapping[str, Any] = json.load(sys.stdin)
    sys.path[:] = given["path"]
    kind = _kind(given["module"], given["name"], given["file"])
    subjects = [Subject(kind, name, text) for name, text in given["documents"]]
    told = [(n, larger, hear(subjects[n], larger)) for n, larger in given["order"]]
    json.dump(told, sys.stdout)


def _kind(module: str, name: str, file: str | None) -> Kind:
    try:
        found: Any = importlib.import_module(module)
    except ImportError:
        if file is None:
            raise
        spec = importlib.util.spec_from_file_location(module, file)
        if spec is None or spec.loader is None:
            raise
        found = importlib.util.module_from_spec(spec)
        sys.modules[module] = found
        spec.loader.exec_module(found)
    for part in name.split("."):
        found = getattr(found, part)
    kind: Kind = found
    return kind
