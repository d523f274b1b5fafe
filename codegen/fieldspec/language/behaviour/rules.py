"""The documentation of the rules of behaviours: what must hold, why, an example, and the fix."""

from __future__ import annotations

RULES = {
    "behaviour_clear": """Every entry of a behaviour, and every action of its rules, is of one kind and has only the
keys of this kind. No two entries have the same name.

Why: an entry with two kinds would have two effects, and a key of a different kind would have no effect.

Example: `{name: servo, machine: [off, on], show: servo_state}`.

Fix: Write two entries, or remove the key.
""",
    "behaviour_resolves": """Every name in a behaviour exists: signals, members, states, events, messages, limits,
tables and collections.

Why: a rule that waits for a signal that does not exist silently never acts.

Example: `if: {state/servo: running}` for a machine with the states `off` and `on`.

Fix: Correct the name. If only some versions have the name, give the entry `since` or `until`.
""",
    "behaviour_stated": """Every entry of a behaviour cites the manual or a standard, or states an assumption.

Why: a simulator that invents behaviour is worse than no simulator. The users of a simulator can list its assumptions.

Example: a rule that starts homing, without `source`, `standard` or `assumed`.

Fix: Add the `source`; if the manual does not print it, state the assumption of the simulator under `assumed`. A
statement of the manual that the simulator does not implement is `unmodelled`, and cites the manual too.
""",
}
