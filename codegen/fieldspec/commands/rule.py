"""`fieldspec rule`: what a rule says, why, an example, and the cure."""

from __future__ import annotations

import argparse

from fieldspec.commands.output import print_table
from fieldspec.commands.usage import unknown


def run(arguments: argparse.Namespace) -> int:
    """Prints one rule, or a list of all."""
    from fieldspec.rules import all_rules

    rules = {rule.code: rule for rule in all_rules()}
    if arguments.code is None:
        print_table(["rule", "what holds"], [[rule.code, rule.what] for rule in rules.values()])
        return 0
    if arguments.code not in rules:
        raise unknown("rule", arguments.code, rules)
    rule = rules[arguments.code]
    print(f"{rule.code}\n\n{rule.what}\n\nWhy: {rule.why}\n\nExample: {rule.example}\n\nCure: {rule.cure}")
    return 0
