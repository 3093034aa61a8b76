"""The numbers of a NetCDF variable in its own unit, by its attributes and the user's marks."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.missing import marked
from barchan.wind.records.claims import Claim
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.values import Unit, numbers_of, without_codes

if TYPE_CHECKING:
    import xarray as xr


def variable_values(
    variable: "xr.DataArray", claim: Claim, unit: Unit, form: RecordFormat, source: str
) -> NDArray[np.float64]:
    """The numbers of a variable in its own unit, NaN where attributes or marks call one missing.

    Raises RecordError at a text that is no number, point of the compass or mark.
    """
    raw = variable.to_numpy()
    if raw.dtype.kind in "OSU":
        return _of_texts(raw, claim, unit, form, source)
    return without_codes(_unpacked(raw, variable.attrs, form), claim, form)


def _of_texts(
    raw: NDArray[Any], claim: Claim, unit: Unit, form: RecordFormat, source: str
) -> NDArray[np.float64]:
    import pandas as pd

    texts = [one.decode("utf-8", "replace") if isinstance(one, bytes) else str(one) for one in raw.ravel()]
    words = pd.Series(texts, name=claim.column, dtype=str)
    values, _ = numbers_of(words, claim, unit, np.arange(1, len(texts) + 1), source, form.texts)
    return without_codes(values, claim, form)


def fill_values(attributes: Mapping[Any, Any]) -> NDArray[np.float64]:
    """The numbers that ``_FillValue`` and ``missing_value`` state, also where they are written as text."""
    found = []
    for key in ("_FillValue", "missing_value"):
        for value in np.ravel(attributes.get(key, [])).tolist():
            try:
                found.append(float(value))
            except ValueError:
                continue
    return np.array(found)


def _unpacked(raw: NDArray[Any], attributes: Mapping[Any, Any], form: RecordFormat) -> NDArray[np.float64]:
    """Numbers by scale and offset, NaN where they are missing.

    Fill values and valid ranges are those of the packed numbers (CF); codes that the user states hold for
    packed and unpacked numbers.
    """
    fills = fill_values(attributes)
    if raw.dtype.kind == "i" and str(attributes.get("_Unsigned", "")).lower() == "true":
        fills = np.where(fills < 0, fills + 2.0 ** (8 * raw.dtype.itemsize), fills)
        raw = raw.view(f"u{raw.dtype.itemsize}")
    values = raw.astype(np.float64)
    absent = marked(values, fills[np.isfinite(fills)].tolist())
    low, high = attributes.get("valid_range", (attributes.get("valid_min"), attributes.get("valid_max")))
    if low is not None:
        absent |= values < float(low)
    if high is not None:
        absent |= values > float(high)
    if "scale_factor" in attributes or "add_offset" in attributes:
        absent |= marked(values, form.stated_codes)
    scaled = values * float(attributes.get("scale_factor", 1.0)) + float(attributes.get("add_offset", 0.0))
    return np.where(absent, np.nan, scaled)
