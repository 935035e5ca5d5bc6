; strict: 2:1: error: G1 without a feed: no F was ever given [feed-missing]
G1 X1
