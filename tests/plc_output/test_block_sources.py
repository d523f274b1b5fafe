"""Faults in the sources of blocks are refused, with their place and what may be meant."""

from __future__ import annotations

import pickle
import re
from collections.abc import Iterator

import pytest

from compiler_modules import PACKAGE
from fieldspec.targets import templates
from fieldspec.targets.controllers.sources import expansion
from fieldspec.targets.controllers.sources.nodes import SourceError
from fieldspec.targets.iec import backend
from layouts import SPECS, newest

# A source, what stands there, what is planted in its place with the word that is marked in « », and what is said.
FAULTS = {
    "a mistyped member": (
        *("client", "iLength := Frames.received", "iLength := Frames.«recieved»"),
        "ST_Ck10_Frames has no member recieved: is it received?",
    ),
    "a mistyped variable": (
        *("client", "iTry < Retries", "iTry < «Retrys»"),
        "nothing is called Retrys: is it Retries?",
    ),
    "a wrong type": ("client", "uiReason := Frames.error", "«iTry» := Frames.error", "INT := UINT: convert it"),
    "a wrong argument": (
        *("client", "iLength := Frames.received", "«iLenght» := Frames.received"),
        "F_Ck10_ParseRtuReadRegisters has no parameter iLenght: is it iLength?",
    ),
    "an arrow for an input": (
        *("client", "iLength := Frames.received", "«iLength» => Frames.received"),
        "iLength is an input of F_Ck10_ParseRtuReadRegisters",
    ),
    "a missing argument": (
        *(
            "client",
            "{access.parse}({access.answered}, aFrame := Frames.frame, iLength := Frames.received)",
        ),
        *("{access.«parse»}({access.answered}, aFrame := Frames.frame)",),
        "F_Ck10_ParseRtuReadRegisters wants iLength as well",
    ),
    "an argument of another type": (
        *("client", "aFrame := Frames.frame, iLength := Frames.received"),
        *("«aFrame» := Frames.error, iLength := Frames.received",),
        "aFrame of F_Ck10_ParseRtuReadRegisters is an array, not UINT",
    ),
    "what is compared with itself": (
        *("client", "Frames.answered <> udiRequest", "udiRequest «<>» udiRequest"),
        "both sides of <> are the same",
    ),
    "two numbers": ("client", "Frames.error <> 0", "1 «<>» 0", "both sides of <> are numbers"),
    "a number that does not fit": (
        *("client", "    uiReason := 0;", "    uiReason := «70000»;"),
        "70000 is not a valid UINT, which has 0..65535",
    ),
    "a time for a number": ("client", "iTry := 0;", "iTry := «T#5s»;", "T#5s is not a number"),
    "a missing THEN": (
        *("client", "IF iStep = STEP_IDLE THEN\n    IF Axis.state", "IF iStep = STEP_IDLE\n    «IF» Axis.state"),
        "expected THEN, not IF",
    ),
    "a missing END_IF": (
        *(
            "client",
            "IF Axis.urgent > 0 THEN\n    Axis.urgent := Axis.urgent - 1;\nEND_IF;",
        ),
        *("«IF» Axis.urgent > 0 THEN\n    Axis.urgent := Axis.urgent - 1;",),
        "END_IF is missing before line",
    ),
    "a comment without a statement": (
        *("client", "        iStep := STEP_ASK;\n    ELSIF", "        iStep := STEP_ASK;\n    «// lost»\n    ELSIF"),
        "a comment stands in front of a statement",
    ),
    "a missing END_REGION": (
        *("line", "REGION Start\n    {Edges};\nEND_REGION", "«REGION» Start\n    {Edges};"),
        "END_REGION is missing before line",
    ),
    "an unknown slot": (
        *("client", "{has.several} THEN\n        {Build", "{has.«severl»} THEN\n        {Build"),
        "has has no severl: is it several?",
    ),
    "an unknown action": ("client", "{Take(single)}", "{«Taek»(single)}", "no action is called Taek: is it Take?"),
    "an action without its argument": ("client", "{Take(single)}", "{«Take»}", "Take has one argument"),
    "an unknown type": ("client", "iTry : INT;", "iTry : «INTEGER»;", "INTEGER is not a type: is it INT?"),
    "a type of 64 bits": (
        "client",
        "iTry : INT;",
        "iTry : «LINT»;",
        "not every controller has LINT: take the type from",
    ),
    "an unknown reason": (
        *("client", "uiReason <> Reason.exception", "uiReason <> Reason.«refused»"),
        "Reason has no refused; there is alarm, damaged, exception,",
    ),
    "a truth for a number": ("client", "iStep := STEP_WAIT", "«iStep» := TRUE", "INT := BOOL: convert it"),
    "a number for a truth": ("client", "IF Waited THEN", "IF «iTry» THEN", "this is INT, where a BOOL is wanted"),
    "a constant that is assigned": ("client", "iTry := 0;", "«STEP_IDLE» := 0;", "STEP_IDLE cannot be assigned"),
    "a variable that nothing uses": (
        *("client", "iTry : INT;", "iTry : INT;\n    «iUnused» : INT;"),
        "nothing uses iUnused",
    ),
    "an equals sign": ("client", "iTry := 0;", "iTry «=» 0;", "expected :=, not ="),
    "an index of what is not an array": (
        "client",
        "aWordsAnswered[iAt]",
        "udiTaken«[»iAt]",
        "udiTaken is not an array",
    ),
    "another character": ("client", "iTry := 0;", "iTry := 0 «?»;", "'?' is nothing of Structured Text"),
    "another section": ("client", "VAR_OUTPUT", "«VAR_TEMP»", "VAR_TEMP is not a section: there is VAR_INPUT"),
    "a member of a number": ("exchange", "iTry := 0;", "iTry.«Q» := 0;", "iTry has no members"),
    "a call of what is not a function": (
        *("exchange", "{build}({asked}, iLength => SendLength)", "{«asked»}({asked}, iLength => SendLength)"),
        "asked is not a function",
    ),
    "a timer without its time": (
        *("exchange", "fbTimeout(IN := iState = STEP_WAIT, PT := Timeout)", "«fbTimeout»(IN := iState = STEP_WAIT)"),
        "only a timer is called as a statement, with IN and PT",
    ),
    "a list that is not declarations": (
        *("exchange", "    {inputs};", "    {«build»};"),
        "this slot is not a list of declarations",
    ),
    "no statements": ("exchange", "{taken};", "{«build»};", "build has no statements"),
    "two types": ("exchange", "iTry < Retries", "iTry < «Failed»", "INT < BOOL: convert one of them"),
    "a conversion of another type": ("exchange", "iTry + 1", "«UINT_TO_INT»(iTry) + 1", "the value is INT"),
    "what follows the end": ("exchange", "END_FUNCTION_BLOCK", "END_FUNCTION_BLOCK «x»", "expected end, not x"),
    "an action in the place of branches that is not an IF": (
        *("line", "    IF {Guards};", "    IF {«Tail»};"),
        "Tail is not a single IF without ELSE",
    ),
    "a member that an axis does not have": (
        *("moving", "udiClaim <> Axis.claims", "udiClaim <> Axis.«claim»"),
        "ST_Ck10_Axis has no member claim: is it claims?",
    ),
    "an action of another block": ("stopping", "{Succeed};", "{«GoOut»};", "no action is called GoOut"),
    "a fault in an action of what is extended": (
        *("judging", "{answer.station}", "{answer.«stations»}"),
        "answer has no stations: is it station?",
    ),
}


@pytest.fixture(autouse=True)
def _fresh_sources() -> Iterator[None]:
    expansion.source.cache_clear()
    yield
    expansion.source.cache_clear()


def refused(monkeypatch: pytest.MonkeyPatch, name: str, old: str, new: str) -> tuple[SourceError, str]:
    """The error for a source with a fault, and the place of the fault."""
    content = templates.text(f"targets/controllers/sources/{name}.st")
    assert old in content
    begin = content.index(old) + new.index("«")
    planted = content.replace(old, new, 1).replace("«", "").replace("»", "")
    before = planted[:begin]
    line, column = before.count("\n") + 1, begin - (before.rfind("\n") + 1) + 1

    def text(path: str) -> str:
        return planted if path.endswith(f"/{name}.st") else templates.text(path)

    monkeypatch.setattr(expansion, "text", text)
    with pytest.raises(SourceError) as error:
        backend.source.__wrapped__(newest(SPECS, "ck10"))  # type: ignore[attr-defined]
    return error.value, f"{name}.st:{line}:{column}: "


@pytest.mark.proof(14)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_refused_with_its_place(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    name, old, new, message = FAULTS[fault]
    error, place = refused(monkeypatch, name, old, new)
    assert str(error).startswith(place + message)


def test_the_mark_stands_below_the_word_and_the_actions_say_from_where(monkeypatch: pytest.MonkeyPatch) -> None:
    error, _ = refused(
        monkeypatch,
        "client",
        "uiReason := Reason.request;\n    END_IF;\nEND_ACTION",
        "uiReason := Reason.«reqest»;\n    END_IF;\nEND_ACTION",
    )
    _, line, mark, *trace = str(error).splitlines()
    assert line[mark.index("^") : mark.rindex("^") + 1] == "reqest"
    assert [entry.partition(", ")[0] for entry in trace] == ["  in Build(reading)"]


def test_a_fault_passes_from_one_process_to_another(monkeypatch: pytest.MonkeyPatch) -> None:
    error, _ = refused(monkeypatch, "client", "iTry := 0;", "iTry := «T#5s»;")
    assert str(pickle.loads(pickle.dumps(error))) == str(error)


def test_actions_and_properties_of_sources_are_used() -> None:
    folder = PACKAGE / "targets" / "controllers"
    sources = {path: path.read_text("utf-8") for path in sorted(folder.rglob("*.st"))}
    python = "\n".join(path.read_text("utf-8") for path in sorted(folder.rglob("*.py")))
    everything = "\n".join(sources.values())
    names = {name for text in sources.values() for name in re.findall(r"(?:ACTION|PROPERTY) (\w+)", text)}
    assert len(names) > 40
    unused = {
        name
        for name in names
        if f'"{name}"' not in python and not re.search(rf"(?<!ACTION )(?<!PROPERTY )\b{name}\b", everything)
    }
    assert unused == set()
