"""The addresses by which the page makes a film: begin it, add pictures, end it, or give it up."""

from collections.abc import Awaitable, Callable
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from barchan.errors import BarchanError
from barchan.studio.server.films import Films
from barchan.studio.server.security import LARGEST_UPLOAD
from barchan.studio.server.uploads import body_of

Handler = Callable[[Request], Awaitable[Response]]


def film_routes(films: Films, guarded: Callable[[Handler], Handler]) -> list[Route]:
    """The routes, each of them behind ``guarded``."""

    def route(path: str, answer: Callable[[Request], Awaitable[dict[str, Any]]], method: str) -> Route:
        async def handler(request: Request) -> Response:
            try:
                return JSONResponse(await answer(request))
            except BarchanError as error:
                return JSONResponse({"text": str(error)}, 400)

        return Route(path, guarded(handler), methods=[method])

    async def begin(request: Request) -> dict[str, Any]:
        name, rate = request.query_params.get("name", ""), request.query_params.get("rate", "")
        try:
            number = float(rate)
        except ValueError:
            raise BarchanError(f"'{rate}' pictures a second; allowed: a number") from None
        return {"film": await run_in_threadpool(films.begin, name, number)}

    async def add(request: Request) -> dict[str, Any]:
        film = films.film(request.path_params["number"])
        return {"pictures": await run_in_threadpool(film.add, await body_of(request, LARGEST_UPLOAD))}

    async def finish(request: Request) -> dict[str, Any]:
        return {"file": await run_in_threadpool(films.finish, request.path_params["number"])}

    async def give_up(_: Request) -> dict[str, Any]:
        await run_in_threadpool(films.give_up)
        return {}

    return [
        route("/api/films", begin, "POST"),
        route("/api/films/{number}", add, "POST"),
        route("/api/films/{number}/end", finish, "POST"),
        route("/api/films/{number}", give_up, "DELETE"),
    ]
