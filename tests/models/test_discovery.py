"""Models are found, never listed."""

import pkgutil
from typing import Literal

import pytest

import barchan.models
from barchan.errors import BarchanError
from barchan.models import Model, model, model_names, models
from barchan.models.werner import Werner, WernerParameters
from barchan.parameters import parameter


class ElsewhereParameters(WernerParameters):
    """Parameters of a model that another package brings."""

    name: Literal["elsewhere"] = parameter("elsewhere", unit="-", meaning="A model of another package.")


class Elsewhere(Werner):
    """A model that another package brings."""

    name = "elsewhere"
    Parameters = ElsewhereParameters


class Point:
    """An entry point of another package."""

    name, value = "elsewhere", "package:Elsewhere"

    @staticmethod
    def load():
        return Elsewhere


class Nameless(Werner):
    """A model without a name."""

    name = ""


class Misnamed(Werner):
    """A model whose parameters are called otherwise."""

    name = "misnamed"


def entry_point(load):
    """An entry point of another package that loads in some way."""
    return type("Broken", (), {"name": "broken", "value": "package:Broken", "load": staticmethod(load)})


def _fails():
    raise ImportError("No module named 'nowhere'")


def test_werners_model_is_found_under_its_name():
    assert model("werner") is Werner
    assert "werner" in model_names()


def test_names_are_in_order_and_belong_to_their_models():
    assert model_names() == sorted(model_names())
    assert all(name == found.name for name, found in models().items())


def test_every_named_model_in_the_folder_is_found():
    files = {f"barchan.models.{module.name}" for module in pkgutil.iter_modules(barchan.models.__path__)}
    named = {found for found in _all_subclasses(Model) if found.name and found.__module__ in files}
    assert named <= set(models().values())


def test_models_of_other_packages_are_found_by_their_entry_points(monkeypatch):
    monkeypatch.setattr(barchan.models, "entry_points", lambda group: [Point])
    assert models.__wrapped__()["elsewhere"] is Elsewhere


@pytest.mark.parametrize(
    ("load", "reason"),
    [
        (_fails, "ImportError: No module named 'nowhere'"),
        (lambda: 3, "it is not a class derived from barchan.models.Model"),
        (lambda: Nameless, "it has no name"),
        (lambda: Misnamed, "its Parameters lack the key name with the only value 'misnamed'"),
    ],
)
def test_a_model_of_another_package_that_cannot_be_used_is_named_and_left_out(monkeypatch, load, reason):
    monkeypatch.setattr(barchan.models, "entry_points", lambda group: [entry_point(load), Point])
    with pytest.warns(UserWarning, match=r"broken \(package:Broken\) is left out") as caught:
        found = models.__wrapped__()
    assert reason in str(caught[0].message)
    assert "elsewhere" in found
    assert "werner" in found


def test_two_models_of_one_name_are_an_error(monkeypatch):
    class Twice:
        name, value = "twice", "package:Werner"
        load = staticmethod(lambda: Werner)

    monkeypatch.setattr(barchan.models, "entry_points", lambda group: [Twice])
    with pytest.raises(BarchanError, match="two models are called 'werner'; the second is package:Werner"):
        models.__wrapped__()


def test_an_unknown_model_is_a_key_error():
    with pytest.raises(KeyError):
        model("wernr")


def test_every_model_says_what_it_is():
    for found in models().values():
        assert found.title
        assert found.citation
        assert found.__doc__


def _all_subclasses(cls):
    return {cls}.union(*(_all_subclasses(child) for child in cls.__subclasses__()))
