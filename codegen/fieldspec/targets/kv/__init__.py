"""Word maps and device comments for controllers whose memory is words: Keyence KV, and others by the same map."""
