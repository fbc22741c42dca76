sphere { "origin"*2, 1 }
#declare A = 1 + "one";
