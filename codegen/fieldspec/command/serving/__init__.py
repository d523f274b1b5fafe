"""What runs until somebody ends it: the server of the Model Context Protocol, and the view of a simulation."""
