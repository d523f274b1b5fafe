"""What `live` does with a real device: connects, prints, writes, and transfers lists of values."""
