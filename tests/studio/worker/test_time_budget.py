import time

from barchan.studio.worker.time_budget import Ration


def test_what_took_long_waits_in_proportion():
    ration = Ration(0.1)
    assert ration.is_due
    began = time.perf_counter()
    with ration.spending():
        time.sleep(0.02)
    now = time.perf_counter()
    assert not ration.is_due
    assert 10 * 0.02 - (now - began) < ration.due - now < 10 * (now - began)
    ration.at_once()
    assert ration.is_due
