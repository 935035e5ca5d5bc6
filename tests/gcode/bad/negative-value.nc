; 2:1: error: F must not be negative [negative-value]
F-1
