; 2:1: error: division by zero [division-by-zero]
X[1/0]
