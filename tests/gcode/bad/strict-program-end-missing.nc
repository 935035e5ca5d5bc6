; strict: 2:1: error: the program ends without M2, M30 or a closing '%' [program-end-missing]
G0 X1
