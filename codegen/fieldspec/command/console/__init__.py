"""What verbs ask and print: options, wrong use, streams and the terminal."""
