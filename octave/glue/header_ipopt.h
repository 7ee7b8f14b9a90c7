// Ipopt's interface in C; the folder has had two names.
#pragma once
#if __has_include(<coin-or/IpStdCInterface.h>)
# include <coin-or/IpStdCInterface.h>
#else
# include <coin/IpStdCInterface.h>
#endif
