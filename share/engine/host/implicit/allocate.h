/* Memory of what is counted by signed numbers. */
#ifndef GS_HOST_ALLOCATE_H
#define GS_HOST_ALLOCATE_H
#include <stddef.h>
#include <stdlib.h>

/* Return room for N things of SIZE bytes each, all 0, which the caller frees; a null pointer: no
   memory. */
static inline void *
gs_allocate (ptrdiff_t n, size_t size)
{
  return calloc ((size_t) n, size);
}
#endif
