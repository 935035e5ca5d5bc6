; 2:2: error: this bracket is not closed [bracket-unclosed]
X[1+2
