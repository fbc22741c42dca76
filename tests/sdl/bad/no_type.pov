#declare A = color "red";
#declare B = <1, 2, 3> < 2;
#declare C = ("a" ? 1 : 2);
#declare D = (<1,2> = 1);
