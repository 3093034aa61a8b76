"""The server: the client's files, data that a page requests once, uploads, the session's connection."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import ClientDisconnect, Request
from starlette.responses import FileResponse, JSONResponse, PlainTextResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.websockets import WebSocket, WebSocketDisconnect

from barchan.errors import BarchanError
from barchan.studio.colours import colours
from barchan.studio.protocol import LARGEST_MESSAGE, is_frame
from barchan.studio.server import gallery
from barchan.studio.server.film_routes import film_routes
from barchan.studio.server.security import LARGEST_UPLOAD, Guard, HostCheck, RateLimiter
from barchan.studio.server.session import Session
from barchan.studio.server.uploads import TooLargeError, body_of

CLIENT = Path(__file__).parents[1] / "client"

COMPRESSED_FROM = 1024
"""Bytes of an answer from which it is sent compressed."""

NOT_ALLOWED, REPLACED, TOO_MUCH, FULL = 4403, 4001, 4429, 4503
"""Codes with which a connection is closed."""

Handler = Callable[[Request], Awaitable[Response]]


def application(session: Session, guard: Guard) -> Starlette:
    """The server's application."""

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        session.start()
        try:
            yield
        finally:
            session.close()

    def json_of(content: Callable[[], Any]) -> Handler:
        async def answer(_: Request) -> Response:
            return JSONResponse(await run_in_threadpool(content))

        return answer

    def guarded(handler: Handler, may: Callable[..., bool] = guard.may_act) -> Handler:
        async def answer(request: Request) -> Response:
            if not may(request.headers, request.query_params):
                return PlainTextResponse("not allowed: the address lacks the token\n", 403)
            return await handler(request)

        return answer

    async def thumbnail(request: Request) -> Response:
        picture = gallery.thumbnail(request.path_params["name"])
        return Response(picture, media_type="image/webp") if picture else Response(status_code=404)

    async def exported(request: Request) -> Response:
        try:
            return FileResponse(session.workspace.export(**request.path_params))
        except BarchanError as error:
            return JSONResponse({"text": str(error)}, 404)

    async def upload(request: Request) -> Response:
        return await (_discard if request.method == "DELETE" else _upload)(request, session)

    async def connect(websocket: WebSocket) -> None:
        await _connect(websocket, session, guard)

    routes = [
        Route("/api/presets", guarded(json_of(gallery.presets))),
        Route("/api/schema", guarded(json_of(gallery.schema), guard.may_look)),
        Route("/api/colours", guarded(json_of(colours), guard.may_look)),
        Route("/api/files", guarded(json_of(gallery.files_taken), guard.may_look)),
        Route("/api/unfinished", guarded(json_of(session.left_on_disk))),
        Route("/api/formats", guarded(json_of(gallery.formats))),
        Route("/api/watching", guarded(json_of(guard.for_watchers))),
        Route("/api/exports/{number}/{name}", guarded(exported)),
        Route("/api/pictures/{name}", guarded(thumbnail)),
        Route("/api/upload", guarded(upload), methods=["POST", "DELETE"]),
        *film_routes(session.films, guarded),
        WebSocketRoute("/connection", connect),
        Mount("/", StaticFiles(directory=CLIENT, html=True, check_dir=False)),
    ]
    app = Starlette(routes=routes, lifespan=lifespan)
    app.add_middleware(GZipMiddleware, minimum_size=COMPRESSED_FROM, compresslevel=6)
    app.add_middleware(HostCheck, guard=guard)
    return app


async def _upload(request: Request, session: Session) -> Response:
    """Keep a file in the session's folder; of one whose sending is broken off nothing is kept."""
    name = request.query_params.get("name", "")
    try:
        content = await body_of(request, LARGEST_UPLOAD)
        path = await run_in_threadpool(session.workspace.keep, name, content)
    except TooLargeError as error:
        way = "the command line reads files of any size, and coarser cells make smaller ones"
        return JSONResponse({"text": f"'{name}': {error}; {way}"}, 413)
    except (BarchanError, OSError) as error:
        return JSONResponse({"text": str(error)}, 400)
    except ClientDisconnect:
        return Response(status_code=400)
    return JSONResponse({"path": str(path), "name": path.name})


async def _discard(request: Request, session: Session) -> Response:
    """Delete a file that the page sent for something that was refused."""
    await run_in_threadpool(session.workspace.discard, request.query_params.get("name", ""))
    return JSONResponse({})


async def _connect(websocket: WebSocket, session: Session, guard: Guard) -> None:
    """Carry messages between one browser and the session until one of them ends; tokens say what it may."""
    if not guard.is_addressed(websocket.headers) or not guard.is_own_page(websocket.headers):
        await websocket.close(NOT_ALLOWED)
        return
    await websocket.accept()  # a page learns the code, and so the reason, only of a connection that was open
    commands = guard.knows_token(websocket.headers, websocket.query_params)
    if not commands and not guard.knows_watch_token(websocket.headers, websocket.query_params):
        await websocket.close(NOT_ALLOWED)
        return
    if not commands and session.audience.is_full:
        await websocket.close(FULL)
        return
    viewer = session.attach(commands)
    sending = asyncio.create_task(_send_all(websocket, viewer.outbox))
    limiter = RateLimiter()
    try:
        while True:
            text = await websocket.receive_text()
            if not limiter.allows() or len(text) > LARGEST_MESSAGE:
                await websocket.close(TOO_MUCH)
                return
            session.requests.carry_out(viewer, text)
    except (WebSocketDisconnect, KeyError, RuntimeError):
        pass
    finally:
        session.detach(viewer)
        sending.cancel()


async def _send_all(websocket: WebSocket, outbox: "asyncio.Queue[bytes]") -> None:
    """Send whatever the session puts into the outbox; empty data dismiss the browser."""
    try:
        while True:
            data = await outbox.get()
            if not data:
                await websocket.close(REPLACED)
                return
            if is_frame(data):
                await websocket.send_bytes(data)
            else:
                await websocket.send_text(data.decode())
    except (WebSocketDisconnect, RuntimeError):
        return
