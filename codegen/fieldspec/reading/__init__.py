"""YAML -> node tree -> one version of it -> the model. A user's slip is a finding, never an exception."""
