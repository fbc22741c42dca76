sphere { 0, 1 } // café is fine here
sphere { café, 1 }
