"""What the page sends as the body of a request: files and pictures."""

from starlette.requests import Request

from barchan.errors import BarchanError


class TooLargeError(BarchanError):
    """What is sent has more bytes than a request may."""


async def body_of(request: Request, largest: int) -> bytes:
    """The body of a request; raises TooLargeError where it has more bytes than ``largest``."""
    content = bytearray()
    async for part in request.stream():
        content += part
        if len(content) > largest:
            raise TooLargeError(f"more than {largest >> 20} MB; allowed: as much")
    return bytes(content)
