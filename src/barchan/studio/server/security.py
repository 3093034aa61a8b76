"""Who may use the server: the tokens, the host, the origin, and the rate of messages."""

import re
import secrets
import time
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import urlsplit

from starlette.datastructures import Headers, QueryParams
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Receive, Scope, Send

LOOPBACK = ("127.0.0.1", "localhost", "::1")

EVERYWHERE = ("0.0.0.0", "::")  # noqa: S104 - only compared with
"""Hosts that mean all addresses of this computer."""

MESSAGES_PER_SECOND = 400.0
MESSAGES_AT_ONCE = 800.0

LARGEST_UPLOAD = 64 << 20
"""Bytes of an uploaded file."""

HEADERS = {  # {host} is the name and port that the page was asked for under
    "Content-Security-Policy": "default-src 'self'; img-src 'self' data: blob:; "
    "style-src 'self' 'unsafe-inline'; connect-src 'self' ws://{host}; frame-ancestors 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "Cache-Control": "no-store",
}

RESERVED = {"studio-uploads", "studio-exports", "con", "prn", "aux", "nul"} | {
    f"{d}{n}" for d in ("com", "lpt") for n in range(1, 10)
}
"""Names that no run may have, in any case and with any suffix: the studio's folders, devices of Windows."""

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,99}")


@dataclass(frozen=True)
class Guard:
    """The port, host and token that a request must show."""

    port: int
    hosts: tuple[str, ...] = LOOPBACK
    """Names under which the server is reached."""
    token: str = field(default_factory=lambda: secrets.token_urlsafe(24))
    """What the browser shows that commands."""
    watch_token: str = field(default_factory=lambda: secrets.token_urlsafe(24))
    """What browsers show that only watch: drawn apart, so that nobody comes from it to the other one."""

    def is_addressed(self, headers: Headers) -> bool:
        """Whether the request names this server, so that no foreign name was bound to its address."""
        return self._ours(f"http://{headers.get('host', '')}")

    def may_act(self, headers: Headers, query: QueryParams) -> bool:
        """Whether the request shows the token and does not come from another site's page."""
        return self.knows_token(headers, query) and self.is_own_page(headers)

    def may_look(self, headers: Headers, query: QueryParams) -> bool:
        """Whether the request shows one of both tokens and does not come from another site's page."""
        known = self.knows_token(headers, query) or self.knows_watch_token(headers, query)
        return known and self.is_own_page(headers)

    def knows_token(self, headers: Headers, query: QueryParams) -> bool:
        """Whether the request shows the token of the browser that commands."""
        return _shows(headers, query, self.token)

    def knows_watch_token(self, headers: Headers, query: QueryParams) -> bool:
        """Whether the request shows the token of those that only watch."""
        return _shows(headers, query, self.watch_token)

    def for_watchers(self) -> dict[str, Any]:
        """The token of those that only watch, and the addresses under which other computers reach the server.

        There are none where it serves this computer only.
        """
        others = sorted(host for host in self.hosts if host not in (*LOOPBACK, *EVERYWHERE))
        return {"token": self.watch_token, "addresses": [self.address(host) for host in others]}

    def address(self, host: str) -> str:
        """The address of the server under a name of it."""
        return f"http://{f'[{host}]' if ':' in host else host}:{self.port}"

    def is_own_page(self, headers: Headers) -> bool:
        """Whether the request comes from this server's page, or from no page at all."""
        origin = headers.get("origin")
        return origin is None or self._ours(origin)

    def _ours(self, address: str) -> bool:
        try:
            parts = urlsplit(address)
            return parts.scheme == "http" and parts.hostname in self.hosts and (parts.port or 80) == self.port
        except ValueError:
            return False


def _shows(headers: Headers, query: QueryParams, token: str) -> bool:
    given = headers.get("x-barchan-token") or query.get("token", "")
    return secrets.compare_digest(given.encode(), token.encode())


class RateLimiter:
    """Lets a number of messages per second pass, and a burst now and then."""

    def __init__(self) -> None:
        """Allow a whole burst at first."""
        self._left = MESSAGES_AT_ONCE
        self._since = time.monotonic()

    def allows(self) -> bool:
        """Whether one more message may pass now; it is counted."""
        now = time.monotonic()
        self._left = min(MESSAGES_AT_ONCE, self._left + (now - self._since) * MESSAGES_PER_SECOND)
        self._since = now
        self._left -= 1.0
        return self._left >= 0.0


class HostCheck:
    """Middleware that refuses requests to other hosts' names, and adds headers that keep pages apart."""

    def __init__(self, app: ASGIApp, guard: Guard) -> None:
        """Stand before an application."""
        self.app = app
        self.guard = guard

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        if not self.guard.is_addressed(headers):
            await PlainTextResponse("not this server's name\n", 421)(scope, receive, send)
            return

        async def with_headers(answer: Any) -> None:
            if answer["type"] == "http.response.start":
                own = {name: value.format(host=headers["host"]) for name, value in HEADERS.items()}
                extra = [(name.lower().encode(), value.encode()) for name, value in own.items()]
                answer["headers"] = [*answer.get("headers", []), *extra]
            await send(answer)

        await self.app(scope, receive, with_headers)


def is_plain_name(name: str) -> bool:
    """Whether a name can only mean a file or folder beside its fellows."""
    return _NAME.fullmatch(name) is not None and ".." not in name and not name.endswith(".")


def is_reserved(name: str) -> bool:
    """Whether a name means something else than a run of the user's."""
    return name.lower() in RESERVED or name.lower().split(".")[0] in RESERVED
