"""The protocols of a made-up company, as specs."""
