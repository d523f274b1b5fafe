"""fieldspec: a compiler from declarative protocol specs to code."""

__version__ = "0.1.0"
