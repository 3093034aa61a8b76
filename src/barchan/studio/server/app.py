"""The server: the client's files, what it is told once, uploads, and the line to the session."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, PlainTextResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket, WebSocketDisconnect

from barchan.errors import BarchanError
from barchan.studio.protocol import LARGEST_MESSAGE
from barchan.studio.server import gallery
from barchan.studio.server.security import LARGEST_UPLOAD, Guard, Valve
from barchan.studio.server.session import Session

CLIENT = Path(__file__).parents[1] / "client"

NOT_ALLOWED, REPLACED, TOO_MUCH = 4403, 4001, 4429
"""Why a line is closed."""

HEADERS = {
    "Content-Security-Policy": "default-src 'self'; img-src 'self' data: blob:; "
    "style-src 'self' 'unsafe-inline'; connect-src 'self' ws:; frame-ancestors 'none'",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "Cache-Control": "no-store",
}

Handler = Callable[[Request], Awaitable[Response]]


def application(session: Session, guard: Guard) -> Starlette:
    """The server's application."""

    @asynccontextmanager
    async def living(_: Starlette) -> AsyncIterator[None]:
        session.start()
        try:
            yield
        finally:
            session.close()

    def told(once: Callable[[], Any]) -> Handler:
        async def answer(_: Request) -> Response:
            return JSONResponse(await run_in_threadpool(once))

        return answer

    def guarded(handler: Handler) -> Handler:
        async def answer(request: Request) -> Response:
            if not guard.may_act(request.headers, request.query_params):
                return PlainTextResponse("not allowed: the address lacks the token\n", 403)
            return await handler(request)

        return answer

    async def thumbnail(request: Request) -> Response:
        picture = gallery.thumbnail(request.path_params["name"])
        return Response(picture, media_type="image/webp") if picture else Response(status_code=404)

    async def upload(request: Request) -> Response:
        return await _upload(request, session)

    async def line(websocket: WebSocket) -> None:
        await _line(websocket, session, guard)

    routes = [
        Route("/api/presets", guarded(told(gallery.presets))),
        Route("/api/schema", guarded(told(gallery.schema))),
        Route("/api/colours", guarded(told(gallery.colours))),
        Route("/api/pictures/{name}", guarded(thumbnail)),
        Route("/api/upload", guarded(upload), methods=["POST"]),
        WebSocketRoute("/line", line),
        Mount("/", StaticFiles(directory=CLIENT, html=True, check_dir=False)),
    ]
    app = Starlette(routes=routes, lifespan=living)
    app.add_middleware(_Doorman, guard=guard)
    return app


class _Doorman:
    """Refuses what is not addressed to this server, and adds headers that keep pages apart."""

    def __init__(self, app: ASGIApp, guard: Guard) -> None:
        self.app = app
        self.guard = guard

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        if not self.guard.addressed(Request(scope).headers):
            await PlainTextResponse("not this server's name\n", 421)(scope, receive, send)
            return

        async def with_headers(answer: Any) -> None:
            if answer["type"] == "http.response.start":
                extra = [(name.lower().encode(), value.encode()) for name, value in HEADERS.items()]
                answer["headers"] = [*answer.get("headers", []), *extra]
            await send(answer)

        await self.app(scope, receive, with_headers)


async def _upload(request: Request, session: Session) -> Response:
    """Keep a file of heights in the session's folder."""
    content = bytearray()
    async for part in request.stream():
        content += part
        if len(content) > LARGEST_UPLOAD:
            return JSONResponse({"text": f"more than {LARGEST_UPLOAD >> 20} MB"}, 413)
    try:
        path = session.store.keep(request.query_params.get("name", ""), bytes(content))
    except (BarchanError, OSError) as error:
        return JSONResponse({"text": str(error)}, 400)
    return JSONResponse({"path": str(path), "name": path.name})


async def _line(websocket: WebSocket, session: Session, guard: Guard) -> None:
    """Carry messages between one browser and the session until one of them ends."""
    if not (guard.addressed(websocket.headers) and guard.may_act(websocket.headers, websocket.query_params)):
        await websocket.close(NOT_ALLOWED)
        return
    await websocket.accept()
    outbox = session.attach()
    speaking = asyncio.create_task(_speak(websocket, outbox))
    valve = Valve()
    try:
        while True:
            text = await websocket.receive_text()
            if not valve.passes() or len(text) > LARGEST_MESSAGE:
                await websocket.close(TOO_MUCH)
                return
            session.hear(text)
    except (WebSocketDisconnect, KeyError, RuntimeError):
        pass
    finally:
        session.detach(outbox)
        speaking.cancel()


async def _speak(websocket: WebSocket, outbox: "asyncio.Queue[bytes]") -> None:
    try:
        while True:
            data = await outbox.get()
            if not data:
                await websocket.close(REPLACED)
                return
            if data.startswith(b"{"):
                await websocket.send_text(data.decode())
            else:
                await websocket.send_bytes(data)
    except (WebSocketDisconnect, RuntimeError):
        return
