"""What a made-up company adds to fieldspec."""
