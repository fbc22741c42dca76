#declare
#declare A
#declare B =
#declare C = ;
sphere { 0, 1 }
