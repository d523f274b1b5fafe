"""What a device is, in frozen and complete dataclasses. One noun a file."""
