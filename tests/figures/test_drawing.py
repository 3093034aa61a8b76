"""Every picture can be drawn of every field, without a warning."""

import io

import pytest

from barchan.analysis.time_series import measure_series
from barchan.figures.contours import contour_map
from barchan.figures.maps import relief_map
from barchan.figures.sections import profile
from barchan.figures.series import time_series
from barchan.figures.space_time import space_time

PICTURES = {
    "relief": lambda dataset, scenario: relief_map(dataset.isel(step=-1), scenario),
    "smoothed relief": lambda d, s: relief_map(d.isel(step=-1), s, smoothing=1.5, show_bare=False),
    "grey relief": lambda d, s: relief_map(d.isel(step=-1), s, colours="grey", limits=(0.0, 5.0)),
    "contours": lambda dataset, scenario: contour_map(dataset.isel(step=-1), scenario),
    "contours at intervals": lambda d, s: contour_map(d.isel(step=-1), s, interval=0.5, smoothing=0.0),
    "profile": lambda dataset, scenario: profile(dataset.isel(step=-1), scenario),
    "profile at the side": lambda d, s: profile(d.isel(step=-1), s, at=0.25, smoothing=1.0),
    "space and time": space_time,
    "red space and time": lambda d, s: space_time(d, s, at=0.5, colours="red-green"),
    "series": lambda dataset, scenario: time_series(measure_series(dataset, scenario), scenario),
}


@pytest.mark.parametrize("draw", PICTURES.values(), ids=list(PICTURES))
def test_a_picture_can_be_drawn_and_saved(field, draw):
    scenario, dataset = field
    file = io.BytesIO()
    draw(dataset, scenario).savefig(file, format="png", dpi=40)
    assert file.getvalue().startswith(b"\x89PNG")


def profile_of_one_cell(painted, **place):
    frame, scenario = painted(3, **place)
    profile(frame, scenario, at=0.0).savefig(io.BytesIO(), dpi=40)


@pytest.mark.parametrize(
    "place",
    [
        pytest.param({"lattice__rows": 1, "direction": 0.0}, id="across one row"),
        pytest.param({"direction": 225.0}, id="through a corner"),
    ],
)
def test_a_section_of_a_single_cell_can_be_drawn(painted, place):
    profile_of_one_cell(painted, **place)
