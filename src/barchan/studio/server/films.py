"""Films of pictures that the page draws: they come one by one, and are encoded while further ones come."""

import io
import queue
import shutil
import threading
from collections.abc import Iterator
from pathlib import Path

from PIL import Image

from barchan.errors import BarchanError
from barchan.image_files import ImageError, image_in
from barchan.studio.server.workspace import Workspace

SUFFIXES = (".mp4", ".webp")
MOST_PIXELS = 4096 * 4096
"""Pixels of a picture at most."""
MOST_PICTURES = 10_000
QUEUED = 4
"""Pictures that may wait to be encoded; the page waits beyond."""
LOOK_AGAIN = 0.2
"""Seconds between two looks at an encoder that has no room."""
SLOWEST, FASTEST = 0.1, 100.0
"""Pictures a second that a film may show."""


class SceneFilm:
    """A film in the making."""

    def __init__(self, target: Path, rate: float) -> None:
        """Write a film of so many pictures a second to a file in a folder of its own.

        Raises BarchanError for another kind of file, a rate beyond the limits, or a missing library.
        """
        if target.suffix not in SUFFIXES:
            raise BarchanError(f"a film is {' or '.join(SUFFIXES)}, not '{target.suffix}'")
        if not SLOWEST <= rate <= FASTEST:
            raise BarchanError(f"{rate:g} pictures a second; allowed: {SLOWEST:g} to {FASTEST:g}")
        if target.suffix == ".mp4":
            from barchan.figures.mp4 import require_video

            require_video()
        self.target, self.count = target, 0
        self._rate = rate
        self._size: tuple[int, int] | None = None
        self._pictures: queue.Queue[Image.Image | None] = queue.Queue(QUEUED)
        self._given_up = False
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._encode, daemon=True, name="barchan-film")
        target.parent.mkdir(parents=True, exist_ok=True)
        self._thread.start()

    def add(self, data: bytes) -> int:
        """Add a picture (PNG, JPEG, WebP); returns how many there are now.

        Raises BarchanError for what is no such picture or of another size than the first, and where the film
        cannot be written.
        """
        if self.count >= MOST_PICTURES:
            raise BarchanError(f"more than {MOST_PICTURES} pictures in a film; allowed: fewer")
        picture = _picture(data)
        if self._size is None:
            self._size = picture.size
        if picture.size != self._size:
            sizes = ["{} × {}".format(*size) for size in (picture.size, self._size)]
            raise BarchanError(f"a picture of {sizes[0]} pixels in a film of {sizes[1]}")
        self._put(picture)
        self.count += 1
        return self.count

    def finish(self) -> Path:
        """The film, when its last picture is encoded; raises BarchanError where there is none."""
        if not self.count:
            raise BarchanError("a film without pictures; allowed: one or more")
        self._put(None)
        self._thread.join()
        self._check()
        return self.target

    def give_up(self) -> None:
        """Leave nothing of it."""
        self._given_up = True
        while self._thread.is_alive():
            try:
                self._pictures.put(None, timeout=LOOK_AGAIN)
            except queue.Full:
                continue
            self._thread.join()
        shutil.rmtree(self.target.parent, ignore_errors=True)

    def _put(self, picture: Image.Image | None) -> None:
        while True:
            self._check()
            try:
                self._pictures.put(picture, timeout=LOOK_AGAIN)
            except queue.Full:
                continue
            return

    def _check(self) -> None:
        if self._error is not None:
            raise BarchanError(f"cannot write {self.target.name}: {self._error}")

    def _encode(self) -> None:
        from barchan.figures.film import encode
        from barchan.replacing import replacing

        try:
            with replacing(self.target) as partial:
                encode(partial, self._coming(), self._rate)
        except Exception as error:
            self._error = error

    def _coming(self) -> Iterator[Image.Image]:
        while not self._given_up and (picture := self._pictures.get()) is not None:
            yield picture
        if self._given_up:
            raise InterruptedError("broken off")


class Films:
    """The film that the page is making, if it is; another one takes its place."""

    def __init__(self, workspace: Workspace) -> None:
        """None yet."""
        self._workspace = workspace
        self._number = ""
        self._film: SceneFilm | None = None

    def begin(self, name: str, rate: float) -> str:
        """Begin a film under a file's name; returns its number. Raises what SceneFilm does."""
        self.give_up()
        target = self._workspace.new_export(name)
        self._film, self._number = SceneFilm(target, rate), target.parent.name
        return self._number

    def film(self, number: str) -> SceneFilm:
        """The film of that number; raises BarchanError where it is not in the making."""
        if self._film is None or number != self._number:
            raise BarchanError(f"no film {number} is being made")
        return self._film

    def finish(self, number: str) -> str:
        """End a film; returns the name of its file, for the page to fetch."""
        path = self.film(number).finish()
        self._film = None
        return f"{number}/{path.name}"

    def give_up(self) -> None:
        """Leave nothing of a film that is not finished."""
        film, self._film = self._film, None
        if film is not None:
            film.give_up()


def _picture(data: bytes) -> Image.Image:
    """A picture of a film; raises BarchanError for anything else."""
    try:
        return image_in(io.BytesIO(data), ("PNG", "JPEG", "WEBP"), MOST_PIXELS).convert("RGB")
    except (ImageError, OSError, ValueError, SyntaxError) as error:
        raise BarchanError(f"no picture for a film: {error}") from None
