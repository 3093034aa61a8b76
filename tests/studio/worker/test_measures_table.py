"""The measures of the studio as a table: the one that ``barchan export --format measures`` writes."""

import csv

from barchan.archive import dataset_of
from barchan.export import export
from barchan.simulation import Simulation
from barchan.studio.worker.measures_table import measures_table
from barchan.studio.worker.run import started
from tests.studio.worker.test_run import run_to


def test_the_studio_and_the_command_line_write_the_same_table(scenario, tmp_path):
    run = started(scenario)
    run_to(run, 30)
    frames = [Simulation.from_state(state).frame() for state in run.history.states]
    export(dataset_of(run.live, frames), tmp_path / "m.csv", format="measures", step="all")
    with (tmp_path / "m.csv").open(newline="") as file:
        headings, *rows = csv.reader(file)
    table = measures_table(scenario, run.measures.rows)
    assert table["headings"] == headings
    assert table["rows"] == rows


def test_a_measure_in_doubt_is_named_in_the_last_column_and_one_without_a_value_is_empty(scenario):
    row = {"step": 10, "values": {"spacing": 41.6, "dune_height": None}, "doubts": {"spacing": "two dunes"}}
    table = measures_table(scenario, [row])
    told = dict(zip(table["headings"], table["rows"][0], strict=True))
    assert told["spacing (m)"] == "41.6"
    assert told["dune_height (m)"] == ""
    assert told["doubtful"] == "spacing"
