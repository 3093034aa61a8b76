"""Every key a scenario may have, with its declaration: for help, documentation and panels."""

from collections.abc import Iterator
from dataclasses import dataclass

from barchan.parameters import Declaration, declarations, variants
from barchan.scenario.definition import Scenario

TOP = "scenario"


@dataclass(frozen=True)
class Key(Declaration):
    """A key of a scenario and the group or variant it belongs to."""

    heading: str


def all_keys() -> Iterator[Key]:
    """Every key, in the order of a scenario; keys of variants are listed under each of them."""
    for name, field in Scenario.model_fields.items():
        groups = variants(field.annotation)
        if not groups and name != "note":
            yield from (_key(d, TOP) for d in declarations(Scenario) if d.key == name)
        for group in groups:
            tag = group.model_fields[group.kind_key].default if group.kind_key else ""
            heading = f'{name}, {group.kind_key} "{tag}"' if tag else name
            yield from (_key(d, heading) for d in declarations(group, f"{name}."))


def _key(declaration: Declaration, heading: str) -> Key:
    return Key(**vars(declaration), heading=heading)
