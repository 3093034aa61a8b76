"""Where members run: processes of this machine, a Dask cluster, or any executor of ``concurrent.futures``.

Loads nothing heavy: a new process sets its number of threads here before numerical libraries are loaded.
"""

import os
from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from barchan.errors import BarchanError

MISSING_DASK = "--scheduler needs Dask's distributed; install it with: python -m pip install distributed"

THREAD_VARIABLES = ("BARCHAN_THREADS", "NUMBA_NUM_THREADS", "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")

PATIENCE = 10.0
"""Seconds to wait for a scheduler to answer."""


@dataclass(frozen=True)
class Workers:
    """Workers for members."""

    open: Callable[[], Executor]
    """Makes an executor; called again where workers died and took it with them."""
    count: int
    """Members that run at the same time."""
    name: str
    replaceable: bool = True
    """Whether ``open`` makes a new executor each time."""
    close: Callable[[], None] = lambda: None

    def __repr__(self) -> str:
        return f"<Workers: {self.name}>"


def given(executor: Executor, count: int | None = None) -> Workers:
    """An executor that the caller keeps; it takes ``count`` members at once, or one for each worker."""
    number = count or getattr(executor, "_max_workers", None) or os.cpu_count() or 1
    return Workers(lambda: executor, int(number), type(executor).__name__, replaceable=False)


def processes(count: int | None = None) -> Workers:
    """Processes of this machine, each with one thread; as many as cores without ``count``."""
    number = count or _cores()
    if number < 1:
        raise BarchanError(f"--workers {number}: allowed: 1 or more")
    return Workers(lambda: _pool(number), number, f"{number} process{'es' * (number > 1)}")


def _pool(number: int) -> Executor:
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    return ProcessPoolExecutor(number, get_context("spawn"), _begin)


def _begin() -> None:
    """Prepare a new process: one thread, and the wish to stop comes by file rather than by Ctrl-C."""
    import signal

    for name in THREAD_VARIABLES:
        os.environ[name] = "1"
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _cores() -> int:
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


def dask_cluster(address: str) -> Workers:
    """The workers of a Dask cluster by the address of its scheduler, for instance ``tcp://10.0.0.1:8786``.

    Raises BarchanError where distributed is not installed, or nobody answers.
    """
    try:
        distributed: Any = import_module("distributed")
    except ImportError:
        raise BarchanError(MISSING_DASK) from None
    try:
        client = distributed.Client(address, timeout=PATIENCE, set_as_default=False)
        threads = sum(client.nthreads().values())
    except (OSError, ValueError, TimeoutError) as error:
        raise BarchanError(f"--scheduler {address}: no answer ({error}); is the scheduler running?") from None
    if not threads:
        client.close()
        raise BarchanError(f"--scheduler {address}: the cluster has no workers yet; start some first")
    return Workers(
        lambda: client.get_executor(pure=False, retries=0),
        2 * threads,
        f"Dask at {address}, {threads} threads",
        replaceable=False,
        close=client.close,
    )
