"""A manual is stated in one form by which others can find it: as a text, a document with pages, or a page on the web.

Why: a source is a line, a page or a section of exactly this manual. A hash, or the day on which a page was read,
distinguishes it from other editions, in which the source cannot be verified.

Example: a manual with a `file` and neither `lines` nor `pages`, or with `lines` and a `url`.

Fix: State `file`, `sha256` and `lines` for a text; `file`, `sha256` and `pages` for a document without a text, such as
a scanned PDF; or `url` and `read` for a page on the web.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, enumeration, finding
from fieldspec.language.model.device import Device

_FORMS = (("file", "sha256", "lines"), ("file", "sha256", "pages"), ("url", "read"))
_HELP = (
    "a text has `file`, `sha256` and `lines`, a document `file`, `sha256` and `pages`, "
    "a page on the web `url` and `read`"
)


def manual_identified(device: Device) -> Findings:
    keys = {key for form in _FORMS for key in form if getattr(device.manual, key)}
    if keys in map(set, _FORMS):
        return
    form = max(_FORMS, key=lambda form: len(keys.intersection(form)))
    missing = [f"`{key}`" for key in form if key not in keys]
    surplus = [f"`{key}`" for key in sorted(keys.difference(form))]
    text = f"has no {enumeration(missing)}" if missing else f"has {enumeration(surplus)} beside `{form[-1]}`"
    yield finding(device.place, "manual", f"the manual of {device.id} {text}", _HELP)
