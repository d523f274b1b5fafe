"""The module that explains frames of a version: the data of the explainer, and its functions."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.explainer.device import explainer_data
from fieldspec.targets.js.module import about
from fieldspec.targets.js.text import PURE, comment

_TYPES = """\
import type { Explainer } from "../runtime/explain/explainer.js";

/** The explanation of a frame. Throws for a text that is not a frame or unknown options; no bytes make it throw. */
export declare const explain: Explainer["explain"];
/** The explanations of the lines of a log; `error` says why a line is not a frame. */
export declare const explainLog: Explainer["explainLog"];
"""


def explainer_files(layout: DeviceLayout, stem: str) -> dict[str, str]:
    """The module and its types; `stem` is their path without the ending."""
    head = comment(about(layout))
    data = explainer_data(layout)
    code = [
        *head,
        'import { explainer } from "../runtime/explain/explainer.js";',
        "",
        f"export const {{ explain, explainLog }} = {PURE} explainer({data});",
        "",
    ]
    return {f"{stem}.js": "\n".join(code), f"{stem}.d.ts": "\n".join([*head, _TYPES])}
