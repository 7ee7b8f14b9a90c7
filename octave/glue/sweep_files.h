/* A sweep on disk: the job, a list of named arrays; chunks of runs, each in a file of its own,
   whole or not there; the table of all of them in HDF5.  Plain C: Octave (gsmbp_sweep_files.cc) and
   the program of a sweep (sweep_program.cc) write and read the same files. */
#ifndef GSMBP_GLUE_SWEEP_FILES_H
#define GSMBP_GLUE_SWEEP_FILES_H
#ifdef __cplusplus
extern "C" {
#endif

#define GS_WHY 600   /* room for what went wrong */

#define GS_PATH 4400  /* room for the name of a part */

/* A file appears complete or not at all: it is written as PART, a name next to TARGET that is this
   process's, and put in place, flushed to the disk.  A symbolic link is followed.  1 and WHY if
   TARGET is there and no regular file, or cannot be written; no part is left then. */
int gs_beside (const char *target, char *part, char *why);
int gs_put_part (const char *part, const char *target, char *why);
/* the parts in FOLDER of processes that are no more */
void gs_remove_parts (const char *folder);

/* the job: records "NAME TYPE COUNT\n", the bytes, "\n"; TYPE d: doubles, s: characters */
typedef struct
{
  char name[40];
  char type;
  long long count;
  void *data;
} gs_record;

typedef struct
{
  int count;
  gs_record *records;
} gs_job;

int gs_read_job (const char *file, gs_job *job, char *why);
void gs_free_job (gs_job *job);
/* a record by its name; it is not there: a null pointer, COUNT 0 */
const double *gs_numbers (const gs_job *job, const char *name, long long *count);
const char *gs_text (const gs_job *job, const char *name, long long *count);
double gs_number (const gs_job *job, const char *name, double otherwise);

/* runs FIRST (from 0) to FIRST + N - 1; a row of COLUMNS numbers for each: ok, reached, what is
   kept, whole runs; TEXT: lines "RUN<tab>REASON" of those that failed, RUN from 1 on */
typedef struct
{
  long long first, n, columns, length;
  double *values;
  char *text;
} gs_chunk;

/* 0, or WHY says what went wrong */
int gs_write_chunk (const char *folder, const gs_chunk *c, char *why);
/* 0; 1: the file is not whole; WHY */
int gs_read_chunk (const char *folder, const char *name, gs_chunk *c, char *why);
void gs_free_chunk (gs_chunk *c);

/* the names of the files of chunks in FOLDER in the order of the runs, free them by gs_free_list;
   what a write that was killed left behind is taken away if TIDY */
int gs_list_chunks (const char *folder, int tidy, char ***names, int *count, char *why);
void gs_free_list (char **names, int count);

/* all chunks of FOLDER as one table in FILE */
int gs_export_sweep (const gs_job *job, const char *folder, const char *file, char *why);

/* 1 if FILE is the table of that sweep */
int gs_is_table_of (const gs_job *job, const char *file);
/* 1 if all of a table can be read and has its checksums */
int gs_is_whole_table (const char *file);
#ifdef __cplusplus
}
#endif
#endif
