; strict: 2:7: error: G0 and G1 exclude each other; the last one counts [codes-exclude]
F1 G0 G1 X1
