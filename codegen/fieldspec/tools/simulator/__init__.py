"""A simulated device: it answers the requests of a spec, and does what the behaviour of the spec says."""
