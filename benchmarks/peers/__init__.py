"""What the generated code is measured against: the same work as people write it by hand, and with other tools."""
