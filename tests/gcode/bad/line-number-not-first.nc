; 2:4: error: a line number (N) must be the first word [line-number-not-first]
X1 N5
