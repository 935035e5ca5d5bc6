; 2:1: error: there is no parameter #-1 [parameter-range]
X#-1
