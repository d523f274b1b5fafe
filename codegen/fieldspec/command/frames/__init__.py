"""What verbs about frames share: their options, and the values that an encoder computes."""
