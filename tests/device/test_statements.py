"""Each statement of a manual that a simulator carries out is shown by a scene, and not without its part."""

from __future__ import annotations

import pytest

from fieldspec.language.behaviour.part import NOT_MODELLED
from simulators import parts_of
from stage import Stage, scenes

DEVICES = ("tc100", "ck10", "esc11", "hiwin-e")
SCENES = [(device, scene) for device in DEVICES for scene in scenes(device)]


@pytest.mark.proof(33)
@pytest.mark.parametrize(("device", "scene"), SCENES, ids=[f"{device}-{scene['scene']}" for device, scene in SCENES])
def test_the_device_does_what_the_scene_says(device: str, scene: dict[str, object]) -> None:
    Stage(device, scene).play(scene)


@pytest.mark.proof(27)
@pytest.mark.parametrize(
    ("device", "scene", "part"),
    [(device, scene, part) for device, scene in SCENES for part in scene["shows"]],
    ids=[f"{device}-{part}-{scene['scene']}" for device, scene in SCENES for part in scene["shows"]],
)
def test_the_scene_fails_without_a_part_that_it_shows(device: str, scene: dict[str, object], part: str) -> None:
    with pytest.raises((AssertionError, KeyError)):
        Stage(device, scene, without=part).play(scene)


@pytest.mark.parametrize("device", DEVICES)
def test_every_modelled_statement_is_shown_by_a_scene(device: str) -> None:
    names = {part for scene in scenes(device) for part in scene["shows"]}
    versions = {device, *(scene.get("device", device) for scene in scenes(device))}
    parts = [part for version in versions for part in parts_of(version)[1].parts if part.standing != NOT_MODELLED]
    stated = {part.name for part in parts if part.sources and (part.kind, part.get("if")) != ("accept", None)}
    assert sorted(stated - names) == []
    assert sorted(names - {part.name for part in parts}) == []
