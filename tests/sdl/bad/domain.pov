#declare A = sqrt(-1);
#declare B = ln(0);
#declare C = 1/0;
#declare D = atan2(0, 0);
