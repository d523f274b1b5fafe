"""What a device does over time: the section `behaviour` of a spec. It is not in the model: no output depends on it."""
