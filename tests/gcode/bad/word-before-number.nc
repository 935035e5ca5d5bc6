; 2:1: error: this number has no letter before it [letter-expected]
12 X1
