; 2:1: error: the endif that belongs to this is missing [block-end-missing]
o1 if [0]
X1
