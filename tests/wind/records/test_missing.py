"""Numbers and texts that stand for a missing value act on what the file holds, wherever it is read.

Right values are the numbers written into the files, less those marked.
"""

import numpy as np
import pytest
import xarray as xr

from barchan.errors import RecordError
from barchan.wind.records import RecordFormat, read_record

ROWS = ("5,270", "FEHL,270", "5,kein Wert", "-999,270", "6,200")
HOURS = np.datetime64("2020-01-01T00", "ns") + np.arange(4) * np.timedelta64(1, "h")


def table(folder, heading=True):
    lines = [f"2024-01-01T{hour:02d}:00,{row}" for hour, row in enumerate(ROWS)]
    path = folder / "wind.csv"
    path.write_text("\n".join(["time,wind_speed (m/s),wd", *lines] if heading else lines) + "\n", "utf-8")
    return path


def netcdf(folder, values, **attributes):
    path = folder / "wind.nc"
    there = {"units": "m/s", **attributes}
    ways = ("time", np.full(4, 270.0), {"units": "degree"})
    xr.Dataset({"wind_speed": ("time", values, there), "wind_direction": ways}, {"time": HOURS}).to_netcdf(
        path, engine="h5netcdf"
    )
    return path


def test_stated_texts_count_in_any_case_beside_the_usual_numbers(tmp_path):
    record = read_record(table(tmp_path), RecordFormat(missing=["fehl", "Kein Wert"]))
    assert (record.speed.tolist(), record.missing) == ([5, 5, 6], 2)
    assert record.without_direction.tolist() == [False, True, False]


def test_stated_numbers_replace_the_usual_ones(tmp_path):
    with pytest.raises(RecordError, match=r"row 5, column 'wind_speed .m/s.': is -999"):
        read_record(table(tmp_path), RecordFormat(missing=["FEHL", "kein Wert", "-99"]))


def test_other_texts_among_numbers_are_refused_with_their_place(tmp_path):
    with pytest.raises(RecordError, match="row 4, column 'wd': is 'kein Wert'"):
        read_record(table(tmp_path), RecordFormat(missing="FEHL"))


def test_a_table_without_a_heading_may_have_stated_texts(tmp_path):
    form = RecordFormat(time="1", speed="2", direction="3", missing=["FEHL", "kein Wert"])
    assert read_record(table(tmp_path, heading=False), form).missing == 2


def test_stated_numbers_are_those_before_factors_and_offsets_of_a_header(tmp_path):
    """A speed of 77 tenths is stated to be missing; the others are tenths of a m/s."""
    keys = "nodata = -999\nfields = timestamp VW DW\nunits_multiplier = 1 0.1 1\n"
    head = f"SMET 1.1 ASCII\n[HEADER]\n{keys}[DATA]\n"
    path = tmp_path / "a.smet"
    path.write_text(head + "2024-01-01T00:00 50 10\n2024-01-01T01:00 77 10\n2024-01-01T02:00 60 10\n")
    record = read_record(path, RecordFormat(missing=[77.0], height=10.0))
    assert (record.speed.tolist(), record.missing) == ([5, 6], 1)


def test_numbers_in_single_precision_are_compared_as_such(tmp_path):
    """999.9 and -99.9 have no exact single-precision value."""
    values = np.array([5.0, 999.9, -99.9, 6.0], np.float32)
    assert read_record(netcdf(tmp_path, values)).speed.tolist() == [5, 6]


@pytest.mark.parametrize("fill", ["-77", [-77.0, -78.0], "-77."])
def test_attributes_may_write_the_missing_value_as_text_or_several(tmp_path, fill):
    values = np.array([5.0, -77.0, 4.0, 6.0])
    assert read_record(netcdf(tmp_path, values, missing_value=fill)).speed.tolist() == [5, 4, 6]


def test_a_text_in_an_attribute_that_is_no_number_is_passed_over(tmp_path):
    values = np.array([5.0, np.nan, 4.0, 6.0])
    assert read_record(netcdf(tmp_path, values, missing_value="n.a.")).speed.tolist() == [5, 4, 6]


def test_variables_of_texts_are_read_as_columns_are(tmp_path):
    path = netcdf(tmp_path, np.array(["5", "FEHL", "M", "6.5"], object))
    assert read_record(path, RecordFormat(missing="FEHL")).speed.tolist() == [5, 6.5]
    with pytest.raises(RecordError, match="row 2, column 'wind_speed': is 'FEHL'"):
        read_record(path)


def test_packed_numbers_without_a_sign_are_not_negative(tmp_path):
    """Bytes 0 to 255 in tenths of a m/s, of which 255 marks a missing one; 200 is 20 m/s."""
    values = np.array([50, -56, -1, 60], np.int8)
    path = netcdf(tmp_path, values, scale_factor=0.1, _Unsigned="true", missing_value=np.int8(-1))
    np.testing.assert_allclose(read_record(path).speed, [5, 20, 6])
