"""What reading values and records is, as operations of a closed set, and the interpreter that runs them."""
