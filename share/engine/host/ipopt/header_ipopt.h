/* Ipopt's interface in C; the folder has had two names. */
#ifndef GS_HOST_HEADER_IPOPT_H
#define GS_HOST_HEADER_IPOPT_H
#if defined(__has_include)
# if __has_include(<coin-or/IpStdCInterface.h>)
#  include <coin-or/IpStdCInterface.h>
# else
#  include <coin/IpStdCInterface.h>
# endif
#else
# include <coin/IpStdCInterface.h>
#endif
#endif
