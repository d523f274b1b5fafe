"""The names of what is in the specs' folder."""

from __future__ import annotations

PROTOCOLS = "protocols"
MAIN = "device.yaml"
VERSIONS = "versions"
