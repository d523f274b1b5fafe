"""Talks to a real device: requests with retries, reads in blocks, guarded writes. It opens nothing by itself."""
