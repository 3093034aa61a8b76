"""Surfaces from anywhere are measured where they lie; what cannot be measured is refused with a reason."""

import csv
import json

import numpy as np
import pytest

import barchan
from barchan.errors import SurveyError
from barchan.survey import HeightField, compare, read_field, write_crests, write_dunes
from tests.measures.landforms import barchan as one_barchan
from tests.measures.landforms import field_of_dunes
from tests.measures.waves import random_surface, sine

rasterio = pytest.importorskip("rasterio")

WEST, SOUTH, SIDE = 500_000.0, 3_600_000.0, 2.0
SOUTH_WEST, SOLITARY = (30.0, 34.0), (96.0, 100.0)


def dunes():
    """Two barchans, the lower one near the south-west corner."""
    low = field_of_dunes(lambda x, y: one_barchan(x, y, height=3.0), [SOUTH_WEST])
    return np.maximum(low, field_of_dunes(one_barchan, [SOLITARY]))


def write_tif(path, heights, west=WEST, nodata=None):
    from rasterio.transform import Affine

    rows, columns = heights.shape
    place = Affine(SIDE, 0.0, west, 0.0, -SIDE, SOUTH + rows * SIDE)
    profile = {"height": rows, "width": columns, "count": 1, "dtype": "float32", "crs": "EPSG:32633"}
    with rasterio.open(path, "w", driver="GTiff", transform=place, nodata=nodata, **profile) as file:
        file.write(heights[::-1].astype("float32"), 1)
    return path


@pytest.fixture
def tif(tmp_path):
    heights = dunes()
    heights[:3, 60:70] = -9999.0
    return write_tif(tmp_path / "dunes.tif", heights, nodata=-9999.0)


def test_dunes_lie_in_the_files_coordinates_with_their_volumes(tif, tmp_path):
    survey = barchan.measure(tif, wind=270.0)
    assert survey.landform.name == "barchan"
    path = write_dunes(tmp_path / "dunes.csv", survey)
    rows = list(csv.DictReader(path.read_text("utf-8").splitlines()))
    assert len(rows) == 2
    north, east = np.mgrid[:128, :128]
    for row, column, height in ((*SOLITARY, 4.0), (*SOUTH_WEST, 3.0)):
        x, y = WEST + (column + 0.5) * SIDE, SOUTH + (row + 0.5) * SIDE
        found = min(rows, key=lambda r: np.hypot(float(r["x (m)"]) - x, float(r["y (m)"]) - y))
        assert np.hypot(float(found["x (m)"]) - x, float(found["y (m)"]) - y) < 12.0
        near = np.hypot(north - row, east - column) < 32
        volume = dunes()[near].sum() * SIDE**2
        assert float(found["volume (m³)"]) == pytest.approx(volume, rel=0.1)  # less what lies below the level
        assert float(found["height (m)"]) == pytest.approx(height, rel=0.15)  # less what smoothing takes
        assert float(found["horn_direction (degrees)"]) == pytest.approx(90.0, abs=5.0)


def test_crest_lines_and_outlines_are_read_back_in_the_files_coordinates(tif, tmp_path):
    survey = barchan.measure(tif)
    crests = json.loads(write_crests(tmp_path / "crests.geojson", survey).read_text())
    assert crests["crs"]["properties"]["name"] == "urn:ogc:def:crs:EPSG::32633"
    for feature in crests["features"]:
        x, y = np.array(feature["geometry"]["coordinates"]).T
        length = np.hypot(np.diff(x), np.diff(y)).sum()
        assert feature["properties"]["length"] == pytest.approx(length, rel=1e-3)
        assert set(feature["properties"]) == {"length", "azimuth", "ends"}
        assert x.min() > WEST
        assert y.min() > SOUTH
        heights = dunes()[
            ((y - SOUTH) / SIDE - 0.5).round().astype(int), ((x - WEST) / SIDE - 0.5).round().astype(int)
        ]
        assert np.median(heights) > 1.0
    outlines = json.loads(write_dunes(tmp_path / "dunes.geojson", survey).read_text())
    for feature in outlines["features"]:
        x, y = np.array(feature["geometry"]["coordinates"][0]).T
        area = abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2
        assert feature["properties"]["area"] == pytest.approx(area, rel=0.03)


def test_every_kind_of_file_gives_the_same_measures(tif, tmp_path):
    heights = dunes()
    heights[:3, 60:70] = np.nan
    np.save(tmp_path / "dunes.npy", heights)
    text = "\n".join(
        " ".join("-9999" if np.isnan(v) else repr(float(v)) for v in row) for row in heights[::-1]
    )
    head = f"ncols 128\nnrows 128\nxllcorner {WEST}\nyllcorner {SOUTH}\ncellsize {SIDE}\nNODATA_value -9999\n"
    (tmp_path / "dunes.asc").write_text(head + text)
    surveys = [
        barchan.measure(tif),
        barchan.measure(tmp_path / "dunes.npy", cell_size=SIDE),
        barchan.measure(tmp_path / "dunes.asc"),
        barchan.measure(heights, cell_size=SIDE),
    ]
    tables = np.array([[value.value for value in survey.values()] for survey in surveys])
    np.testing.assert_allclose(tables, tables[:1].repeat(4, axis=0), rtol=1e-3, atol=1e-3)


def test_a_plain_field_has_no_made_up_numbers():
    values = {v.measure.name: v for v in barchan.measure(np.zeros((32, 32)), cell_size=1.0).values()}
    assert values["spacing"].doubt == "no relief"
    assert np.isnan(values["spacing"].value)
    assert values["dunes"].value == 0


def test_relief_of_the_ground_is_taken_off_on_request():
    hills = 20.0 * sine(1, 1, (128, 128))
    rough = HeightField.of_array(hills + 5.0 * sine(16, 0, (128, 128)), 1.0)
    assert barchan.measure(rough).spacing > 30.0
    assert barchan.measure(rough.flattened(16.0)).spacing == pytest.approx(8.0, rel=0.05)


def test_two_dates_give_the_way_and_the_volumes_with_errors():
    one = 3.0 * random_surface(1, shape=(96, 128)) / random_surface(1, shape=(96, 128)).std()
    moved = (
        3.0 * random_surface(1, drift=(0, 3.0), shape=(96, 128)) / random_surface(1, shape=(96, 128)).std()
    )
    pair = [HeightField.of_array(heights, 2.0) for heights in (one, moved)]
    found = {finding.name: finding for finding in compare(*pair, years=2.0).findings()}
    assert found["east"].value == pytest.approx(6.0, abs=0.3)
    assert found["speed"].value == pytest.approx(3.0, abs=0.15)
    assert abs(found["east"].value - 6.0) < 4 * found["east"].error
    assert found["direction"].value == pytest.approx(90.0, abs=4.0)
    change = moved - one
    assert found["net"].value == pytest.approx(change.sum() * 4.0, abs=1e-6)
    assert found["deposited"].value == pytest.approx(change[change > 0].sum() * 4.0, rel=0.02)
    assert found["per_centimetre"].value == pytest.approx(96 * 128 * 4.0 * 0.01)


def test_two_dates_of_other_frames_are_refused(tif, tmp_path):
    beside = write_tif(tmp_path / "beside.tif", dunes(), west=WEST + 1.0)
    with pytest.raises(SurveyError, match=r"corners 1 m apart \(0.5 cells\); allowed: the same cells"):
        compare(read_field(tif), read_field(beside))
    with pytest.raises(SurveyError, match="128 × 128 and 96 × 128 cells"):
        compare(read_field(tif), read_field(write_tif(tmp_path / "less.tif", dunes()[:, :96])))
    with pytest.raises(SurveyError, match="--years 0; allowed: above 0"):
        compare(read_field(tif), read_field(tif), years=0.0)


@pytest.mark.parametrize(
    ("source", "options", "message"),
    [
        (np.zeros((4, 40)), {"cell_size": 1.0}, "8 or more rows and columns"),
        (np.zeros(40), {"cell_size": 1.0}, "an array of 1 dimensions"),
        (np.full((16, 16), np.nan), {"cell_size": 1.0}, "no cell has a height"),
        (np.zeros((16, 16)), {}, "an array needs cell_size"),
        (np.zeros((16, 16)), {"cell_size": -1.0}, "cells of -1 m; allowed: above 0"),
        (np.zeros((16, 16)), {"cell_size": 1.0, "wind": 400.0}, "a wind from 400°; allowed: 0 to 360"),
        ("no.tif", {}, r"no\.tif: no such file"),
        ("no.doc", {}, r"is of an unknown kind; allowed: \.npy"),
    ],
)
def test_what_cannot_be_measured_is_refused(source, options, message):
    with pytest.raises(SurveyError, match=message):
        barchan.measure(source, **options)


def test_an_undeclared_code_for_missing_heights_is_not_measured(tmp_path):
    heights = dunes()
    heights[5, 5] = -9999.0
    np.save(tmp_path / "a.npy", heights)
    with pytest.raises(SurveyError, match=r"--missing -9999 if it is one, --missing none if all are heights"):
        read_field(tmp_path / "a.npy", cell_size=1.0)
    assert np.isnan(read_field(tmp_path / "a.npy", cell_size=1.0, missing=[-9999.0]).heights[5, 5])


def test_files_are_written_under_names_that_fit_alone(tif, tmp_path):
    survey = barchan.measure(tif)
    with pytest.raises(SurveyError, match=r"allowed: \.geojson, \.json"):
        write_crests(tmp_path / "crests.shp", survey)
    with pytest.raises(SurveyError, match="cannot be written"):
        write_dunes(tmp_path / "no" / "dunes.csv", survey)
