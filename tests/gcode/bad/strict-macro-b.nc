; strict: 2:1: error: expected a number after I [number-expected]
IF[1EQ1]GOTO10
M2
