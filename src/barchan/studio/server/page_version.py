"""Whether the page that was built speaks the protocol of this server."""

import re
from pathlib import Path

from barchan.errors import BarchanError
from barchan.studio.protocol import PROTOCOL

_STATED = re.compile(r"""<meta name="barchan-protocol" content="(\d+)">""")


def check_page(client: Path) -> None:
    """Look for the page in the folder ``client``, and at the protocol that it was built for.

    A page that states none is let through: it looks at the protocol itself when it connects.
    Raises BarchanError where there is no page, or one of another protocol.
    """
    page = client / "index.html"
    if not page.is_file():
        raise BarchanError(f"the client is not built in {client}; install the package again")
    stated = _STATED.search(page.read_text("utf-8"))
    if stated and int(stated[1]) != PROTOCOL:
        raise BarchanError(
            f"the studio's page in {client} was built from another version of Barchan: it speaks protocol "
            f"{stated[1]}, this version {PROTOCOL}; install the package again (in a checkout: pip install ., "
            "or npm run build in web)"
        )
