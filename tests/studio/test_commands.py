"""One table of commands: every row has exactly one function, and the client knows the same names."""

import pytest

from barchan.errors import BarchanError
from barchan.studio.commands import CLIENT_FILE, COMMANDS, Handlers, client_names, command_of
from barchan.studio.server.queries import QUERIES
from barchan.studio.server.session_commands import SESSION
from barchan.studio.worker.commands import WORKER


def test_every_command_of_the_table_has_exactly_one_function():
    registered = [*WORKER.functions, *SESSION.functions, *QUERIES.functions]
    assert sorted(registered) == sorted(COMMANDS)


def test_a_function_for_a_command_of_another_owner_is_refused():
    session = Handlers("session")
    with pytest.raises(ValueError, match="'pause' is not one of the session"):
        session.handles("pause")
    with pytest.raises(KeyError):
        session.handles("dance")
    with pytest.raises(ValueError, match="has a function already"):
        WORKER.handles("pause")


def test_a_command_that_needs_a_run_is_refused_without_one():
    assert command_of("create", has_run=False).owner == "session"
    with pytest.raises(BarchanError, match="there is no run yet"):
        command_of("pause", has_run=False)
    for name in ("dance", None, 5, ["run"]):
        with pytest.raises(BarchanError, match="unknown command"):
            command_of(name)


@pytest.mark.skipif(not CLIENT_FILE.parent.is_dir(), reason="the client's sources are not here")
def test_the_client_has_the_names_of_the_table():
    """Where this fails: ``python -m barchan.studio.commands``."""
    assert CLIENT_FILE.read_text("utf-8") == client_names()


def test_the_client_cannot_name_commands_that_only_the_server_gives():
    assert '"save_folder"' not in client_names()
    assert '"save"' in client_names()
