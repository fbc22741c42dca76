#declare S = "abc;
sphere { 0, 1 }
