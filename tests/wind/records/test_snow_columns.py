"""How much snow falls by a record, and the wind of a boom over snow that rises towards it."""

import numpy as np
import pytest
import xarray as xr

from barchan.errors import RecordError
from barchan.wind.records import RecordFormat, read_record
from barchan.wind.records.gaps import with_gaps
from tests.wind.records.test_weather import SMET, path, table

__all__ = ["path"]


SHARE = SMET.replace("PSUM HS", "PSUM PSUM_PH").replace("units_multiplier = 1 1 1 1 1 0.01\n", "")


def smet(tmp_path, text):
    (tmp_path / "test.smet").write_text(text)
    return tmp_path / "test.smet"


def test_smet_parts_rain_and_snow_as_it_states(tmp_path):
    """1.5 mm reported at 2 h with a quarter rain fell at 1 h; 2 mm at 3 h are all rain, at -9.5 °C even."""
    text = SHARE.replace("0.0 35", "0.0 -999").replace("1.5 36", "1.5 0.25").replace("2.0 38", "2.0 1")
    found = with_gaps(read_record(smet(tmp_path, text.replace("0.0 38", "0.0 0"))))
    np.testing.assert_allclose(found.snowfall[:3] * 3600, [1.5 * 0.75, 0.0, 0.0], atol=1e-12)
    assert any("rain and snow are parted by 'PSUM_PH'" in remark for remark in found.remarks)


def test_a_share_of_rain_needs_no_temperature(path):
    found = read_record(table(path, "precipitation (mm/h),psum_ph", ["2,0", "2,0.5", "2,1", "0,"]))
    np.testing.assert_allclose(found.snowfall * 3600, [2.0, 1.0, 0.0, 0.0], atol=1e-12)


def test_where_no_share_is_stated_temperature_parts_rain_and_snow(path):
    rows = ["-5,2,", "1,2,", "4,2,0"]
    found = read_record(table(path, "temperature (°C),precipitation (mm/h),psum_ph", rows))
    np.testing.assert_allclose(found.snowfall * 3600, [2.0, 1.0, 2.0], atol=1e-12)


def test_era5_states_the_type_of_what_falls(tmp_path):
    """1 mm in each hour, of the type at its end: snow (5), half of a mixture (7), freezing rain (1)."""
    time = np.datetime64("2024-01-01T00", "ns") + np.arange(4).astype("timedelta64[h]")
    fields = {
        "u10": ("time", np.full(4, 3.0), {"units": "m s**-1"}),
        "v10": ("time", np.full(4, 4.0), {"units": "m s**-1"}),
        "t2m": ("time", np.full(4, 263.15), {"units": "K"}),
        "tp": ("time", np.full(4, 1e-3), {"units": "m"}),
        "ptype": ("time", np.array([0.0, 5.0, 7.0, 1.0]), {"units": "code table (4.201)"}),
    }
    xr.Dataset(fields, coords={"time": time}).to_netcdf(tmp_path / "point.nc", engine="h5netcdf")
    found = read_record(tmp_path / "point.nc")
    np.testing.assert_allclose(found.snowfall[:3] * 3600, [1.0, 0.5, 0.0], atol=1e-9)


DEPTH = SMET.replace("DW PSUM HS", "DW HS").replace("1 1 1 1 1 0.01", "1 1 1 1 0.01")
DEPTH = DEPTH.replace("units_offset = 0 273.15 0 0 0 0", "units_offset = 0 273.15 0 0 0")
DEPTH = "".join(line.replace(" 0.0 3", " 3").replace(" 1.5 3", " 3").replace(" 2.0 3", " 3")
                for line in DEPTH.splitlines(keepends=True))  # fmt: skip


def test_snow_falls_as_its_depth_rises_and_that_is_said(tmp_path):
    """35, 36, 38, 38 cm: 1 cm and 2 cm of 80 kg/m³ are 0.8 and 1.6 kg/m² in an hour each."""
    found = with_gaps(read_record(smet(tmp_path, DEPTH), RecordFormat(fresh_density=80.0)))
    np.testing.assert_allclose(found.snowfall[:3] * 3600, [0.8, 1.6, 0.0], atol=1e-9)
    assert any(
        "derived from the rising snow depth 'HS', times 80 kg/m³" in remark for remark in found.remarks
    )


def test_a_depth_counts_by_the_density_of_fresh_snow_at_its_temperature(tmp_path):
    """67.92 + 51.25 exp(-8 / 2.59) = 70.25 kg/m³ at -8 °C (Hedstrom & Pomeroy 1998)."""
    found = with_gaps(read_record(smet(tmp_path, DEPTH)))
    assert found.snowfall[0] * 3600 == pytest.approx(0.7025, abs=1e-3)
    assert any("Hedstrom & Pomeroy 1998" in remark for remark in found.remarks)


def test_settling_takes_no_snow_and_a_table_is_not_searched_for_a_depth(path):
    rows = ["-5,30", "-5,28", "-5,29"]
    file = table(path, "temperature (°C),snow_depth (cm)", rows)
    assert read_record(file).snowfall is None
    form = RecordFormat(snow_depth="snow_depth (cm)", fresh_density=100.0)
    np.testing.assert_allclose(read_record(file, form).snowfall[:2] * 3600, [0.0, 1.0], atol=1e-9)


BOOM = """time,p_u,t_u,rh_u,wspd_u,wdir_u,z_boom_u
2024-01-01 00:00:00,800,-25.5,70,6.0,130,2.4
2024-01-01 01:00:00,800,-26.5,70,6.0,131,1.2
2024-01-01 02:00:00,800,-26.5,70,6.0,131,
2024-01-01 03:00:00,800,-26.5,70,6.0,131,0.6
2024-01-01 04:00:00,800,-26.5,70,6.0,131,0.1
"""


def test_a_boom_that_snow_comes_near_to_measures_less_wind(path):
    """Law of the wall over 0.24 mm: ln(10/z0) / ln(z/z0) by hand; the height missing at 2 h is 0.9 m."""
    path.write_text(BOOM)
    found = read_record(path)
    factors = [np.log(10 / 2.4e-4) / np.log(z / 2.4e-4) for z in (2.4, 1.2, 0.9, 0.6)]
    np.testing.assert_allclose(found.speed, 6.0 * np.array(factors))
    assert (found.height, found.missing) == (10.0, 1)
    told = next(remark for remark in found.remarks if "z_boom_u" in remark)
    assert "in 1 row the height is missing" in told
    assert "in 1 row with the boom below 0.2 m there is no wind" in told


def test_a_stated_height_holds_against_the_boom(path):
    path.write_text(BOOM)
    found = read_record(path, RecordFormat(height=2.0))
    assert (found.height, found.speed.tolist()) == (2.0, [6.0] * 5)


@pytest.mark.parametrize(
    ("heading", "rows", "form", "said"),
    [
        ("tp (mm/h),psum_ph", ["1,0", "1,1.5"], {"rain_share": "psum_ph"},
         r"row 3, column 'psum_ph': is 1.5; allowed: 0 to 1"),
        ("tp (mm/h),ptype", ["1,0", "1,4"], {"precipitation_type": "ptype"},
         r"row 3, column 'ptype': is 4; allowed: 0, 1, 3, 5, 6, 7, 8, 12"),
        ("hs (m),tt (°C)", ["1,-5", "-2,-5"], {"snow_depth": "hs (m)"},
         r"row 3, column 'hs \(m\)': is -2 m; allowed: 0 to 30 m"),
        ("hs (m)", ["1", "1.1"], {"snow_depth": "hs (m)"}, r"neither fresh_density nor a temperature"),
        ("hs", ["1", "1.1"], {"snow_depth": "hs"}, r"column 'hs': states no unit; name one"),
        ("hs (m),tt (°C)", ["1,-5", "3,-5"], {"snow_depth": "hs (m)"},
         r"row 2, column 'hs \(m\)': comes to .* kg/m²/h of snow; allowed: 30"),
        ("z (m)", ["2", "25"], {"boom_height": "z (m)"}, r"row 3, column 'z \(m\)': is 25 m; allowed: 0 to"),
        ("z (m)", ["2", "2"], {"boom_height": "z"}, r"boom_height: no column 'z'; the columns are"),
        ("z (m)", ["2", "2"], {"boom_height": "z (m)", "height": 3.0}, r"and height is 3 m; allowed: one"),
    ],
)  # fmt: skip
def test_columns_of_snow_that_cannot_be_are_refused(path, heading, rows, form, said):
    with pytest.raises(RecordError, match=said):
        read_record(table(path, heading, rows), RecordFormat(**form))


def test_binary_smet_is_refused_whatever_its_bytes(tmp_path):
    (tmp_path / "bin.smet").write_bytes(b"SMET 1.1 BINARY\n[HEADER]\n[DATA]\n" + bytes(range(256)) * 8)
    with pytest.raises(RecordError, match="is binary SMET; convert it to ASCII"):
        read_record(tmp_path / "bin.smet")
