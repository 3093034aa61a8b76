"""Answers that are not there yet."""

from collections.abc import Callable
from dataclasses import dataclass

from barchan.studio.protocol import ANSWERED, Request
from barchan.studio.worker.background import Later


@dataclass
class _Owed:
    request: Request
    later: Later
    said: int = -1
    """How much was said to be done."""


class OwedAnswers:
    """Sends answers as soon as they are there, and meanwhile how far they are."""

    def __init__(self, send: Callable[..., None], refuse: Callable[[Request, Exception], None]) -> None:
        """Owe nothing; ``send`` sends messages, ``refuse`` answers with an error."""
        self._send, self._refuse = send, refuse
        self._owed: list[_Owed] = []

    def __len__(self) -> int:
        return len(self._owed)

    def add(self, request: Request, later: Later) -> None:
        """Owe an answer."""
        self._owed.append(_Owed(request, later))

    def break_off(self, request: object) -> None:
        """Break the work on the answer to a request off, by its id."""
        for owed in self._owed:
            if owed.request.get("id") == request:
                owed.later.break_off()

    def pay(self) -> None:
        """Send what is there."""
        self._owed = [owed for owed in self._owed if not self._paid(owed)]

    def _paid(self, owed: _Owed) -> bool:
        given = owed.request.get("id")
        try:
            result = owed.later.result()
        except ANSWERED as error:
            self._refuse(owed.request, error)
            return True
        if given is None:
            return result is not None
        if result is not None:
            self._send("done", id=given, **result)
        elif owed.later.done != owed.said:
            owed.said = owed.later.done
            self._send("progress", id=given, done=owed.later.done, of=owed.later.of)
        return result is not None
