; strict: 3:1: error: these axis words have no motion code like G0 or G1 to use them [axes-without-motion]
F1
X1 Y2
