"""SCL as Structured Text, for parsers and compilers that know the standard alone."""

from __future__ import annotations

import re


def of_siemens(text: str) -> str:
    """SCL as Structured Text: without the marks of names, and without the lines that only Siemens has."""
    text = re.sub(r'(?<!\w)#(?=["A-Za-z_])|"', "", text)
    text = re.sub(r"^\s*(BEGIN|REGION .*|END_REGION|VERSION : .*|\{ S7_.*)$", "", text, flags=re.MULTILINE)
    return re.sub(r"^(TYPE \w+)$", r"\1 :", text, flags=re.MULTILINE)
