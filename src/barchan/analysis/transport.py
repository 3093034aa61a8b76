"""How much sand the wind carries."""


def flux(travel: float, cells: int, steps: int, slab_height: float, cell_size: float) -> float:
    """Sand flux (m³ per metre of width and step, that is m² per step), pores included.

    ``travel`` is the distance (cells) that slabs travelled on the wind in ``steps`` steps, summed over
    all slabs, on a field of ``cells`` cells.
    """
    return travel / cells * slab_height * cell_size / steps if steps else float("nan")
