"""Every number that an output prints: offsets, sizes, masks, addresses. A device without findings has a layout."""
