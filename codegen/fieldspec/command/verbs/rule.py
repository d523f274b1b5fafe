"""`fieldspec rule`: what a rule demands, why, an example, and the fix."""

from __future__ import annotations

import argparse

from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import unknown
from fieldspec.command.rendering.blocks import Line, Table


def run(arguments: argparse.Namespace) -> int:
    """Prints a rule, or a list of all rules. Raises UsageError."""
    from fieldspec.command.packages.plugin_loading import load_checks
    from fieldspec.command.rules import all_rules, change_rules, installed_rules

    load_checks()
    findings, changes = (*all_rules(), *installed_rules()), change_rules()
    if arguments.code is None:
        print_blocks(
            [
                Table(("rule", "what holds"), tuple((rule.code, rule.what) for rule in findings)),
                Line(""),
                Table(
                    ("change", "class", "what happened"),
                    tuple((rule.code, ", ".join(rule.classes), rule.what) for rule in changes),
                ),
            ]
        )
        return 0
    rules = {rule.code: rule for rule in (*findings, *changes)}
    if arguments.code not in rules:
        raise unknown("rule", arguments.code, rules)
    rule = rules[arguments.code]
    classes = (f"Class: {', '.join(rule.classes)}",) if rule.classes else ()
    texts = (rule.what, *classes, f"Why: {rule.why}", f"Example: {rule.example}", f"Fix: {rule.fix}")
    print_blocks([Line(rule.code, "bold"), *(line for text in texts for line in (Line(""), Line(text)))])
    return 0
