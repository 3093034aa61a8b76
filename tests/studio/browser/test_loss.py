"""What the page offers after the process of a run has ended by itself."""

import os
import signal
from pathlib import Path

from tests.studio.browser.conftest import children_of


def worker_of(process) -> int:
    return next(
        p for p in children_of(process.pid) if b"spawn_main" in Path(f"/proc/{p}/cmdline").read_bytes()
    )


def test_a_lost_run_goes_on_from_the_step_that_the_server_kept(studio):
    studio.pause()
    step = studio.status()["step"]
    worker = worker_of(studio.process)
    studio.page.wait_for_timeout(6000)  # a state is kept every five seconds
    os.kill(worker, signal.SIGKILL)
    studio.page.get_by_role("button", name="go on from step").click()
    studio.until(f"!window.barchan.app.runs[0].lost && window.barchan.app.runs[0].status.step === {step}")
    assert not studio.status()["running"]
