"""Random devices: all codecs agree with the reference on them, and on those that broke something once."""

from __future__ import annotations

import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml

from layouts import TEST_SPECS
from proofs import IS_WHOLE
from random_devices.agreement import JUDGES, Judge, compare
from random_devices.fuzz import CASES, batch
from random_devices.key_counts import BATCH, KeyCounts, drawn, is_clean
from random_devices.queries import Answer, Query
from random_devices.schema_keys import KEYS, MAPPINGS, key_path, known_keys

SEEDS = (4, 9, 12)
"""All judges are asked about a device of the first."""
COUNT = 12
CHEAP = 8 if IS_WHOLE else 1
"""Judges that are asked about each device, or about one of so few, cost less than the others."""
MOST = 2000
"""Devices that are drawn until each key of the language is in enough of them."""
RICH = (18, 9, 1, 11, 0, 14, 10, 6)
"""Seeds whose devices have all keys together, chosen from those that `fuzz.py --statistics 2000` finds. Where what is
drawn has changed, the others follow after them, which takes minutes.
"""


@pytest.mark.proof(1)
@pytest.mark.parametrize("number", SEEDS)
def test_all_codecs_agree_on_random_devices(number: int) -> None:
    tally = batch(number, COUNT, frames=60)
    assert tally.cases == {}
    # Warnings count too: some of what is drawn looks like a slip.
    assert tally.clean * 3 > tally.devices
    assert tally.frames > 20 * tally.clean


def judges_of(text: str) -> tuple[Judge, ...]:
    """Who is asked about a case: who disagreed, and who costs little; all of them where the compiler was wrong."""
    name = text.removeprefix("# ").partition(":")[0]
    if name not in {judge.name for judge in JUDGES}:
        return JUDGES
    judges = (replace(judge, every=1) if judge.name == name else judge for judge in JUDGES)
    return tuple(judge for judge in judges if judge.every <= CHEAP)


@pytest.mark.proof(8)
@pytest.mark.parametrize("case", sorted(CASES.glob("*.yaml")), ids=lambda path: path.stem)
def test_what_broke_something_once_breaks_nothing_now(case: Path) -> None:
    text = case.read_text(encoding="utf-8")
    spec = yaml.safe_load(text)
    own = re.search(r"^# seed (\d+)$", text, re.MULTILINE)
    for number in [int(own[1])] if own else (1, 2):
        result = compare(spec, number, 60, judges_of(text))
        assert result.findings == ()
        assert result.disagreements == []


@pytest.mark.parametrize("device", ["courier", "herald", "spindle", "submeter", "surveyor", "tracker"])
def test_all_codecs_agree_on_frames_of_others(device: str) -> None:
    spec = yaml.safe_load((TEST_SPECS / device / "device.yaml").read_text("utf-8"))
    spec["device"]["id"] = "chance"
    judges = JUDGES if device == "courier" or IS_WHOLE else tuple(judge for judge in JUDGES if judge.every <= CHEAP)
    result = compare(spec, 1, 60, judges)
    assert result.findings == ()
    assert result.disagreements == []


TRUTHS = """
device:
  {id: chance, name: Chance, vendor: Nobody, manual: {title: T, file: t.txt, sha256: "%s", lines: 99}}
enums:
  - {name: states, source: 1 L3, open: true, members: [{name: ready, value: 1, source: 1 L3}]}
  - name: ways
    source: 1 L4
    open: true
    members: [{name: back, value: 0, source: 1 L4, unavailable: true}, {name: forth, value: 1, source: 1 L4}]
links:
  - name: image
    source: 1 L1
    byte_order: big
    request: [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: [{name: code, role: code, type: u8}, {name: body, role: body}]
messages:
  - name: put
    code: 1
    source: 1 L2
    request: [{name: state, type: bool8, enum: states}, {name: way, type: bool8, enum: ways}, {name: tail, type: u8}]
    response: []
""" % ("0" * 64)


def test_codecs_and_explainers_take_truth_values_that_open_enums_do_not_list() -> None:
    names = ("python", "javascript", "explainer", "script")
    result = compare(yaml.safe_load(TRUTHS), 7, 60, tuple(judge for judge in JUDGES if judge.name in names))
    assert (result.findings, result.asked, result.disagreements) == ((), dict.fromkeys(names, 1), [])


class Forgetful:
    """A judge that takes a byte of every frame for another one."""

    def __init__(self, *_: Any) -> None:
        pass

    def answers(self, queries: list[Query]) -> list[Answer]:
        return [Answer(again="00") for _ in queries]


def test_a_wrong_codec_is_noticed_on_a_device_that_is_shrunk() -> None:
    tally = batch(1, 20, (Judge("forgetful", 1, Forgetful),), frames=9)
    ((disagreement, text),) = tally.cases.items()
    assert disagreement.startswith("forgetful: ")
    assert len(yaml.safe_load(text)["links"]) == 1


def test_every_key_of_the_language_is_in_random_devices_or_has_a_reason_why_not() -> None:
    every, judged = KeyCounts(), KeyCounts()
    others = [number for number in range(MOST // BATCH) if number not in RICH]
    for batches, number in enumerate([*RICH, *others], 1):
        for spec in drawn(number):
            every.add_device(spec)
            # The others would show nothing new, and to judge a device takes longer than to draw it.
            if judged.lacks(spec) and is_clean(spec):
                judged.add_device(spec)
        frequent = {key for key, count in every.keys.items() if count > every.clean // 10}
        absent = [form for form in judged.absent_forms(0) if key_path(form) in frequent]
        if batches >= len(RICH) and not judged.seldom(1) and not absent:
            break
    assert judged.seldom(1) == {}
    assert absent == []


def test_a_seed_draws_the_same_devices_whatever_is_imported() -> None:
    code = "from random_devices.key_counts import drawn; print(drawn(1, 3))"
    folder = Path(__file__).parent.parent
    alone = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, check=True)
    assert alone.stdout == f"{drawn(1, 3)}\n"


def test_a_reason_is_about_a_key_that_there_is() -> None:
    known = known_keys()
    assert set(KEYS) <= known.keys()
    assert set(MAPPINGS) <= {owner for owner, _ in known}


def test_the_table_of_judges_has_every_codec() -> None:
    assert [judge.name for judge in JUDGES][:2] == ["python", "access"]
