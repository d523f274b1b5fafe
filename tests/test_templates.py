"""Compiled templates are kept from run to run where a store is given, and are those of the present source."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from fieldspec.targets import templates

NAME = "docs/page.md.j2"
VIEW = {"identity": "1", "title": "a", "head": "", "contents": "", "sections": ""}


@pytest.fixture
def store(monkeypatch: pytest.MonkeyPatch) -> Iterator[dict[str, bytes]]:
    """The entries of a store that templates use for the test."""
    entries: dict[str, bytes] = {}
    monkeypatch.setattr(templates, "_stores", [])
    templates._environment.cache_clear()
    templates.use_cache(entries.get, entries.__setitem__)
    yield entries
    templates._environment.cache_clear()


def test_a_template_is_compiled_once_for_all_runs(store: dict[str, bytes], monkeypatch: pytest.MonkeyPatch) -> None:
    text = templates.fill(NAME, **VIEW)
    assert len(store) == 1
    templates._environment.cache_clear()
    monkeypatch.setattr("jinja2.Environment.compile", None)
    assert templates.fill(NAME, **VIEW) == text


def test_an_entry_in_another_format_is_replaced(store: dict[str, bytes]) -> None:
    text = templates.fill(NAME, **VIEW)
    ((name, content),) = store.items()
    for spoilt in (b"", b"another format" + content):
        store[name] = spoilt
        templates._environment.cache_clear()
        assert templates.fill(NAME, **VIEW) == text
        assert store[name] == content


def test_nothing_is_stored_without_a_store(store: dict[str, bytes], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(templates, "_stores", [])
    assert templates.fill(NAME, **VIEW)
    assert store == {}
