; 3:12: error: cannot read 'and[1]' [unreadable-text]
#1=1
o1 if [#1] AND [1]
G0 X1
o1 endif
M2
