"""Where the worker's functions are registered under the names of their commands."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from barchan.studio.commands import Handlers
from barchan.studio.protocol import Request
from barchan.studio.worker.background import Later

if TYPE_CHECKING:
    from barchan.studio.worker.commands import RunCommands

Answer = dict[str, Any] | Later | None
"""The content of the answer, where there is any, or what will have it later."""

WORKER: Handlers[Callable[["RunCommands", Request], Answer]] = Handlers("worker")
