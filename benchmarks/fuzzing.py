"""Documents damaged at random are checked: each gives diagnostics or nothing, soon, and in little memory.

    python -m benchmarks.fuzzing [--documents 100000] [--seed 0] [--processes 2] [--semantics] [--json FILE]
    python -m benchmarks.fuzzing --seed 0 --only 4711 -o damaged.xml    # one of them, to look at

Our own designs, layouts, grids and edits of them, masses, and constraints of plugins are damaged in
structure, values and bytes (`benchmarks.mutations`). A document counts as failed if the check raises
anything, calls one of its own kinds of constraint broken, takes more than `SECONDS` of the processor (on a
busy machine all takes long), or if the process needs more than `MEGABYTES` for it.
With --semantics, what is left of a facade also goes through the stage `audit`, as in `layoutkit validate`.
"""

from __future__ import annotations

import argparse
import faulthandler
import json
import multiprocessing
import signal
import sys
import time
import traceback
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from types import FrameType

import numpy as np

from benchmarks.designs import DESIGNS
from benchmarks.memory import Peak
from benchmarks.mutations import mutated
from layoutkit.cli.checking import everything
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic
from layoutkit.diagnostics.codes import CODES
from layoutkit.documents import (
    Source,
    check,
    facade_bytes,
    layout_bytes,
    read,
    session_bytes,
    with_grids,
)
from layoutkit.hooks.host import Host
from layoutkit.model import Drag, Edit, Facade, Grid, Layout, RegionSet, RegionSize, Resize
from layoutkit.model import Session as Edits

FACADES = Path(__file__).resolve().parents[1] / "facades"
SECONDS = 5.0
MEGABYTES = 500.0
#: Codes that say that the program is at fault, or a plugin; with our own kinds it is always the program.
_OURS = ("LK407", "LK901")
_PLUGIN = '<golden:ratio xmlns:golden="urn:golden:1" of="Facade" width="1.618"/>'


class TooLong(BaseException):
    """Raised in the middle of a check; nothing that handles errors of plugins takes it for one."""


@dataclass(frozen=True)
class Trial:
    """How the check of one document went.

    Attributes
    ----------
    index
        Its number; with the seed it makes the document again.
    codes
        Of the diagnostics.
    failure
        What should not be; empty if all is well.
    """

    index: int
    origin: str
    size: int
    seconds: float
    megabytes: float
    codes: tuple[str, ...]
    failure: str = ""


@cache
def originals() -> Mapping[str, Source]:
    """Return the documents that are damaged, by name; others are found beside them."""
    found, kinds = {}, Host.load().constraints
    for path in sorted(FACADES.glob("*/*.xml")):
        name = f"{path.parent.name}/{path.stem}"
        beside = str(path.with_name("fuzzed.xml"))
        source = path.read_bytes()
        found[name] = Source(beside, source)
        if path.stem == "facade":
            facade = read(path, kinds).model
            layout = Layout("l", facade.units, facade.root, facade_file=path.name)
            found[f"{path.parent.name}/layout"] = Source(beside, layout_bytes(layout))
            plugin = source.replace(b"</constraints>", f"{_PLUGIN}</constraints>".encode())
            found[f"{path.parent.name}/plugin"] = Source(beside, plugin)
            found[f"{path.parent.name}/grids"] = Source(beside, with_grids(source, _grids(facade)))
            found[f"{path.parent.name}/session"] = Source(beside, session_bytes(_session_of(path.name)))
    for name, design in DESIGNS.items():
        found[name] = Source(str(FACADES / "fuzzed.xml"), facade_bytes(design()))
    return found


def _grids(facade: Facade) -> tuple[Grid, ...]:
    """Return a grid of each form: the regions of which there are most."""
    most = max(facade.places, key=lambda path: len(facade.places[path]))
    elements = tuple(placed.path for placed in facade.places[most])
    return Grid("set", RegionSet(most)), Grid("paths", None, elements)


def _session_of(file: str) -> Edits:
    """Return edits of every form."""
    done = (
        Edit("add", "columns", ("set", "paths"), (2, 1), (3, 1), width=12.5),
        Edit("move", "rows", ("set",), to=(1,), element="Facade/Floor.2/Bay"),
        Drag("Facade/Floor", "top", -3.5),
    )
    undone = (Edit("remove", "rows", ("set",), (1,)), Resize(12.0), RegionSize("Facade/Floor", None, 3.0))
    return Edits("edits", file, done, undone)


def document(seed: int, index: int, most: int = sys.maxsize) -> tuple[str, Source]:
    """Return one damaged document, and the name of what it was: one of no more than `most` bytes."""
    generator = np.random.default_rng([seed, index])
    names = [name for name, source in originals().items() if len(source.data or b"") <= most]
    name = names[int(generator.integers(len(names)))]
    original = originals()[name]
    assert original.data is not None
    return name, Source(original.file, mutated(original.data, generator))


def trial(seed: int, index: int, host: Host, semantics: bool = False, most: int = sys.maxsize) -> Trial:
    """Check one document."""
    name, source = document(seed, index, most)
    failure, found = "", list[Diagnostic]()
    peak, start = Peak(), time.process_time()
    signal.signal(signal.SIGPROF, _stop)
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        found = list(everything(source, _session()) if semantics else check(source, host.constraints))
    except TooLong:
        failure = f"took more than {SECONDS:g} s"
    except Exception:  # whatever is raised is the failure that is looked for
        failure = traceback.format_exc()
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    seconds, megabytes = time.process_time() - start, peak.megabytes()
    failure = failure or fault_of(found)
    if megabytes > MEGABYTES:
        failure = failure or f"took more than {MEGABYTES:g} MB"
    if seconds > SECONDS:
        failure = failure or f"took {seconds:.1f} s"
    codes = tuple(d.code for d in found)
    return Trial(index, name, len(source.data or b""), seconds, megabytes, codes, failure)


def fault_of(found: Sequence[Diagnostic]) -> str:
    """Say what is wrong with diagnostics; empty if nothing is."""
    for diagnostic in found:
        if diagnostic.code not in CODES:
            return f"{diagnostic.code} is no code"
        if diagnostic.code in _OURS:
            return str(diagnostic)
        if diagnostic.place is None or not diagnostic.message:
            return f"without a place or message: {diagnostic}"
        json.dumps(diagnostic.as_dict(), allow_nan=False)
        str(diagnostic).encode()
    return ""


def main() -> int:
    parser = argparse.ArgumentParser(description="checks documents that were damaged at random")
    parser.add_argument("--documents", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--semantics", action="store_true", help="run the stage `audit`, too")
    parser.add_argument("--only", type=int, help="check the document of this number alone")
    parser.add_argument("-o", "--output", type=Path, help="write that document to this file")
    parser.add_argument("--json", type=Path, help="write failures and figures to this file")
    arguments = parser.parse_args()
    if arguments.output:
        arguments.output.write_bytes(document(arguments.seed, arguments.only or 0)[1].data or b"")
    numbers = [arguments.only] if arguments.only is not None else range(arguments.documents)
    start = time.perf_counter()
    trials = list(_all(arguments.seed, numbers, arguments.processes, arguments.semantics))
    report = summary(trials, time.perf_counter() - start)
    print("\n".join(report))
    if arguments.json:
        failed = [asdict(t) for t in trials if t.failure]
        arguments.json.write_text(json.dumps({"report": report, "failed": failed}, indent=1) + "\n")
    return 1 if any(t.failure for t in trials) else 0


def _all(seed: int, numbers: Sequence[int], processes: int, semantics: bool) -> Iterator[Trial]:
    if len(numbers) == 1:
        yield _checked((seed, numbers[0], semantics))
        return
    with multiprocessing.Pool(processes, _host, maxtasksperchild=5000) as pool:
        tasks = ((seed, number, semantics) for number in numbers)
        for count, found in enumerate(pool.imap(_checked, tasks, chunksize=100), 1):
            if found.failure:
                print(f"document {found.index} of {found.origin}: {found.failure}", flush=True)
            if count % 5000 == 0:
                print(f"{count:,} documents", file=sys.stderr, flush=True)
            yield found


def _stop(number: int, frame: FrameType | None) -> None:
    raise TooLong


@cache
def _host() -> Host:
    return Host.load()


@cache
def _session() -> Session:
    return Session()


def _checked(task: tuple[int, int, bool]) -> Trial:
    faulthandler.dump_traceback_later(60 * SECONDS, exit=True)  # a hang that no signal ends
    try:
        return trial(task[0], task[1], _host(), task[2])
    finally:
        faulthandler.cancel_dump_traceback_later()


def summary(trials: Sequence[Trial], seconds: float) -> list[str]:
    """Return the lines of the report."""
    slowest = max(trials, key=lambda t: t.seconds)
    largest = max(trials, key=lambda t: t.megabytes)
    times = np.array([t.seconds for t in trials])
    codes: Counter[str] = Counter(code for t in trials for code in set(t.codes))
    sound = sum(not t.codes for t in trials)
    failed = [t for t in trials if t.failure]
    return [
        f"{len(trials):,} documents in {seconds:.0f} s: {len(failed)} failed, {sound:,} had no fault",
        f"time: mean {1000 * times.mean():.1f} ms, 99 % within {1000 * np.quantile(times, 0.99):.1f} ms, "
        f"longest {slowest.seconds:.2f} s (document {slowest.index}, {slowest.size:,} bytes)",
        f"memory of the process: at most {largest.megabytes:.0f} MB (document {largest.index})",
        f"{len(codes)} codes: " + ", ".join(f"{code} {count}" for code, count in sorted(codes.items())),
    ]


if __name__ == "__main__":
    sys.exit(main())
