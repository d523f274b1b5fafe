"""Expressions for wording that sounds translated, by name, with a plainer form in brackets."""

from __future__ import annotations

import re
from collections.abc import Iterator

PATTERNS = {
    "nobody as the subject (name the actor)": r"\b[Nn]obody\b",
    "'What is …' as the subject (begin with the noun)": (
        r"(?:^|[.:;] )What (?:is|are|was|were|has|have|had|no|nobody|nothing|a|an|the|it|they|only|each|every)\b"
        r"(?![^.]*\?)"
    ),
    "what nobody, what no X (use the noun)": r"\bwhat (?:nobody|nothing|no \w+)\b",
    "tell (identify, show, distinguish, report)": (
        r"\b(?:tells? (?:which|what|whether|apart|where|of|nothing|the (?:version|length|direction|type))"
        r"|told (?:from|apart|by|what)|is to tell)\b"
    ),
    "there are as advice (choose from)": r"\bhelp: there (?:is|are)\b",
    "a rare word": r"\b(?:anew|afresh|mend(?:ed|s)?|for good|at last|whoever|lent|outlasts?|by lot|in turns)\b",
    "behind (after)": r"\bbehind\b(?!-| (?:a|the) (?:network|gateway|proxy|firewall|scenes))",
    "is no X (is not a X)": (
        r"(?<![Tt]here )(?<!where there )\b(?:is|are|was|were) (?:no (?!longer|more)\w+|none\b(?!,|$))"
    ),
    "the print (the manual, the printed value)": r"\b(?:the|in|a|whose) print\b(?! statement)",
    "speaks (uses)": r"\bspeaks? (?:of|against|telegram|Modbus|for)\b",
    "so many, as many as (the number)": r"\bso many\b|\bas many (?:bytes|words|elements|digits|values)?\b",
    "nothing but, no X but (only)": r"\b(?:nothing|none|no \w+|nobody)\b[^.;,|]{0,30}\bbut\b",
    "one a word (one per word)": (
        r"\b(?:one|two|three|(?<!-)\d+) (?:\w+ )?an? (?:word|field|byte|file|frame|core|record|row)\b"
        r"|\ba (?:file|word|field|byte) each\b"
    ),
    "is looked at, is asked for (check, request)": (
        r"\b(?:is|are|was|were|be|been) (?:looked|asked|waited) (?:at|for|of)\b|\bwait(?:s|ed)? on\b"
    ),
    "goes on, passed over (continues, is ignored)": r"\b(?:goes|went) on\b|\b(?:is|are) passed over\b",
    "another X than, has another (a different X)": r"\banother (?:one|\w+) than\b|\b(?:has|have) another \w+",
    "taken over, taken for (copied, mistaken for)": r"\btaken (?:over|for (?:a|an|the|that|those|whole))\b",
    "a fronted Of (subject first)": r"(?:^|[.;] )Of (?!the same|course)\w+",
    "those of (repeat the noun)": r"\bthose of\b|\bthat of (?:the|a|an|its) (?:one|others?|first|last|second)\b",
    "stands beside, rests on (is next to, cites)": (
        r"\bstands? (?:beside|behind|below|above|once)\b|\brests? on (?:nothing|what)\b"
    ),
}


def prose(text: str) -> Iterator[tuple[int, str]]:
    """The lines of a page with their numbers, without blocks of code; a word in code is one letter."""
    is_code = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("```"):
            is_code = not is_code
        elif not is_code:
            yield number, re.sub(r"`[^`]*`", "`x`", line)


def hits(text: str) -> Iterator[str]:
    """`LINE: NAME: WORDS` for everything in a page that an expression finds."""
    for number, line in prose(text):
        for name, pattern in PATTERNS.items():
            for match in re.finditer(pattern, line):
                yield f"{number}: {name}: {match[0].strip()}"
