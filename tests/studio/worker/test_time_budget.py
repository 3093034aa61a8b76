import time

from barchan.studio.worker.time_budget import TimeBudget


def test_a_task_that_took_long_waits_in_proportion():
    budget = TimeBudget(0.1)
    assert budget.is_due
    began = time.perf_counter()
    with budget.spending():
        time.sleep(0.02)
    now = time.perf_counter()
    assert not budget.is_due
    assert 10 * 0.02 - (now - began) < budget.due - now < 10 * (now - began)
    budget.at_once()
    assert budget.is_due


def test_a_task_that_took_no_time_waits_for_the_least_pause():
    budget = TimeBudget(0.5, least_pause=10.0)
    with budget.spending():
        pass
    assert 9.0 < budget.due - time.perf_counter() <= 10.0
