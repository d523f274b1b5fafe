"""The page on the command line, written from the parser of the arguments."""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from fieldspec.cli import parser

HEAD = """# Command line

<!-- Written by `pytest --accept tests/test_guides.py` from the parser of the command line. Do not edit. -->

`fieldspec VERB` runs a command. The exit codes are 0 for success, 1 for findings, and 2 for wrong use or unreadable
input. In a pipe, the command also ends when the program that reads its output ends, as `head` does; if the command has
no result yet, the exit code is 141.
"""


def page() -> str:
    """The whole page: a table of all verbs, then a section for each."""
    verbs = list(_verbs(parser(), ""))
    lines = [HEAD, "| command | purpose |", "|---|---|"]
    lines += [f"| [`{name}`](#{_anchor(name)}) | {_cell(help)} |" for name, help, _ in verbs if " " not in name]
    for name, help, verb in verbs:
        lines += ["", f"## fieldspec {name}", "", _sentence(verb.description or help), ""]
        lines += ["```text", " ".join(["fieldspec", name, *_usage(verb)]), "```"]
        if rows := list(_rows(verb)):
            lines += ["", "| argument | meaning |", "|---|---|", *rows]
    return "\n".join(lines) + "\n"


def _verbs(parent: argparse.ArgumentParser, before: str) -> Iterator[tuple[str, str, argparse.ArgumentParser]]:
    for action in parent._actions:
        if isinstance(action, argparse._SubParsersAction):
            helps = {choice.dest: choice.help or "" for choice in action._choices_actions}
            for name, verb in action.choices.items():
                yield f"{before}{name}", helps.get(name, ""), verb
                yield from _verbs(verb, f"{before}{name} ")


def _anchor(name: str) -> str:
    return f"fieldspec-{name.replace(' ', '-')}"


def _sentence(text: str) -> str:
    text = " ".join(text.split())
    return text[:1].upper() + text[1:] + ("" if text.endswith((".", "?")) else ".")


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|").replace("<", "&lt;")


def _arguments(verb: argparse.ArgumentParser) -> Iterator[argparse.Action]:
    for action in verb._actions:
        if action.help != argparse.SUPPRESS and not isinstance(
            action, argparse._HelpAction | argparse._SubParsersAction
        ):
            yield action


def _value(action: argparse.Action) -> str:
    """What stands for the value of an argument."""
    if action.nargs == 0:
        return ""
    metavar = action.metavar if isinstance(action.metavar, str) else ""
    choices = [] if metavar or action.choices is None else [*map(str, action.choices)]
    return metavar or ("{" + ",".join(choices) + "}" if choices else action.dest.upper())


def _usage(verb: argparse.ArgumentParser) -> Iterator[str]:
    actions = list(_arguments(verb))
    if any(action.option_strings for action in actions):
        yield "[OPTIONS]"
    for action in actions:
        if not action.option_strings:
            value = _value(action)
            more = " ..." if action.nargs in ("*", "+") else ""
            yield f"[{value}{more}]" if action.nargs in ("?", "*") else f"{value}{more}"
    if any(isinstance(action, argparse._SubParsersAction) for action in verb._actions):
        yield "VERB"


def _rows(verb: argparse.ArgumentParser) -> Iterator[str]:
    for action in _arguments(verb):
        value = _value(action)
        names = [f"{name} {value}".strip() for name in action.option_strings] or [value]
        choices = ", ".join(map(str, action.choices)) if action.choices is not None else ""
        text = _cell((action.help or "") % {**vars(action), "choices": choices, "prog": verb.prog})
        yield f"| {', '.join(f'`{_cell(name)}`' for name in names)} | {text} |"
