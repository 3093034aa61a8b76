"""``barchan schema``: the JSON schema of scenarios."""


def schema() -> None:
    """Print the JSON schema of scenarios, for editors that complete and check JSON."""
    import json

    from barchan.cli.terminal import console
    from barchan.scenario import Scenario

    stated = {"required": ["barchan"]}  # a file states its format, which a Scenario made in Python knows
    schema = {**Scenario.model_json_schema(), **stated}
    console.out(json.dumps(schema, indent=2, ensure_ascii=False), highlight=False)
