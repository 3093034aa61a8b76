"""Models are found, never listed."""

import pkgutil

import pytest

import barchan.models
from barchan.errors import BarchanError
from barchan.models import Model, model, model_names, models
from barchan.models.werner import Werner


class Elsewhere(Werner):
    """A model that another package brings."""

    name = "elsewhere"


class Point:
    """An entry point of another package."""

    @staticmethod
    def load():
        return Elsewhere


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


def test_two_models_of_one_name_are_an_error(monkeypatch):
    class Twice:
        value = "package:Werner"
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
