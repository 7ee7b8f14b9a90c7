/* host/text.h: messages of C, put together part by part into a text of a given size. */
#ifndef GSMBP_HOST_TEXT_H
#define GSMBP_HOST_TEXT_H

#include <stdarg.h>
#include <stdio.h>

typedef struct
{
  char *text;
  int size, length;
} gs_writer;

/* one more part; what is beyond the size is cut off */
static inline void
gs_put (gs_writer *w, const char *format, ...)
{
  va_list values;
  va_start (values, format);
  if (w->length < w->size - 1)
    w->length += vsnprintf (w->text + w->length, (size_t)(w->size - w->length), format, values);
  va_end (values);
}

#endif
