#declare x = 3;
#declare sin = 4;
#declare 5 = 6;
