/* NLopt's interface in C. */
#ifndef GS_HOST_HEADER_NLOPT_H
#define GS_HOST_HEADER_NLOPT_H
#include <nlopt.h>
#endif
