"""What every other room stands on: classes of data, caches, files and places in them, names, cells."""
