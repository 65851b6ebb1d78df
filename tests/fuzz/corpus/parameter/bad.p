world a
maze b
