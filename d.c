#include <stdio.h>
#include <stdlib.h>
#include "POUS.h"
TIME __CURRENT_TIME; BOOL __DEBUG;
#include "POUS.c"
int main(){static PRG p; PRG_init__(&p,0); PRG_body__(&p); PRG_body__(&p); printf("%d %d %d\n", p.L.value.ISTATE, p.L.value.AWORDS.table[0], p.L.value.AWORDS.table[1]);}
