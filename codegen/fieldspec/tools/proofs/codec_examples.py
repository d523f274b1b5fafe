"""Counts the examples that use the codecs of packages, which no other proof judges."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.explain.examples import explained_anew
from fieldspec.codec.layout.device import device_layout
from fieldspec.codec.layout.package_codecs import coded_facts
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.codecs import are_loaded, uses
from fieldspec.language.model.device import Device

FEWEST = 3


def codec_exemplified(device: Device) -> Iterator[Diagnostic]:
    """A finding of each codec of a sound device that fewer printed frames use."""
    if not are_loaded():
        return
    layout = device_layout(device)
    facts = list(coded_facts(layout))
    counts = {name: 0 for _, _, name in facts}
    for example in layout.device.examples.values() if counts else ():
        if example.origin == "computed" or example.refused:
            continue
        with uses() as names:
            explained_anew(layout, example)
        for name in names:
            counts[name] += 1
    for fact, key, name in facts:
        count = counts.pop(name, FEWEST)
        if count < FEWEST:
            text = f"{count or 'no'} example{'s use' if count != 1 else ' uses'} the codec {name}"
            help = f"add printed frames until {FEWEST} have it, each with its values"
            yield Diagnostic("codec_exemplified", text, fact.place[key], help=help)
