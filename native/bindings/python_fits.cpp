// SPDX-License-Identifier: GPL-3.0-or-later
// Python's pyconfig.h describes the system on which Python was built, but modules for other systems are also compiled
// with it. This file does not compile if pyconfig.h does not fit the system of the module.
#include <Python.h>

#ifndef _WIN32  // Windows has its own pyconfig.h
#include <pthread.h>
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <ctime>

static_assert(SIZEOF_INT == sizeof(int) && SIZEOF_LONG == sizeof(long) && SIZEOF_LONG_LONG == sizeof(long long));
static_assert(SIZEOF_VOID_P == sizeof(void*) && SIZEOF_SIZE_T == sizeof(std::size_t));
static_assert(SIZEOF_UINTPTR_T == sizeof(std::uintptr_t) && SIZEOF__BOOL == sizeof(bool));
static_assert(SIZEOF_WCHAR_T == sizeof(wchar_t) && SIZEOF_TIME_T == sizeof(std::time_t));
static_assert(SIZEOF_OFF_T == sizeof(off_t) && SIZEOF_PID_T == sizeof(pid_t));
static_assert(SIZEOF_PTHREAD_T == sizeof(pthread_t));
#if defined(WORDS_BIGENDIAN) || defined(HAVE_ALIGNED_REQUIRED) || defined(HAVE_USABLE_WCHAR_T) || defined(Py_DEBUG)
#error "the headers are of a Python for another kind of system"
#endif
#endif
