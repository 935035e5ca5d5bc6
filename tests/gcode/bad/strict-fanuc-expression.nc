; strict: 2:5: error: this number has no letter before it [letter-expected]
#1=1+2
M2
