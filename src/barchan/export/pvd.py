"""A series of frames for ParaView and VisIt: a list of times, and a folder with a .vti file for each."""

from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

from barchan.export import vti
from barchan.export.source import Source
from barchan.replacing import PARTIAL, replacing


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the frames into the folder of the target's name, then the list, which names them relatively."""
    folder = path.with_name(path.stem.removesuffix(PARTIAL) + "_frames")
    folder.mkdir(exist_ok=True)
    digits = len(str(max(source.steps)))
    lines = []
    for step in source.steps:
        file = folder / f"{step:0{digits}d}.vti"
        with replacing(file) as partial:
            vti.write(partial, source.only([step], source.fields))
        seconds = source.seconds(step)
        time = float(step if seconds is None else seconds)
        name = quoteattr(f"{folder.name}/{file.name}")
        lines.append(f'<DataSet timestep="{time!r}" part="0" file={name}/>')
    text = "\n".join(lines)
    path.write_text(
        '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">\n'
        f"<Collection>\n{text}\n</Collection>\n</VTKFile>\n",
        "utf-8",
    )
    clocked = source.seconds(0) is not None
    return {"time_unit": "s" if clocked else "steps", "folder": folder.name}
