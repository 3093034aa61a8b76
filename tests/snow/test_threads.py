"""Snow on several threads is the snow of one thread to the bit, whichever thread runs which band and when."""

import numpy as np
import pytest

import barchan.kernels.snow.bed  # noqa: F401  # how kernels treat a bed of snow
from barchan.bed import Bed
from barchan.kernels.slabs.plan import BROKEN_OFF
from barchan.kernels.slabs.state import STRAYED, TALLY_SIZE
from barchan.lattice import Lattice
from barchan.models.snow import Snow
from barchan.slabs import rounds
from barchan.slabs.rounds import SharedRounds
from barchan.streams import Stream
from barchan.wind.segment import Segment
from tests.slabs.any_order import run_in_any_order
from tests.snow.scenes import SWITCHED_OFF, snow

STORM = {"snowfall": 2e-2, "temperature": -12.0}
OPEN = {"boundary_x": "open", "boundary_y": "open"}

COMMON = {
    "all closures": {},
    "a storm, wind along the columns": {"wind": {**STORM, "direction": 180.0}},
    "open edges": {"lattice": OPEN, "influx": {"kind": "saturation", "share": 0.7}},
    "old snow beneath": {"beneath": [{"mass": 10.0, "age": 400.0}], "abrasion": {"rate": 0.5}, "mean": 1},
    "few layers, much creep": {"layers": 2, "creep": {"gain": 8.0}, "wind": STORM},
}
RARE = {
    "creep by the threshold": {"creep": {"law": "threshold"}},
    "corners": {"neighbourhood": "moore"},
    "a threshold by chance": {"threshold": {"law": "li_pomeroy"}},
    "no closures": SWITCHED_OFF,
    "no closures, all gives": {**SWITCHED_OFF, "erosion_chance": 1.0},
    "no creep": {"creep": {"gain": 0.0}},
    "no relief": {"relief": {"acts": False}},
    "oblique": {"wind": {"direction": 250.0}},
}
SCENES = [
    *(pytest.param(scene, id=name) for name, scene in COMMON.items()),
    *(pytest.param(scene, id=name, marks=pytest.mark.extended) for name, scene in RARE.items()),
]


@pytest.fixture(autouse=True)
def threads_for_small_fields(monkeypatch):
    monkeypatch.setattr(rounds, "_LEAST_POLLS", 0)


@pytest.fixture
def runs(monkeypatch):
    """The number of threads and the end of each call that runs polls."""
    found = []
    whole = SharedRounds._run_in

    def watched(self, threads, some):
        broken = whole(self, threads, some)
        found.append((threads, self.distance, broken))
        return broken

    monkeypatch.setattr(SharedRounds, "_run_in", watched)
    return found


def on(threads, monkeypatch):
    monkeypatch.setattr("barchan.kernels.core.threads.thread_count", lambda: threads)


def assert_same(one, other):
    """All fields of two beds are the same to the bit."""
    assert one.arrays.keys() == other.arrays.keys()
    for name in one.arrays:
        np.testing.assert_array_equal(one.arrays[name], other.arrays[name], err_msg=name)


@pytest.mark.parametrize("scene", SCENES)
def test_the_bed_is_that_of_one_thread(scene, runs, monkeypatch):
    beds = []
    for threads in (1, 2, 3):
        on(threads, monkeypatch)
        simulation = snow(**scene, band_rows=4)
        simulation.advance(25)
        beds.append(simulation)
    for beside in beds[1:]:
        assert_same(beds[0].bed, beside.bed)
        assert beds[0].ledger == beside.ledger
    along_an_axis = scene.get("wind", {}).get("direction", 270.0) % 90.0 == 0.0
    assert {threads for threads, _, _ in runs} == ({1, 2, 3} if along_an_axis else {1})


def slid(quanta, monkeypatch, threads, band_rows, steps=4):
    """Bed and tally after some steps from a bed that nothing has relaxed yet."""
    on(threads, monkeypatch)
    lattice = Lattice(rows=quanta.shape[0], columns=quanta.shape[1], cell_size=0.1)
    model = Snow(Snow.Parameters(band_rows=band_rows), lattice)
    bed = Bed(lattice, np.zeros(lattice.shape), quanta, layers=model.layers)
    model.initialise(bed, 1)
    wind = Segment(0, steps, 0, lattice.cells, 270.0, speed=12.0, step_seconds=model.step_seconds)
    return bed, model.advance(bed, wind, Stream(1, "transport"))


def test_snow_that_slides_far_from_the_edge_of_a_band_makes_bands_wait_for_more(runs, monkeypatch):
    # a ridge of 24 rows with steps of 60 quanta, of 3 mm or more, where 8 cm stand: drift slides to its foot
    ridge = np.maximum(3, 720 - 60 * np.abs(np.arange(48) - 23))
    quanta = np.repeat(ridge[:, None], 32, axis=1)
    alone = slid(quanta, monkeypatch, 1, band_rows=3)
    runs.clear()
    beside = slid(quanta, monkeypatch, 2, band_rows=3)
    assert_same(alone[0], beside[0])
    assert alone[1] == beside[1]
    assert runs[0] == (2, 1, STRAYED)
    assert runs[-1][2] == 0
    assert max(distance for _, distance, _ in runs) > 1


@pytest.mark.parametrize("threads", [1, 2])
def test_no_cell_exceeds_the_heights_that_bands_go_by(threads, monkeypatch):
    seen = []
    whole = SharedRounds._plan

    def watched(self, *arguments):
        plan = whole(self, *arguments)
        seen.append((plan, self.changed()[0], plan.peaks.copy()))
        return plan

    monkeypatch.setattr(SharedRounds, "_plan", watched)
    quanta = np.random.default_rng(2).integers(20, 30, (32, 32))
    slid(quanta, monkeypatch, threads, band_rows=4, steps=5)
    (plan, surface, before), *_ = seen
    heights = surface.reshape(8, -1).max(axis=1)
    assert heights.max() > before.max()
    assert (plan.peaks >= heights).all()


def test_work_of_two_threads_that_is_interrupted_ends_and_the_next_run_moves_snow(monkeypatch):
    on(2, monkeypatch)
    simulation = snow(band_rows=4)
    whole = SharedRounds._run_in

    def interrupted(self, threads, some):
        self.lattice_rules.interruption[0] = 1
        return whole(self, threads, some)

    with monkeypatch.context() as patch:
        patch.setattr(SharedRounds, "_run_in", interrupted)
        moved = simulation.model.advance(
            simulation.bed, Segment(0, 5, 0, 1536, 270.0, speed=10.0), Stream(1, "transport")
        ).moved
    assert moved == 0
    simulation.advance(5)
    assert simulation.model.drift.state()["travel"] > 0


@pytest.mark.extended
@pytest.mark.parametrize("seed", range(4))
def test_every_order_that_a_plan_allows_gives_the_same_bits(seed, monkeypatch):
    random = np.random.default_rng(seed).integers(0, 1 << 30, 997)

    def at_random(self, _threads, some):
        plan = self._plan(2, some)
        tally = np.zeros(TALLY_SIZE, np.int64)
        run_in_any_order(*self.bed_and_rules(), self.work(), self.schedule, plan, tally, random)
        broken = plan.signals[BROKEN_OFF]
        self.counts += 0 if broken else tally
        return broken

    quanta = np.random.default_rng(seed).integers(0, 30, (60, 32))
    in_order = slid(quanta, monkeypatch, 1, band_rows=5, steps=15)
    monkeypatch.setattr(SharedRounds, "_run_in", at_random)
    monkeypatch.setattr(SharedRounds, "_useful", lambda *_: 2)
    shuffled = slid(quanta, monkeypatch, 2, band_rows=5, steps=15)
    assert_same(in_order[0], shuffled[0])
    assert in_order[1] == shuffled[1]
