"""What a device is, in frozen and complete dataclasses. One kind of object a file."""
