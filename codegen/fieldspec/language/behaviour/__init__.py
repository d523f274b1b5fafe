"""The behaviour of a device over time: the section `behaviour` of a spec. It is not in the model: no output depends on
it.
"""
