; 2:1: error: sqrt of this value does not exist [function-range]
Xsqrt[-1]
