"""The numbers that outputs print: offsets, sizes, masks, addresses. A device without findings has a layout."""
