"""The documentation of the rules of behaviours: what must hold, why, an example, and the cure."""

from __future__ import annotations

RULES = {
    "behaviour_clear": """Every part of a behaviour, and every action of its rules, is of one kind and has the keys of
this kind alone. No two parts have the same name.

Why: a part with two kinds would have two effects, and a key that its kind does not have would have none.

Example: `{name: servo, machine: [off, on], show: servo_state}`.

Cure: Write two parts, or remove the key.
""",
    "behaviour_resolves": """Every name in a behaviour exists: signals, members, states, events, messages, limits,
tables and collections.

Why: a rule that waits for a signal that does not exist silently never acts.

Example: `if: {state/servo: running}` for a machine with the states `off` and `on`.

Cure: Correct the name. If only some versions have it, give the part `since` or `until`.
""",
    "behaviour_stated": """Every part of a behaviour cites the manual, or a standard, or says what is assumed.

Why: a simulator that invents what a device does is worse than none. Assumptions are listed for its users.

Example: a rule that starts homing, without `source`, `standard` or `assumed`.

Cure: Add the `source`; if the manual does not print it, say under `assumed` what the simulator assumes. What the manual
states and the simulator does not do is `unmodelled`, and cites the manual too.
""",
}
