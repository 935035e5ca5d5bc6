; strict: 2:9: error: G53 is absolute; G91 is passed over [g53-incremental]
G91 G53 G0 X1
M2
