"""The basis of all other packages: data classes, caches, files and places in them, names, cells."""
