"""What outputs refuse that are not for controllers, in the words of their documentation."""

from __future__ import annotations

RULES = {
    "wireshark_frames_unescaped": """The frames that a dissector shows have the bytes that are sent.

Why: the dissector does not undo escapes, so it would show other values than the frame has.

Example: a link with `escape: {method: slip}`.

Cure: Exclude the output for the device (`--to`).
""",
}
