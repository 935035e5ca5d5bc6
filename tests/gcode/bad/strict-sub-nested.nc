; strict: 3:1: error: the subroutine O2 begins where no subroutine may begin [sub-nested]
o1 sub
o2 sub
o2 endsub
o1 endsub
M2
