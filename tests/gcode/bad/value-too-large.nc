; 2:1: error: the value of X is beyond any machine [value-too-large]
X1000000000000000
