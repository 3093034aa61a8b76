"""``barchan schema``: the JSON schema of scenarios."""


def schema() -> None:
    """Print the JSON schema of scenarios, for editors that complete and check JSON."""
    import json

    from barchan.cli.terminal import console
    from barchan.scenario import Scenario

    console.out(json.dumps(Scenario.model_json_schema(), indent=2, ensure_ascii=False), highlight=False)
