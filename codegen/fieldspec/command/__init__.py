"""The command line: the compiler as a line of functions, what verbs print, and the verbs. Only verbs and what they
share read or write files, or print.
"""

from __future__ import annotations

from importlib import import_module

from fieldspec.language.model.codecs import provide

provide(lambda: import_module("fieldspec.command.packages.codec_loading").load_codecs())
