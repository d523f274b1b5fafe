"""No codec answers otherwise than recorded: a share of the facts here, all of them with `make frozen`."""

from __future__ import annotations

import os
import warnings
from hashlib import sha256

import pytest

from frozen.digests import INPUTS, differences, digests, digests_path, distinct_layouts, recorded, text_of
from frozen.inputs import facts

IS_WHOLE = os.environ.get("FIELDSPEC_FROZEN") == "all"
SHARE = 30
"""Of so many facts, one is in the share of the suite, by its path."""
SHARED = (("tc100", "2.0"), ("widget", "2.0"))
LEAST_INPUTS = 1_000_000
MOST_INPUTS = 6_000
"""Inputs of one fact, so that all answers take minutes."""


@pytest.mark.parametrize(("device", "version"), sorted(distinct_layouts()) if IS_WHOLE else SHARED)
def test_every_codec_answers_as_recorded(device: str, version: str, accept: bool) -> None:
    layout = distinct_layouts()[device, version]
    chosen = [fact for fact in facts(layout) if IS_WHOLE or _is_shared(fact.path)]
    now, path = digests(layout, chosen), digests_path(device, version)
    if accept:
        path.parent.mkdir(exist_ok=True)
        others = {} if IS_WHOLE else recorded(path)
        path.write_text(text_of(others | now), "utf-8", newline="\n")
    old = {fact: own for fact, own in recorded(path).items() if IS_WHOLE or _is_shared(fact)}
    result = differences(old, now)
    if result.new:
        warnings.warn(f"{device} {version}: new, and not recorded: {', '.join(result.new)}", stacklevel=1)
    program = f"python tests/frozen/answers.py {device} {version} CODEC FACT --against main"
    assert result.changed == [], f"see `{program}`; if all of this should change, use --accept"


def _is_shared(path: str) -> bool:
    return sha256(path.encode()).digest()[0] % SHARE == 0


def test_there_are_enough_inputs_and_not_too_many_of_one_fact() -> None:
    counts = [
        int(own[INPUTS].partition(":")[0])
        for device, version in distinct_layouts()
        for own in recorded(digests_path(device, version)).values()
    ]
    assert sum(counts) >= LEAST_INPUTS
    assert max(counts) <= MOST_INPUTS


OLD = {"records/point": {INPUTS: "3:aa", ("values", "r"): "11", ("values", "p"): "11", ("again", "c"): "22"}}


def test_another_answer_is_named_by_its_fact_its_aspect_and_its_codec() -> None:
    now = {"records/point": OLD["records/point"] | {("values", "p"): "12"}}
    assert differences(OLD, now).changed == ["records/point: values of python"]


def test_a_new_fact_and_a_new_codec_are_no_changes_of_answers() -> None:
    now = {"records/line": {INPUTS: "1:bb"}, "records/point": OLD["records/point"] | {("values", "j"): "13"}}
    result = differences(OLD, now)
    assert result.changed == []
    assert result.new == ["records/line", "records/point: values of javascript"]


def test_an_answer_that_is_no_longer_there_is_a_change() -> None:
    now = {"records/point": {key: digest for key, digest in OLD["records/point"].items() if key[0] != "again"}}
    assert differences(OLD, now).changed == ["records/point: again of c"]
    assert differences(OLD, {}).changed == ["records/point: there is no such fact any more"]


def test_other_inputs_are_told_from_other_answers() -> None:
    now = {"records/point": {INPUTS: "3:ab", ("values", "r"): "19"}}
    assert differences(OLD, now).changed == ["records/point: other inputs than those that were recorded, 3:ab"]


def test_codecs_that_agree_share_a_digest_in_the_file() -> None:
    assert text_of(OLD) == "records/point 3:aa again=c:22 values=pr:11\n"
