; 2:1: error: G81 needs Z [cycle-word-missing]
G81 X1 R1 F100
