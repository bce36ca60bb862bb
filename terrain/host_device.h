// A law is written once and compiled for the host and, by nvcc, for the device.
#pragma once

#ifdef __CUDACC__
#define SOFTSOIL_HD __host__ __device__
#else
#define SOFTSOIL_HD
#endif
