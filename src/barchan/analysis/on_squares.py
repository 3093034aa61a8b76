"""Frames of a lattice of hexagons brought onto squares, for pictures and sections."""

from typing import TYPE_CHECKING

from barchan.scenario import Scenario
from barchan.squares import Squares

if TYPE_CHECKING:
    import xarray as xr


def on_squares(frame: "xr.Dataset", scenario: Scenario) -> tuple["xr.Dataset", Scenario]:
    """One frame and its scenario with all fields on squares (see ``squares``); those of squares as they are.

    The result is for looking at and no state of a run: heights lie between those of the cells.
    """
    if not scenario.lattice.hexagonal:
        return frame, scenario
    import xarray as xr

    squares = Squares(scenario.lattice)
    fields = {
        name: field_on_squares(values, scenario) if values.dims == ("y", "x") else values
        for name, values in frame.data_vars.items()
    }
    coords = {name: values for name, values in frame.coords.items() if not {"x", "y"} & set(values.dims)}
    lattice = squares.lattice
    coords |= {"x": lattice.x, "y": lattice.y}
    found = xr.Dataset(fields, coords, frame.attrs)
    return found, scenario.model_copy(update={"lattice": lattice})


def field_on_squares(field: "xr.DataArray", scenario: Scenario) -> "xr.DataArray":
    """A field of one frame on squares; one of squares as it is."""
    if not scenario.lattice.hexagonal:
        return field
    import xarray as xr

    values = Squares(scenario.lattice).between(field.values)
    return xr.DataArray(values, dims=("y", "x"), name=field.name, attrs=field.attrs)
