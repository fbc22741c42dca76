sphere { 0, 1 }
/* a /* b */
