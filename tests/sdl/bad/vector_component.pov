#declare V = <1, x, 3>;
#declare W = <1, 2, 3, 4, 5, 6>;
#declare U = <1>;
#declare T = <1, 2;
