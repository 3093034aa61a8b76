"""``barchan check``: is a scenario sound?"""

from barchan.cli.overrides import Tokens, pairs


def check(scenario: str, /, *values: Tokens) -> None:
    """Check a scenario without running it: every problem is reported, with where it stands.

    Prints the field's size, the number of steps, the time that the run is expected to take, and the facts
    that follow from the parameters.

    Parameters
    ----------
    scenario
        A scenario file, a preset's name, or a run's folder.
    """
    from barchan.archive import source_at
    from barchan.cli.terminal import console, print_note
    from barchan.scenario.cost import spoken_time
    from barchan.scenario.effects import can_move, refuse_weather
    from barchan.scenario.files import load_scenario
    from barchan.scenario.settling import settling_seconds
    from barchan.scenario.summary import field_size
    from barchan.simulation.memory import in_words, memory_needed, refuse_too_large

    sound = load_scenario(source_at(scenario), pairs(values, check)).seeded()
    refuse_too_large(sound)
    model = sound.new_model()
    with sound.source_map.locating_errors():
        sound.forcing().wind_of(0)
        refuse_weather(sound, sound.wind)
        bed = sound.first_bed()
        model.initialise(bed, sound.seed)
    still = sound.run.steps > 0 and not can_move(sound)
    remarks = sound.remarks(bed.ground)
    console.print(f"{scenario}: {_verdict(still, len(remarks))}")
    console.print(f"field: {field_size(sound)}")
    console.print(f"steps: {sound.run.steps}")
    console.print(f"expected time: {spoken_time(sound, settling_seconds(model, bed))}")
    console.print(f"memory: about {in_words(memory_needed(sound))}")
    for name, fact in {**sound.facts(), **sound.forecast()}.items():
        console.print(f"{name}: {fact}")
    for remark in remarks:
        print_note(remark)


def _verdict(still: bool, remarks: int) -> str:
    if still:
        return "without mistakes, but nothing moves"
    return "sound" + (f", with {remarks} note{'s' * (remarks > 1)}" if remarks else "")
