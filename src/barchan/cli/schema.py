"""``barchan schema``: the JSON schema of scenarios."""


def schema() -> None:
    """Print the JSON schema of scenarios, for editors that complete and check JSON."""
    import json

    from barchan.cli.terminal import console
    from barchan.scenario import Scenario
    from barchan.scenario.from_ground import FROM_GROUND
    from barchan.scenario.from_record import RECORD

    stated = {"required": ["barchan"]}  # a file states its format, which a Scenario made in Python knows
    schema = {**Scenario.model_json_schema(), **stated}
    lattice, kind = schema["properties"]["lattice"], schema["$defs"]["Lattice"]["properties"]["kind"]
    lattice["anyOf"] = [{"$ref": lattice.pop("$ref")}, {"const": FROM_GROUND}]
    kind["enum"] = [*kind["enum"], FROM_GROUND]
    steps = schema["$defs"]["Run"]["properties"]["steps"]
    whole = {key: steps.pop(key) for key in ("type", "minimum", "maximum")}
    steps["anyOf"] = [whole, {"const": RECORD}]
    console.out(json.dumps(schema, indent=2, ensure_ascii=False), highlight=False)
