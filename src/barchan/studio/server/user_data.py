"""The user's folder for what Barchan keeps by itself."""

import os
import sys
from collections.abc import Mapping
from pathlib import Path


def data_folder(platform: str = sys.platform, environment: Mapping[str, str] = os.environ) -> Path:
    """Where programs keep data of their user, by the customs of each system; it need not exist yet."""
    if platform == "win32":
        home = environment.get("LOCALAPPDATA")
        return Path(home or Path.home() / "AppData" / "Local") / "barchan"
    if platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "barchan"
    home = environment.get("XDG_DATA_HOME", "")
    return (Path(home) if home.startswith("/") else Path.home() / ".local" / "share") / "barchan"
