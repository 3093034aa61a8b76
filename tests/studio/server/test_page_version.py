"""A page of another version is named in the terminal before a browser opens it."""

import pytest

from barchan.errors import BarchanError
from barchan.studio.protocol import PROTOCOL
from barchan.studio.server.app import CLIENT
from barchan.studio.server.page_version import check_page

PAGE = '<!doctype html><html><head><meta name="barchan-protocol" content="{}"></head></html>'


def test_a_page_of_another_protocol_is_refused_with_both_numbers_and_the_way_out(tmp_path):
    (tmp_path / "index.html").write_text(PAGE.format(PROTOCOL - 1))
    with pytest.raises(BarchanError) as refusal:
        check_page(tmp_path)
    told = str(refusal.value)
    assert f"speaks protocol {PROTOCOL - 1}, this version {PROTOCOL}" in told
    assert "install" in told


def test_a_page_that_is_missing_is_refused(tmp_path):
    with pytest.raises(BarchanError, match="not built"):
        check_page(tmp_path)


def test_a_page_of_this_protocol_and_one_that_states_none_are_served(tmp_path):
    (tmp_path / "index.html").write_text(PAGE.format(PROTOCOL))
    check_page(tmp_path)
    (tmp_path / "index.html").write_text("<!doctype html>")
    check_page(tmp_path)


def test_the_build_states_its_protocol():
    if not (CLIENT / "index.html").is_file():
        pytest.skip("the client is not built")
    check_page(CLIENT)
    assert f'<meta name="barchan-protocol" content="{PROTOCOL}">' in (CLIENT / "index.html").read_text(
        "utf-8"
    )
