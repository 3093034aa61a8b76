"""Interruptions, and how long work shows its progress."""

import io
import os
import signal

import pytest
from rich.console import Console

from barchan.cli import terminal
from barchan.cli.terminal import Interrupts, Reporter
from barchan.simulation import Simulation
from tests.tiny import tiny


@pytest.fixture
def printed(monkeypatch):
    """What is printed where the output is, or is not, a terminal."""

    def output(is_terminal):
        text = io.StringIO()
        console = Console(file=text, force_terminal=is_terminal, highlight=False, width=200)
        monkeypatch.setattr(terminal, "console", console)
        return text

    return output


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_the_first_signal_is_a_wish_to_stop(number):
    with Interrupts().watched() as stop:
        assert not stop()
        os.kill(os.getpid(), number)
        assert stop()


def test_the_second_signal_ends_the_program():
    with Interrupts().watched():
        os.kill(os.getpid(), signal.SIGINT)
        with pytest.raises(KeyboardInterrupt):
            os.kill(os.getpid(), signal.SIGINT)


def test_signals_are_listened_to_only_while_there_is_something_to_save():
    before = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)
    with Interrupts().watched():
        assert signal.getsignal(signal.SIGINT) != before[0]
    assert (signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)) == before


def report(seconds, quiet, monkeypatch):
    """Report on a run in which every step takes so long."""
    clock = iter(range(0, 1000 * seconds, seconds))
    monkeypatch.setattr("barchan.cli.terminal.time.monotonic", lambda: float(next(clock)))
    simulation = Simulation(tiny())
    with Reporter(simulation, quiet) as reporter:
        for _ in range(4):
            simulation.advance(5)
            reporter(simulation)
    return simulation


def test_long_work_prints_a_line_now_and_then_where_there_is_no_terminal(printed, monkeypatch):
    text = printed(is_terminal=False)
    simulation = report(10, False, monkeypatch)
    lines = text.getvalue().splitlines()
    assert len(lines) == 4
    assert lines[-1] == (
        f"step 20 of 20, 0 steps/s, 0 s left, highest stack {simulation.bed.sand.max()} slabs"
    )


def test_short_work_prints_nothing_where_there_is_no_terminal(printed, monkeypatch):
    text = printed(is_terminal=False)
    report(1, False, monkeypatch)
    assert text.getvalue() == ""


@pytest.mark.parametrize("is_terminal", [True, False])
def test_quiet_work_prints_nothing(printed, monkeypatch, is_terminal):
    text = printed(is_terminal)
    report(10, True, monkeypatch)
    assert text.getvalue() == ""


def test_a_terminal_shows_a_bar_with_speed_and_highest_stack(printed):
    text = printed(is_terminal=True)
    simulation = Simulation(tiny())
    with Reporter(simulation, quiet=False) as reporter:
        for _ in range(4):
            simulation.advance(5)
            reporter(simulation)
    assert "20/20" in text.getvalue()
    assert "steps/s" in text.getvalue()
    assert f"highest stack {simulation.bed.sand.max()} slabs" in text.getvalue()


def test_compilation_is_announced_once_and_not_when_quiet(printed):
    from numba.core import event

    for quiet, said in ((False, 1), (True, 0)):
        text = printed(is_terminal=False)
        with terminal.compilation_announced(quiet):
            for _ in range(3):
                event.broadcast(event.Event("numba:compile", event.EventStatus.START))
                event.broadcast(event.Event("numba:compile", event.EventStatus.END))
        assert text.getvalue().count("compiling kernels") == said


@pytest.mark.parametrize(
    ("report", "lines"),
    [
        ("slopes relax: 1,204 slabs have slid, 30 cells still to be checked", 1),
        ("slopes relax: 1,204 slabs have slid, 1,000 cells still to be checked", 1),
        ("slopes relax: 1,204 slabs have slid, 0 cells still to be checked", 0),
        ("grains fall: 0 of them are in the air", 0),
        ("the ground is being read", 1),
    ],
)
def test_progress_is_printed_as_long_as_its_last_count_is_of_work_left(report, lines, printed, monkeypatch):
    text = printed(False)
    monkeypatch.setattr("barchan.cli.terminal._UNANNOUNCED", 0.0)
    with terminal.work_announced(quiet=False):
        from barchan.kernels.core import progress

        progress.report(report)
    assert text.getvalue().count("\n") == lines
