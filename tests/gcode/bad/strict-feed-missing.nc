; strict: 2:1: error: G1 without a feed: no F was given in this feed mode (G93, G94 and G95 need an F each) [feed-missing]
G1 X1
