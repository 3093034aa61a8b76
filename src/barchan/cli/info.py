"""``barchan info``: what a run holds."""

from pathlib import Path


def info(run: Path, /) -> None:
    """Tell what a run holds and how far it is.

    Parameters
    ----------
    run
        The run's folder.
    """
    from barchan.archive import run_info
    from barchan.cli.report import print_table, resume_command

    known = run_info(run)
    scenario = known.scenario
    lattice = scenario.lattice
    facts = scenario.new_model().facts()
    state = known.stopped or f"not finished; go on with: {resume_command(run)}"
    rows = [
        ("title", scenario.title or "–"),
        ("model", scenario.model.name),
        ("field", f"{lattice.columns} × {lattice.rows} cells of {lattice.cell_size:g} m"),
        ("slab height", f"{lattice.thickness:.4g} m"),
        *scenario.time_facts().items(),
        *facts.items(),
        ("wind", scenario.wind.summary()),
        ("seed", str(scenario.run.seed)),
        ("frames", f"{known.frames}, the last at step {known.last_step} of {scenario.run.steps}"),
        ("checkpoint", "none" if known.checkpoint is None else f"step {known.checkpoint}"),
        ("state", state),
        ("size", f"{known.bytes / 1e6:.1f} MB"),
    ]
    print_table([(name, value, "") for name, value in rows], left=True)
