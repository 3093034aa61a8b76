"""``barchan parameters``: every key of a scenario."""

from barchan.scenario.listing import all_keys


def test_every_key_is_listed_with_its_meaning(barchan):
    out = barchan("parameters").out
    for key in all_keys():
        assert f"  {key.key}  " in out
        assert key.meaning in out


def test_only_keys_that_begin_alike_are_listed(barchan):
    out = barchan("parameters", "run.until").out
    keys = [line.split()[0] for line in out.splitlines() if line.startswith("  run")]
    assert keys == ["run.until.idle_steps", "run.until.steady.window", "run.until.steady.tolerance"]


def test_dashes_are_as_good_as_underscores(barchan):
    assert barchan("parameters", "model.hop-length").out == barchan("parameters", "model.hop_length").out


def test_a_key_is_listed_with_unit_default_bounds_source_and_whether_it_may_change(barchan):
    out = barchan("parameters", "model.hop_length").out
    assert "model.hop_length  default 5.0 cells; number > 0 and ≤ 100000, may change during a run" in out
    assert "(Werner 1995; Prague thesis, Table 6.1)" in out


def test_what_may_be_left_out_is_not_called_required(barchan):
    assert "run.seed  default null; whole number" in barchan("parameters", "run.seed").out
    assert "sand.parts[].mean  required; number" in barchan("parameters", "sand.parts").out


def test_a_word_is_searched_in_names_and_meanings(barchan):
    """The shadow zone by its keys' names; the repose angle by a word of its meaning only."""
    shadow = {line.split()[0] for line in barchan("parameters", "shadow").out.splitlines() if line[2:3] > " "}
    assert {"model.shadow_angle", "model.shadow_from", "model.lee_erosion"} <= shadow
    seeds = barchan("parameters", "random numbers").out
    assert "run.seed" in seeds
    assert "model.hop_length" not in seeds


def test_the_name_of_a_model_or_of_a_wind_lists_its_keys(barchan):
    momiji = {line.split()[0] for line in barchan("parameters", "momiji").out.splitlines() if line[2:3] > " "}
    assert {"model.hop_length", "model.speedup_linear", "model.hop_rounding"} <= momiji
    assert "model.erosion_chance" not in momiji
    storms = {line.split()[0] for line in barchan("parameters", "storms").out.splitlines() if line[2:3] > " "}
    assert {"wind.storm_spread", "wind.quiet_days", "wind.gusts.intensity"} <= storms
    assert "wind.regimes" not in storms


def test_a_word_that_is_nowhere_is_told(barchan):
    failed = barchan("parameters", "xyzzy")
    assert failed.code == 1
    assert "no key begins with 'xyzzy', and no name or meaning has it" in failed.err
