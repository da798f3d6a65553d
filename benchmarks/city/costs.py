"""What Dask and the client cost beyond the work: measured with tasks that do nothing, on loopback."""

from __future__ import annotations

import contextlib
import logging
import time
from collections.abc import Iterator
from typing import TYPE_CHECKING

from benchmarks.city.simulation import Costs
from benchmarks.city.tasks import carried_out, idle
from layoutkit.batch.cluster import Cluster

if TYPE_CHECKING:
    from distributed import Client

#: Workers, and threads of each: so many that there is always a result for the client to take.
_WORKERS, _THREADS = 2, 16


def costs(tasks: int, size: int) -> Costs:
    """Return what tasks cost whose results have so many bytes.

    Scheduler and workers are processes of their own, as on a cluster. What the scheduler needs is the time
    for each of many tasks handed over at once; what the client needs, that between two results which were
    ready before.
    """
    with _cluster() as client:
        scheduler = _scheduled(client, 10 * tasks)
        cluster = Cluster(client.scheduler_info()["address"], _WORKERS)
        carried_out(idle(_WORKERS * _THREADS, 0), cluster)  # so that all is loaded
        empty = _between(tasks, 0, cluster)
        full = _between(tasks, size, cluster)
    return Costs(scheduler, empty, max(0.0, full - empty) / size)


@contextlib.contextmanager
def _cluster() -> Iterator[Client]:
    from distributed import Client
    from distributed.deploy.subprocess import SubprocessCluster

    with (
        SubprocessCluster(
            host="127.0.0.1",
            n_workers=_WORKERS,
            threads_per_worker=_THREADS,
            dashboard_address="127.0.0.1:0",
            silence_logs=logging.CRITICAL,
            scheduler_kwargs={"dashboard": False},
        ) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):
        client.wait_for_workers(_WORKERS)
        yield client


def _scheduled(client: Client, tasks: int) -> float:
    """Return seconds for each of many tasks that give nothing."""
    client.gather(client.map(_nothing, range(100), pure=False))
    start = time.perf_counter()
    client.gather(client.map(_nothing, range(tasks), pure=False))
    return (time.perf_counter() - start) / tasks


def _between(tasks: int, size: int, cluster: Cluster) -> float:
    """Return seconds between two results."""
    return carried_out(idle(tasks, size), cluster).between / (tasks - 1)


def _nothing(_: int) -> None:
    return None
