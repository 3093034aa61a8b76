"""``barchan check``: is a scenario sound?"""

from barchan.cli.overrides import Tokens, pairs


def check(scenario: str, /, *values: Tokens) -> None:
    """Check a scenario without running it: every problem is reported, with where it stands.

    Parameters
    ----------
    scenario
        A scenario file, a preset's name, or a run's folder.
    """
    from barchan.archive import source_at
    from barchan.cli.terminal import console, print_note
    from barchan.scenario.files import load_scenario

    sound = load_scenario(source_at(scenario), pairs(values, check)).seeded()
    model = sound.new_model()
    with sound.source_map.locating_errors():
        sound.forcing().wind_of(0)
        bed = sound.first_bed()
        model.initialise(bed, sound.seed)
    console.print(f"{scenario}: sound")
    for name, fact in {**sound.ground_facts(), **sound.time_facts(), **model.facts()}.items():
        console.print(f"{name}: {fact}")
    for remark in sound.remarks(bed.ground):
        print_note(remark)
