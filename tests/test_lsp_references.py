"""`fieldspec lsp` knows where facts are defined and used, and renames them; `fieldspec show` says what uses a fact."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException

from command_line import TEST_SPECS, CommandLine
from editing import Editor, applied, copied, editor, fresh, numbers, place_of
from fieldspec.command import pipeline
from fieldspec.command.editor.projects import EditedProject
from fieldspec.language.reading.nodes import Scalar, find, identity, mappings
from fieldspec.language.reading.references import Reference, references, used_by
from fieldspec.targets import OUTPUTS

GLIDER, METER = "glider-x/device.yaml", "wattmeter/device.yaml"
OVERLAY = "wattmeter/versions/2.yaml"
ABOUT = "enums/exception_code/illegal_data_address"
NOTE = f"notes: [{{name: codes, title: Codes, text: They are few., about: [{ABOUT}], source: 1 L2}}]\n"
Spot = tuple[str, int, int, int, int]


def spot(session: Editor, location: types.Location) -> Spot:
    return location.uri.removeprefix(session.specs.as_uri() + "/"), *numbers(location.range)


def spots(name: str, text: str, pattern: str) -> set[Spot]:
    """The places of the first group of a pattern in a document."""
    matches = (match.span(1) for match in re.finditer(pattern, text, re.MULTILINE))
    return {(name, *numbers(types.Range(place_of(text, start), place_of(text, end)))) for start, end in matches}


async def used(session: Editor, name: str, position: types.Position, declaration: bool) -> set[Spot]:
    context = types.ReferenceContext(declaration)
    parameters = types.ReferenceParams(context, types.TextDocumentIdentifier(session.uri(name)), position)
    answer = await session.client.text_document_references_async(parameters)
    return {spot(session, location) for location in answer or ()}


async def defined(session: Editor, name: str, position: types.Position) -> set[Spot]:
    document = types.TextDocumentIdentifier(session.uri(name))
    answer = await session.client.text_document_definition_async(types.DefinitionParams(document, position))
    assert isinstance(answer, list)
    return {spot(session, location) for location in answer if isinstance(location, types.Location)}


async def renamed(session: Editor, name: str, position: types.Position, new_name: str) -> dict[str, str]:
    """The documents that a rename changes, with their new texts."""
    document = types.TextDocumentIdentifier(session.uri(name))
    edit = await session.client.text_document_rename_async(types.RenameParams(document, position, new_name))
    assert edit is not None
    names = {uri: uri.removeprefix(session.specs.as_uri() + "/") for uri in edit.changes or {}}
    return {names[uri]: applied(session.text(names[uri]), [*edits]) for uri, edits in (edit.changes or {}).items()}


# What names a fact of glider-x, and the name where it stands: by hand, from the file.
USES = {
    "an enum": (r"enum: (alarm)\b", r"^  - name: (alarm)$"),
    "a bit field": (r"flags: (status_word)\b", r"^  - name: (status_word)$"),
    "a record": (r"record: (refusal)\b", r"^  - name: (refusal)$"),
    "a link": (r"links?: \[?(channel)\b", r"^  - name: (channel)$"),
    "a register": (r"of: (resolution)\b", r"number: 0, name: (resolution)\b"),
    "a version": (r'(?:since|until): "(1.1)"', r'\{id: "(1.1)"'),
}


@pytest.mark.parametrize("kind", USES)
async def test_a_fact_is_found_from_where_it_is_used_and_its_uses_from_it(tmp_path: Path, kind: str) -> None:
    specs = copied(tmp_path, "glider-x")
    uses, definition = USES[kind]
    async with editor(specs) as session:
        text = session.text(GLIDER)
        expected, at = spots(GLIDER, text, uses), spots(GLIDER, text, definition)
        assert expected
        assert len(at) == 1
        for _, line, character, *_ in expected | at:
            position = types.Position(line, character)
            assert await used(session, GLIDER, position, declaration=False) == expected
            assert await used(session, GLIDER, position, declaration=True) == expected | at
            assert await defined(session, GLIDER, position) == at


async def test_a_path_leads_to_the_fact_of_the_step_under_the_pointer_also_from_overlays_to_protocols(
    tmp_path: Path,
) -> None:
    specs = copied(tmp_path, "wattmeter", "glider-x")
    async with editor(specs) as session:
        text = session.text(OVERLAY)
        ((name, line, character, *_),) = spots(OVERLAY, text, r"fact: links/(rtu)")
        ((where, *_),) = await defined(session, name, types.Position(line, character + 1))
        assert where == METER
        assert (OVERLAY, line, character, line, character + 3) in await used(
            session, name, types.Position(line, character + 1), declaration=False
        )
        text = session.text(METER) + NOTE
        await session.opened(METER, text)
        ((_, line, character, *_),) = spots(METER, text, r"about: \[enums/exception_code/(illegal_data_address)")
        ((where, *_),) = await defined(session, METER, types.Position(line, character))
        assert where.endswith("/protocols/modbus.yaml")
        text = session.text(GLIDER)
        ((_, line, character, *_),) = spots(GLIDER, text, r"references: \[parameters/(servo)/reference_speed")
        assert await defined(session, GLIDER, types.Position(line, character)) == spots(
            GLIDER, text, r"^  - name: (servo)$"
        )
        inner = types.Position(line, character + len("servo/"))
        assert await defined(session, GLIDER, inner) == spots(GLIDER, text, r"name: (reference_speed)\b")


# From a name in a file of a device to the name of the fact that it means: by hand, one of each kind.
LEADS = {
    "a bit on a path through a field": (
        ("tasks", r"wait: links/serial/response/status/(servo_off)"),
        ("device", r"name: (servo_off)"),
    ),
    "a bit on a path after an anchor": (
        ("behaviour", r"mark: &wrong links/serial/response/status/(command_error)"),
        ("device", r"name: (command_error)"),
    ),
    "a field that a step gives a value": (
        ("tasks", r"values: \{(excited): true"),
        ("commands-status", r"name: (excited), roles"),
    ),
    "a field that an example gives a value": (
        ("examples-move", r"address: 0, (status):"),
        ("device", r"name: (status)"),
    ),
    "a bit that an example has": (("examples-move", r"status: \[(executing)"), ("device", r"name: (executing)")),
    "a message by a role": (("tasks", r"send: (homing_start)"), ("commands-move", r"name: (start_homing)")),
    "a bit by a role": (("behaviour", r"show: (busy)"), ("device", r"name: (executing)")),
    "a state machine that is a condition": (
        ("behaviour", r"state/(alarm): present"),
        ("behaviour", r"name: (alarm), m"),
    ),
    "a state that a condition has": (
        ("behaviour", r"state/alarm: (present)"),
        ("behaviour", r"name: alarm, machine: \[.*\b(present)\b"),
    ),
    "a state that is entered": (
        ("behaviour", r"enter: alarm, state: (present)"),
        ("behaviour", r"name: alarm, machine: \[.*\b(present)\b"),
    ),
    "a state machine that is entered": (("behaviour", r"enter: (alarm)"), ("behaviour", r"name: (alarm), m")),
    "a parameter in a product": (
        ("behaviour", r"product: \[parameters/parameters/(negative_soft_limit)"),
        ("parameters", r"name: (negative_soft_limit)"),
    ),
}


async def test_names_in_tasks_behaviour_and_examples_lead_to_what_they_mean_and_are_uses_of_it(tmp_path: Path) -> None:
    specs = copied(tmp_path, "esc11")
    async with editor(specs) as session:
        for kind, ((file, pattern), (target_file, target_pattern)) in LEADS.items():
            name, target = f"esc11/{file}.yaml", f"esc11/{target_file}.yaml"
            place = first_spot(name, session.text(name), pattern)
            expected = first_spot(target, session.text(target), target_pattern)
            assert await defined(session, name, types.Position(place[1], place[2])) == {expected}, kind
            if "role" not in kind:  # a role is a use of the fact, but not of its name
                uses = await used(session, target, types.Position(expected[1], expected[2]), declaration=False)
                assert place in uses, kind


async def test_an_address_that_copies_of_registers_begin_at_is_no_name_of_them(tmp_path: Path) -> None:
    name = "ck10/registers-parameters.yaml"
    async with editor(copied(tmp_path, "ck10")) as session:
        place = first_spot(name, session.text(name), r"base: (0x1450)")
        assert await defined(session, name, types.Position(place[1], place[2])) == set()


def first_spot(name: str, text: str, pattern: str) -> Spot:
    """The first place of a pattern in a document."""
    return min(spots(name, text, pattern), key=lambda spot: spot[1:])


def unresolved() -> list[tuple[str, Reference]]:
    """A reference of each key in each section of the made-up devices, in their own files."""
    project = EditedProject(TEST_SPECS)
    project.read({})
    matches: dict[tuple[str, str, str], tuple[str, Reference]] = {}
    for device in ("glider-x", "widget", "flowmeter"):
        spec = project.project.devices[device]
        for reference in references(spec.tree_at(spec.versions()[-1])):
            section = reference.holder.partition("/")[0]
            own = reference.scalar.file.path.startswith(f"{device}/")
            if own and section not in ("accepts", "changes", "reviews"):
                matches.setdefault((device, section, reference.key), (device, reference))
    return [*matches.values()]


@pytest.mark.proof(16)
@pytest.mark.parametrize(("device", "reference"), unresolved(), ids=lambda part: getattr(part, "holder", part))
def test_what_the_index_takes_for_a_reference_is_one_to_the_checks(
    tmp_path: Path, device: str, reference: Reference
) -> None:
    specs = copied(tmp_path, device)
    span = reference.span
    text = span.file.text
    assert fresh(specs, {}) == []
    assert fresh(specs, {span.file.path: f"{text[: span.start]}nobody_at_all{text[span.end :]}"}) != []


RENAMED = (
    ("glider-x", "enums/alarm", "alarn"),
    ("glider-x", "signals/fault", "faulu"),
    ("glider-x", "flags/inputs", "inputt"),
    ("glider-x", "messages/read_parameter", "read_parametes"),
    ("glider-x", "registers/turns", "turnt"),
    ("glider-x", "parameters/servo", "servp"),
    ("widget", "enums/color", "colos"),
    ("widget", "records/corner", "cornes"),
    ("mover", "enums/status/executed", "executee"),
    ("mover", "links/serial/response/host", "hosu"),
    ("courier", "links/words/response/data", "datb"),
    ("esc11", "flags/communication_status/command_error", "command_erros"),
    ("esc11", "messages/set_motor_excitation/request/excited", "excitee"),
    ("esc11", "behaviour/alarm", "alarn"),
)


@pytest.mark.proof(2)
@pytest.mark.parametrize(("device", "path", "new_name"), RENAMED, ids=lambda part: part)
async def test_a_rename_changes_no_frame_and_in_the_outputs_the_name_alone(
    tmp_path: Path, device: str, path: str, new_name: str
) -> None:
    specs = copied(tmp_path, device)
    before = EditedProject(specs)
    before.read({})
    spec = before.project.devices[device]
    fact = find(spec.tree_at(spec.versions()[-1]), path)
    assert fact is not None
    name = fact.values["name"]  # type: ignore[union-attr]
    assert isinstance(name, Scalar)
    async with editor(specs) as session:
        position = place_of(name.file.text, name.start)
        texts = await renamed(session, name.file.path, position, new_name)
    assert texts
    for document, text in texts.items():
        (specs / document).write_bytes(text.encode("utf-8"))
    after = EditedProject(specs)
    after.read({})
    assert after.findings() == []
    old, new = built(before, device), built(after, device)
    assert {file: respelled(text, name.text, new_name) for file, text in old.items()} == {
        file: respelled(text, name.text, new_name) for file, text in new.items()
    }


def built(project: EditedProject, device: str) -> dict[str, str]:
    """The texts of all outputs that have names, without what counts lines of the spec."""
    layouts = pipeline.layouts(project.project.devices[device])
    names = [name for name in ("python", "c", "js", "vectors", "wireshark") if not OUTPUTS[name].refusals(layouts)]
    assert names
    files = {path: data for name in names for path, data in pipeline.output(name, layouts).items()}
    return {path: data.decode() for path, data in files.items() if not path.endswith(".xlsx")}


IDENTITY = re.compile(r"\b[0-9a-f]{16}\b")


def respelled(text: str, old: str, new: str) -> str:
    """A text in which a name is the same before and after, in all the cases of the outputs."""
    text = IDENTITY.sub("", text)  # names are part of it
    title, other_title = (name.replace("_", " ").capitalize() for name in (old, new))
    for old_case, other in ((old, new), (old.upper(), new.upper()), (title, other_title)):
        text = text.replace(old_case, other)
    camel, other_camel = (name.title().replace("_", "") for name in (old, new))
    lower, other_lower = (name[:1].lower() + name[1:] for name in (camel, other_camel))
    return text.replace(camel, other_camel).replace(lower, other_lower)


async def test_a_rename_that_breaks_something_is_refused_with_the_reason(tmp_path: Path) -> None:
    specs = copied(tmp_path, "glider-x", "wattmeter")
    async with editor(specs) as session:
        text = session.text(GLIDER)
        for pattern, new_name, reason in (
            (r"^  - name: (alarm)$", "internal_alarm", r"breaks glider-x/device\.yaml:\d+: .*internal_alarm"),
            (r"^  - name: (alarm)$", "Alarm 2", r"breaks glider-x/device\.yaml:\d+: .*Alarm 2"),
            (r"^  id: (glider-x)$", "glider-y", r"there is no name of a fact here"),
            (r"(title): Process data", "name", "there is no name of a fact here"),
        ):
            ((_, line, character, *_),) = spots(GLIDER, text, pattern)
            with pytest.raises(JsonRpcException, match=reason):
                await renamed(session, GLIDER, types.Position(line, character), new_name)
        text = session.text(METER) + NOTE
        await session.opened(METER, text)
        ((_, line, character, *_),) = spots(METER, text, r"about: \[enums/exception_code/(illegal_data_address)")
        with pytest.raises(JsonRpcException, match="belongs to an installed protocol"):
            await renamed(session, METER, types.Position(line, character), "no_address")


def test_show_says_what_uses_a_fact(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    enum_text = run("show", "glider-x", "enums/alarm").out
    assert (
        "  used by   signals/fault, messages/telegram_11/response/fault, enums/internal_alarm, "
        "parameters/profile/fault_codes, parameters/monitor/alarm_code\n"
    ) in enum_text
    examples = run("show", "glider-x", "links/channel").out
    assert re.search(r"used by .*examples/[\w-]+, \d+ more examples\n", examples)


def test_every_fact_that_is_named_elsewhere_is_used(tmp_path: Path) -> None:
    # By the texts of the file alone: an enum whose name follows `enum:` is used.
    project = EditedProject(TEST_SPECS)
    project.read({})
    for device, spec in project.project.devices.items():
        tree = spec.tree_at(spec.versions()[-1])
        users = used_by(tree)
        text = "".join(path.read_text("utf-8") for path in (TEST_SPECS / device).rglob("*.yaml"))
        for section, key in (("enums", "enum"), ("flags", "flags"), ("signals", "signal")):
            for item in mappings(tree.values.get(section)):
                name = identity(item)
                if re.search(rf"\b{key}: {name}\b(?! *[:/])", text):
                    assert users.get(f"{section}/{name}"), (device, section, name)
