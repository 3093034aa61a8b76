"""``barchan studio``: what the browser opens."""

import pytest

from barchan.studio.server import launch


@pytest.fixture
def opened(monkeypatch, tmp_path, barchan):
    """The address that the browser is given for arguments of the command; nothing is served."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.setattr(launch, "check_page", lambda _: None)

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(launch, "_server", interrupted)

    def address(*arguments: str) -> str:
        found: list[str] = []
        monkeypatch.setattr(launch.webbrowser, "open", found.append)
        barchan("studio", *arguments, "--port", "0", "--folder", tmp_path)
        return found[0]

    return address


def test_without_a_name_the_studio_opens_its_gallery(opened):
    assert opened().endswith("#gallery")
    assert "#" not in opened("barchans")
