"""How long a wind lasts and comes again, beside the run; keys that belong elsewhere.

Right values: an hour of record and of regimes in steps of a stated duration, by pencil and paper.
"""

import pytest

from barchan.errors import ScenarioError
from barchan.scenario import load_scenario


def of(wind, steps, save_every=10, seconds=100.0):
    return load_scenario(
        {
            "barchan": 2,
            "lattice": {"rows": 16, "columns": 16, "cell_size": 1.0},
            "clock": {"step_seconds": seconds},
            "wind": wind,
            "run": {"steps": steps, "save_every": save_every, "seed": 1},
        }
    )


@pytest.fixture
def record(tmp_path):
    """Six rows of ten minutes: an hour."""
    path = tmp_path / "hour.csv"
    rows = [f"2024-01-10T00:{10 * n:02d},9,{260 + n}" for n in range(6)]
    path.write_text("\n".join(["time,wind_speed (m/s),wind_dir", *rows]) + "\n", "utf-8")
    return {"kind": "record", "path": str(path), "repeat": False}


@pytest.mark.parametrize(
    ("steps", "compared"), [(9, "its first 25 %"), (36, "as long"), (72, "2 times that")]
)
def test_the_length_of_a_record_stands_beside_that_of_the_run(record, steps, compared):
    facts = of(record, steps).time_facts()
    assert facts["wind lasts"] == f"60 minutes, 36 steps; the run (run.steps {steps}) is {compared}".replace(
        "60 minutes", "1 hours"
    )


def test_a_steady_wind_has_no_length():
    assert "wind lasts" not in of({"kind": "steady"}, 10).time_facts()


def test_frames_that_miss_the_cycles_of_the_wind_are_remarked_with_a_number_that_fits(record):
    wind = {**record, "repeat": True}
    # a cycle is 36 steps, and frames are looked for up to three cycles (108 steps) earlier, to 1.8 steps
    assert not [r for r in of(wind, 400, save_every=12).remarks() if "migration" in r]
    (remark,) = [r for r in of(wind, 400, save_every=50).remarks() if "migration" in r]
    assert "(36 steps)" in remark
    # 51 to 53: 102 to 106 steps are 2.83 to 2.94 cycles; 54 steps are 1.5, and twice 54 are 3 cycles
    # 49 to 47: not either; 46 to 38 neither: of the numbers near 50 it is 54, whose double misses nothing,
    # or 53, whose double misses 2 steps, more than 1.8
    assert remark.endswith("run.save_every 54 fits")


@pytest.mark.parametrize(
    ("group", "key", "place"),
    [
        ("lattice", "influx", "'influx' is a group of its own, beside lattice"),
        ("lattice", "save_every", "it belongs to run"),
        ("run", "columns", "it belongs to"),
    ],
)
def test_keys_that_belong_elsewhere_are_answered_with_their_place(group, key, place):
    with pytest.raises(ScenarioError) as told:
        load_scenario({"barchan": 2, group: {key: 1}})
    assert place in str(told.value)
