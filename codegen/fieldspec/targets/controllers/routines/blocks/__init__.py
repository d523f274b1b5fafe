"""Function blocks for what people do with a device: made from its tasks, tables, groups of registers and messages."""
