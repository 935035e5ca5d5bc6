; 3:1: error: subprograms call one another too deeply [call-depth]
o1 sub
o1 call
o1 endsub
o1 call
