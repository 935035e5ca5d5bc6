; strict: 2:5: error: O1: subprograms with M98 and M99 and subroutines with call and endsub do not mix [call-forms]
M98 P1
M2
o1 sub
o1 endsub
