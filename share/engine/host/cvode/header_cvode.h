/* CVODE of SUNDIALS 6 and 7. */
#ifndef GS_HOST_HEADER_CVODE_H
#define GS_HOST_HEADER_CVODE_H
#include <cvode/cvode.h>
#include <sundials/sundials_version.h>

#if SUNDIALS_VERSION_MAJOR == 6
# define SUN_COMM_NULL NULL
#elif SUNDIALS_VERSION_MAJOR != 7
# error "method cvode is written for SUNDIALS 6 and 7 (Debian: libsundials-dev)"
#endif
#endif
