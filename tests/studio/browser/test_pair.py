"""Two runs side by side: every picture, every pause and every look back shows both at the same step."""

import pytest

WATCH = """(() => {
    const { app, stage } = window.barchan;
    window.pictures = [];
    stage.painted.watch(() => window.pictures.push(app.runs.map((run) => run.status?.step)));
})()"""
SAME = "window.barchan.app.runs[0].status.step === window.barchan.app.runs[1].status.step"


@pytest.fixture
def pair(studio):
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 20")
    yield studio
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


@pytest.mark.extended
def test_every_picture_of_two_runs_shows_the_same_step(pair):
    pair.ask(WATCH)
    pair.until("window.pictures.length > 20")
    pair.pause()
    assert pair.ask(SAME)
    pictures = pair.ask("window.pictures")
    apart = [steps for steps in pictures if steps[0] != steps[1]]
    assert apart == []
    assert pictures[-1][0] > pictures[0][0]


@pytest.mark.extended
def test_looking_back_in_mid_run_pauses_both_at_one_step_from_which_both_go_on(pair):
    pair.page.keyboard.press("PageUp")
    pair.until("window.barchan.app.runs.every((run) => run.status.looking) && !window.barchan.app.running")
    assert pair.ask(SAME)
    pair.page.keyboard.press("End")
    pair.until("window.barchan.app.runs.every((run) => !run.status.looking)")
    assert pair.ask(SAME)
    stood = pair.status()["step"]
    pair.page.keyboard.press("Space")
    pair.step_beyond(stood + 5)
    pair.pause()
    assert pair.ask(SAME)


@pytest.mark.extended
def test_a_wind_changed_in_mid_run_is_an_event_of_the_same_step_in_both(pair):
    wind = "{ kind: 'steady', direction: 240, speed: 5, unit: 'cells' }"
    pair.ask(f"window.barchan.app.ask({{ command: 'wind', wind: {wind} }})")
    pair.until("window.barchan.app.runs.every((run) => run.description.changes.length === 1)")
    first, second = pair.ask("window.barchan.app.runs.map((run) => run.description.changes[0].step)")
    assert first == second > 20
