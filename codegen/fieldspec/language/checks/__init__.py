"""What holds in a good spec. One file a check, named by what holds when it passes; `table` lists them."""
