from barchan.simulation import StepPacer


def test_the_number_of_steps_at_most_doubles_until_it_takes_the_time_that_was_asked_for():
    pacer = StepPacer(0.1)
    found = []
    for _ in range(8):
        found.append(pacer.steps)
        pacer.record(pacer.steps, pacer.steps * 0.004)
    assert found == [1, 2, 4, 8, 16, 25, 25, 25]


def test_slow_steps_are_done_one_by_one_and_none_teaches_nothing():
    pacer = StepPacer(0.1)
    pacer.record(1, 3.0)
    assert pacer.steps == 1
    pacer.record(1, 0.01)
    pacer.record(0, 9.0)
    assert pacer.steps == 2
