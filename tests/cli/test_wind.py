"""``barchan wind``: what a wind does to sand."""

import csv
import io
import json
import math

import pytest
from PIL import Image

from barchan.aeolian.flux import LAWS
from tests.wind.records.weather_file import SMET

WEAK = "time,speed (m/s),direction\n2024-01-01T00:00,3,270\n2024-01-01T01:00,4,280\n2024-01-01T02:00,0,\n"


def test_the_sample_is_told_and_drawn(here, barchan):
    result = barchan("wind")
    assert (result.code, result.err) == (0, "")
    for word in (
        "sample.csv.gz",
        "energy high",
        "RDP/DP 0.56",
        "obtuse bimodal",
        "azimuth 116°",
        "linear dunes",
    ):
        assert word in result.out
    assert result.out.endswith("wind-roses.png\n")
    with Image.open(here / "wind-roses.png") as picture:
        assert picture.width > picture.height > 300


@pytest.mark.parametrize("view", ["thresholds", "laws"])
def test_thresholds_and_laws_are_drawn(here, barchan, view):
    result = barchan("wind", "--view", view, "--grain-diameter", "0.0002")
    assert (result.code, result.out) == (0, f"wind-{view}.png\n")
    assert (here / f"wind-{view}.png").exists()


@pytest.mark.parametrize(
    ("name", "said"), [("tiny.json", "narrow unimodal"), ("star", "fingers of scarce sand   grow nowhere")]
)
def test_the_wind_of_a_scenario_is_told(here, barchan, name, said):
    result = barchan("wind", name, "--out", "rose.png")
    assert (result.code, result.err) == (0, "")
    assert said in result.out
    assert (here / "rose.png").exists()


def test_the_wind_of_a_run_is_told(finished, barchan):
    assert "from 270°" in barchan("wind", finished.name).out


def test_a_record_that_never_exceeds_the_threshold_moves_nothing(here, barchan):
    (here / "weak.csv").write_text(WEAK)
    result = barchan("wind", "weak.csv")
    assert result.code == 0
    assert "nothing would move" in result.out
    assert "DP 0 VU" in result.out


@pytest.mark.parametrize("law", LAWS)
def test_a_flux_law_may_be_chosen(here, barchan, law):
    result = barchan("wind", "--law", law, "--threshold", "5", "--supply", "10", "--sectors", "36")
    assert f"flux law                 {law}," in result.out
    assert "5.00 m/s at 10 m" in result.out
    assert "VU above 9.72 kn" in result.out
    assert "dunes to expect          linear dunes, close and compound" in result.out


def test_columns_and_units_may_be_stated(here, barchan):
    (here / "odd.csv").write_text(WEAK.replace("time,speed (m/s),direction", "when,blow,from"))
    words = ["--time", "when", "--speed", "blow", "--direction", "from", "--unit", "kn", "--missing", "4"]
    result = barchan("wind", "odd.csv", *words)
    assert "33.3 % missing" in result.out
    assert "highest 1.5 m/s" in result.out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["none.csv"], "no such file"),
        (["nowhere"], "nowhere"),
        (
            ["sample", "--grain-diameter", "-1"],
            "grain_diameter: is -1.0; allowed: number ≥ 2e-05 and ≤ 0.005",
        ),
        (["sample", "--height", "0.0001", "--law", "owen"], "above the roughness length"),
        (["sample", "--speed", "gust"], "speed: no column 'gust'; the columns are time, speed (m/s)"),
        (["sample", "--out", "wind.txt"], "cannot write wind.txt"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_mistakes_are_clear_errors(here, barchan, words, said):
    result = barchan("wind", *words)
    assert result.code == 1
    assert said in result.err
    assert "Traceback" not in result.err


def test_an_implausible_wind_is_doubted_before_all_else(here, barchan):
    rows = "\n".join(f"2024-01-01T{hour:02}:00,{speed},270" for hour, speed in enumerate((50, 60, 70)))
    (here / "tenths.csv").write_text("time,ws,wd\n" + rows)
    out = barchan("wind", "tenths.csv").out
    assert out.startswith("warning: the mean speed is 60.0 m/s")
    assert "warning" not in barchan("wind", "tenths.csv", "--unit", "0.1 m/s").out


def test_drift_potential_is_told_by_month_and_season(here, barchan):
    seasons = barchan("wind", "--by", "season").out
    assert [name in seasons for name in ("June to August", "December to February")] == [True, True]
    assert "July" in barchan("wind", "--by", "month").out
    (here / "counted.csv").write_text(
        WEAK.replace("time", "time (h)").replace("2024-01-01T0", "").replace(":00", "")
    )
    assert "the record has no dates" in barchan("wind", "counted.csv", "--by", "month").err


def test_the_height_that_is_asked_for_is_read_and_told(here, barchan):
    two = "time,ws_10m (m/s),ws_100m (m/s),wd\n2024-01-01,9,12,270\n2024-01-02,8,11,270\n"
    (here / "two.csv").write_text(two)
    assert "ws_10m (m/s) and wd, in m/s, at 10 m" in barchan("wind", "two.csv").out
    high = barchan("wind", "two.csv", "--height", "100").out
    assert "ws_100m (m/s) and wd, in m/s, at 100 m" in high
    assert "highest 12.0 m/s" in high
    refused = barchan("wind", "two.csv", "--height", "50")
    assert (refused.code, "the file has winds at 10, 100 m" in refused.err) == (1, True)


def test_a_record_is_known_by_its_content(here, barchan):
    (here / "mast.dat").write_text(WEAK)
    assert "DP 0 VU" in barchan("wind", "mast.dat").out


def test_too_few_sectors_are_refused(here, barchan):
    assert barchan("wind", "--sectors", "7").code != 0


def test_the_key_that_states_the_height_of_a_record_is_named(here, barchan):
    (here / "weak.csv").write_text(WEAK)
    told = barchan("wind", "weak.csv").out.replace("\n", " ")
    assert "does not state the height of its speeds; taken to be at 10 m; --height states another" in told
    assert "--height states another" not in barchan("wind", "weak.csv", "--height", "3").out


def test_months_are_refused_where_winds_have_no_dates(here, barchan):
    result = barchan("wind", "tiny.json", "--by", "month")
    assert result.code == 1
    assert "--by month: the winds of tiny.json have no dates" in result.err


HOURS = "".join(f"2024-01-01T{hour:02}:00,{9 + hour},270\n" for hour in (0, 1, 2, 7, 8))


@pytest.fixture
def ridge(here):
    (here / "ridge.csv").write_text("time,speed (m/s),direction\n" + HOURS)
    (here / "hut.smet").write_text(SMET)
    scenario = {
        "barchan": 5,
        "lattice": {"rows": 8, "columns": 8},
        "sand": {"kind": "flat", "mean": 1},
        "clock": {"reference_speed": 10},
        "wind": {"kind": "record", "path": "ridge.csv", "weather": {"path": "hut.smet"}},
        "run": {"steps": 1},
    }
    (here / "ridge.json").write_text(json.dumps(scenario))


def test_a_wind_with_a_second_record_is_told_with_its_weather(barchan, ridge):
    """Five hours of wind, none calm; in the first three fall 6 of the 9 mm, at 9, 10 and 11 m/s.

    The sixth hour of snow lies in the gap from 3 to 7 h.
    """
    alone = barchan("wind", "ridge.csv").out
    for words in (["ridge.csv", "--weather", "hut.smet"], ["ridge.json"]):
        result = barchan("wind", *words)
        assert (result.code, result.err) == (0, "")
        told = " ".join(result.out.split())
        assert "snowfall 9 kg/m² in 6 h, at most 2 kg/m² an hour" in told
        assert "wind while it snows mean 10.00 m/s" in told
        assert "temperature mean -14.0 °C, -16.0 to -10.0 °C" in told
        assert "temperature and snowfall: from hut.smet, joined in time" in told
        assert "as measured, without gaps" in told
        for start in ("rows", "wind speed", "drift potential"):
            (line,) = (line for line in alone.splitlines() if line.startswith(start))
            assert line in result.out
    assert "snowfall" not in alone


def test_marks_of_missing_values_are_stated_for_the_second_record_too(here, barchan):
    """Temperatures are -4 and -8 °C in turn; every third one is -777, which no thermometer reads.

    Between its neighbours it is -8, -4, -8 … °C, so that the mean stays that of the two.
    """
    moments = [f"2021-01-{1 + hour // 24:02}T{hour % 24:02}:00" for hour in range(96)]
    winds = [f"{moment},7,250" for moment in moments]
    degrees = [
        f"{moment},{-777 if hour % 3 == 2 else -4 - 4 * (hour % 2)}" for hour, moment in enumerate(moments)
    ]
    (here / "wind.csv").write_text("\n".join(["time,speed (m/s),direction (deg)", *winds]))
    (here / "hut.csv").write_text("\n".join(["time,temperature (degC)", *degrees]))
    both = "wind", "wind.csv", "--weather", "hut.csv"
    assert "is -777 °C; allowed: -90 to 60 °C" in barchan(*both).err
    read = " ".join(barchan(*both, "--weather-missing", "-777").out.split())
    assert "temperature mean -6.0 °C, -8.0 to -4.0 °C" in read
    refused = barchan(*both, "--weather-time-zone", "CET")
    assert refused.code != 0
    assert "time_zone: is 'CET'; allowed: text such as '+01:00' or 'UTC' | null" in refused.err


def test_a_joined_record_is_saved_with_its_weather(here, barchan, ridge):
    barchan("wind", "ridge.csv", "--weather", "hut.smet", "--save-record", "joined.csv")
    told = barchan("wind", "joined.csv").out
    assert "9 kg/m² in 6 h" in told


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["ridge.json", "--weather", "hut.smet"], "a scenario names one as wind.weather"),
        (["ridge.csv", "--weather", "none.smet"], "none.smet: 1 problem no such file"),
        (
            ["ridge.csv", "--weather", "ridge.csv"],
            "ridge.csv: 1 problem holds neither temperature nor snowfall",
        ),
    ],
)
def test_a_second_record_that_cannot_be_joined_is_refused(barchan, ridge, words, said):
    result = barchan("wind", *words)
    assert (result.code, said in " ".join(result.err.split())) == (1, True)


MIXED = "time,speed (m/s),direction,temperature (°C),snowfall (mm/h)\n" + "".join(
    f"2024-01-0{1 + n // 24}T{n % 24:02d}:00,{speed},{way},{warmth},{snow}\n"
    for n, (speed, way, warmth, snow) in enumerate([(10, 270, -5, 1.0)] * 22 + [(10, 190, 2, 0)] * 3)
)
"""22 hours from the west, 3 from the south at 10 m/s: 88 % of the sand and 12 %, a peak 14 % as high."""


def numbers_in(text):
    """Values of the measures of a CSV text, by name."""
    rows = list(csv.DictReader(io.StringIO(text)))
    return {row["name"]: row for row in rows}


def test_the_numbers_of_a_wind_are_printed_as_csv_with_their_doubts(here, barchan):
    """DP of 10 m/s: U is 19.438 kn, U² (U - 12) is 2810.4; RDP² is 22² + 3² + 2 22 3 cos 80° of 25²."""
    (here / "mixed.csv").write_text(MIXED, "utf-8")
    result = barchan("wind", "mixed.csv", "--csv", "--height", "10", "--supply", "2.5")
    assert (result.code, result.err) == (0, "")
    found = numbers_in(result.out)
    assert float(found["drift_potential"]["value"]) == pytest.approx(2810.4, rel=1e-4)
    assert found["drift_potential"]["doubt"] == "not that of a year"
    resultant = math.sqrt(22**2 + 3**2 + 2 * 22 * 3 * math.cos(math.radians(80))) / 25
    assert float(found["steadiness"]["value"]) == pytest.approx(resultant)
    assert "nearly narrow unimodal" in found["directions"]["doubt"]
    assert (found["dunes"]["value"], found["directions"]["value"]) == ("barchans", "wide unimodal")
    assert "near 3 m; with more sand: transverse dunes" in found["dunes"]["doubt"]
    assert not (here / "wind-roses.png").exists()


def test_the_numbers_of_a_wind_are_printed_as_json_with_roses_and_remarks(here, barchan):
    (here / "mixed.csv").write_text(MIXED, "utf-8")
    result = barchan(
        "wind", "mixed.csv", "--json", "--by", "month", "--out", "r.png", "--save-record", "c.csv"
    )
    found = json.loads(result.out)
    names = {measure["name"]: measure for measure in found["measures"]}
    assert names["drift_potential_january"]["values"][0]["unit"] == "VU"
    assert names["days_january"]["values"][0]["value"] == pytest.approx(25 / 24)
    rose = [row[found["rose"]["columns"].index("drift potential (VU)")] for row in found["rose"]["rows"]]
    total = names["drift_potential"]["values"][0]["value"]
    assert (len(rose), rose[12]) == (16, pytest.approx(0.88 * total))
    said = " ".join(found["remarks"])
    assert "those of dry sand" in said
    assert "above 0 °C for 12 % of the time" in said
    assert (here / "r.png").exists()
    assert (here / "c.csv").exists()


def test_roses_are_written_as_a_table(here, barchan):
    (here / "mixed.csv").write_text(MIXED, "utf-8")
    assert (
        "36 directions written"
        in barchan("wind", "mixed.csv", "--save-rose", "rose.csv", "--sectors", "36").out
    )
    rows = list(csv.reader((here / "rose.csv").read_text("utf-8").splitlines()))
    assert rows[0][:2] == ["from (degrees)", "sand moved (m²/yr)"]
    assert [row[0] for row in rows[1:] if float(row[1]) > 0] == ["190.0", "270.0"]


def test_json_and_csv_together_are_refused(here, barchan):
    assert "give one of them" in barchan("wind", "sample", "--json", "--csv").err
    assert "is a picture" in barchan("wind", "sample", "--json", "--view", "laws").err
