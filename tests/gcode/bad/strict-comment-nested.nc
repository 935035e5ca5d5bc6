; strict: 2:7: error: a parenthesis inside a comment; the comment is taken to end at the matching one [comment-nested]
G0 X1 (a (b) c)
