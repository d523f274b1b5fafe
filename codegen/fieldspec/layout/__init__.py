"""Every number that an output prints: offsets, sizes, masks, addresses. Built from a checked device; cannot fail."""
