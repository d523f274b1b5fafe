"""All monitors over one record, each for rules of its own; see docs/trust.md for what they judge.

Rule 14, two instances of one block, and rule 19, blocks that read, have no monitor of their own: an instance that
changes another breaks rules 3 to 8 there, which episodes with two instances of a move and of a stop show; a block that
reads and aborts another breaks rule 20, and one that delays a stop rule 22.
"""

from __future__ import annotations

from device_models.done_rules import DONE_RULES
from device_models.history import History, Violation
from device_models.motion_rules import MOTION_RULES
from device_models.output_rules import OUTPUT_RULES
from device_models.stop_rules import STOP_RULES

MONITORS = (*OUTPUT_RULES, *MOTION_RULES, *DONE_RULES, *STOP_RULES)


def violations(history: History) -> list[Violation]:
    """All that breaks a rule, in the order of the scans."""
    return sorted((item for monitor in MONITORS for item in monitor(history)), key=lambda item: (item.scan, item.rule))
