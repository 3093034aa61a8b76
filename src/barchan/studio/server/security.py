"""Who may talk to the server: the token, the host, the origin, and how much at once."""

import re
import secrets
import time
from dataclasses import dataclass, field
from urllib.parse import urlsplit

from starlette.datastructures import Headers, QueryParams

LOOPBACK = ("127.0.0.1", "localhost", "::1")

MESSAGES_PER_SECOND = 400.0
MESSAGES_AT_ONCE = 800.0

LARGEST_UPLOAD = 64 << 20
"""Bytes of an uploaded file."""

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,99}")


@dataclass(frozen=True)
class Guard:
    """What a request must show."""

    port: int
    hosts: tuple[str, ...] = LOOPBACK
    """Names under which the server is addressed."""
    token: str = field(default_factory=lambda: secrets.token_urlsafe(24))

    def addressed(self, headers: Headers) -> bool:
        """Whether the request names this server, so that no foreign name was bound to its address."""
        return self._ours(f"http://{headers.get('host', '')}")

    def may_act(self, headers: Headers, query: QueryParams) -> bool:
        """Whether the request shows the token and does not come from another site's page."""
        given = headers.get("x-barchan-token") or query.get("token", "")
        origin = headers.get("origin")
        return secrets.compare_digest(given.encode(), self.token.encode()) and (
            origin is None or self._ours(origin)
        )

    def _ours(self, address: str) -> bool:
        try:
            parts = urlsplit(address)
            return parts.scheme == "http" and parts.hostname in self.hosts and (parts.port or 80) == self.port
        except ValueError:
            return False


class Valve:
    """Lets through so many messages a second, a burst now and then."""

    def __init__(self) -> None:
        """Wide open."""
        self._left = MESSAGES_AT_ONCE
        self._since = time.monotonic()

    def passes(self) -> bool:
        """Whether one more message may pass now."""
        now = time.monotonic()
        self._left = min(MESSAGES_AT_ONCE, self._left + (now - self._since) * MESSAGES_PER_SECOND)
        self._since = now
        self._left -= 1.0
        return self._left >= 0.0


def is_plain_name(name: str) -> bool:
    """Whether a name can only mean a file or folder beside its fellows."""
    return _NAME.fullmatch(name) is not None and ".." not in name
