"""A series of frames for ParaView and VisIt: a list of times, and a folder with a .vti file for each."""

from pathlib import Path
from shutil import rmtree
from typing import Any
from xml.sax.saxutils import quoteattr

from barchan.export import vti
from barchan.export.source import Source
from barchan.replacing import PARTIAL, replacing

HEAD = """<?xml version="1.0"?>
<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">
<Collection>"""
TAIL = """</Collection>
</VTKFile>"""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the frames into the folder of the target's name, then the list, which names them relatively."""
    folder = path.with_name(path.stem.removesuffix(PARTIAL) + "_frames")
    new = not folder.exists()
    folder.mkdir(exist_ok=True)
    try:
        facts: dict[str, Any] = {}
        lines = [_frame(folder, source, step, facts) for step in source.steps]
        text = "\n".join(lines)
        path.write_text(f"{HEAD}\n{text}\n{TAIL}\n", "utf-8")
    except BaseException:
        if new:
            rmtree(folder)
        raise
    clocked = source.seconds(0) is not None
    return {"time_unit": "s" if clocked else "steps", "folder": folder.name, **facts}


def _frame(folder: Path, source: Source, step: int, facts: dict[str, Any]) -> str:
    """Write a frame into the folder, what is to be said of it into ``facts``; returns its line."""
    file = folder / f"{step:0{len(str(max(source.steps)))}d}.vti"
    with replacing(file) as partial:
        facts |= vti.write(partial, source.only([step], source.fields))
    seconds = source.seconds(step)
    time = float(step if seconds is None else seconds)
    return f'<DataSet timestep="{time!r}" part="0" file={quoteattr(f"{folder.name}/{file.name}")}/>'
