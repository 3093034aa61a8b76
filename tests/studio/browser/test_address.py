"""The address of the page: what stands in it, and what the browser finds again."""


def test_the_token_leaves_the_address_and_a_reload_still_opens_the_studio(studio):
    assert "token" not in studio.page.url
    assert studio.ask("history.length") <= 2
    studio.page.reload()
    studio.step_beyond(-1)
    assert "token" not in studio.page.url
