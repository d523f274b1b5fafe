"""YAML -> node tree -> tree of one version -> model. A user's mistake is a finding, never an exception."""
